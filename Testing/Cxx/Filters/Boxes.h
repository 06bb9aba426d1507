// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef Boxes_h
#define Boxes_h

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

/** A box of quadrilaterals, normals outward, added to `surface`. */
inline void AddBox(vtkPolyData* surface, double low, double high)
{
  const vtkIdType first = surface->GetNumberOfPoints();
  for (int i = 0; i < 8; ++i)
  {
    surface->GetPoints()->InsertNextPoint(
      i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low);
  }
  const vtkIdType quads[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  for (const auto& quad : quads)
  {
    vtkIdType corners[4];
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = first + quad[k];
    }
    surface->GetPolys()->InsertNextCell(4, corners);
  }
}

inline vtkSmartPointer<vtkPolyData> EmptySurface()
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  surface->SetPoints(points);
  surface->SetPolys(vtkNew<vtkCellArray>());
  return surface;
}

/** Two boxes of side 1 that overlap in a box of side 1/2. */
inline vtkSmartPointer<vtkPolyData> TwoBoxes()
{
  auto surface = EmptySurface();
  AddBox(surface, 0, 1);
  AddBox(surface, 0.5, 1.5);
  return surface;
}

inline double Volume(vtkUnstructuredGrid* grid)
{
  double volume = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    vtkPoints* p = grid->GetCell(c)->GetPoints();
    double x[4][3];
    for (int k = 0; k < 4; ++k)
    {
      p->GetPoint(k, x[k]);
    }
    const auto d = [&](int k, int i) { return x[k][i] - x[0][i]; };
    volume += (d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1)) +
                d(1, 1) * (d(2, 2) * d(3, 0) - d(2, 0) * d(3, 2)) +
                d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0))) /
      6;
  }
  return volume;
}

#endif
