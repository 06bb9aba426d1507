// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeLayersInPlane.h"

#include "Data/Arrays.h"
#include "In/ReadPlanarSolid.h"
#include "Layers/PlanarLayers.h"
#include "Out/MixInCells.h"
#include "Out/TransferLayers.h"
#include "Planar/PlanarOutputs.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** Kept points have their coordinates, new ones lie in the plane. */
std::vector<Point> PlacesOf(const PlanarSolid& solid, const PlanarLayeredMesh& made)
{
  std::vector<Point> places;
  for (std::size_t p = 0; p < made.Points.size(); ++p)
  {
    const Id original = made.OriginalPoints[p];
    places.push_back(original == None ? solid.Plane.Lift(made.Points[p]) : solid.Points[original]);
  }
  return places;
}

std::vector<Attributes::Mixture> MixturesOf(const PlanarSolid& solid, const PlanarLayeredMesh& made)
{
  std::vector<Attributes::Mixture> mixtures;
  for (std::size_t p = 0; p < made.Points.size(); ++p)
  {
    const Id original = made.OriginalPoints[p];
    mixtures.push_back(original == None
        ? MixInTriangle(solid.Places, solid.Mesh.Cells[made.CellsOfPoints[p]], made.Points[p])
        : Attributes::Mixture{
            { { original, original, original, original } }, { { 1, 0, 0, 0 } }, false });
  }
  return mixtures;
}

/** The boundary's lines with the data of those before, and the grid's point data. */
vtkSmartPointer<vtkPolyData> MakeBoundary(vtkPolyData* boundary, const PlanarSolid& solid,
  const PlanarLayeredMesh& made, vtkUnstructuredGrid* grid)
{
  std::vector<Segment> segments;
  std::vector<Id> keys;
  for (const PlanarLayeredMesh::BoundaryEdge& edge : made.Boundary)
  {
    if (solid.LineOfEdge[edge.Edge] >= 0)
    {
      segments.push_back(edge.Ends);
      keys.push_back(static_cast<Id>(solid.LineOfEdge[edge.Edge]));
    }
  }
  std::vector<vtkIdType> numbers(made.Points.size(), -1);
  std::vector<vtkIdType> points;
  const auto numberOf = [&](Id p)
  {
    if (numbers[p] < 0)
    {
      numbers[p] = static_cast<vtkIdType>(points.size());
      points.push_back(p);
    }
    return numbers[p];
  };
  vtkNew<vtkCellArray> lines;
  std::vector<vtkIdType> cells;
  for (const std::vector<Id>& line : JoinAlong(segments, keys))
  {
    lines->InsertNextCell(static_cast<int>(line.size()) + 1);
    lines->InsertCellPoint(numberOf(segments[line.front()][0]));
    for (const Id s : line)
    {
      lines->InsertCellPoint(numberOf(segments[s][1]));
    }
    cells.push_back(keys[line.front()]);
  }
  std::vector<Point> places(points.size());
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    grid->GetPoint(points[p], places[p].data());
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->SetPoints(MakePoints(places));
  output->SetLines(lines);
  CopyChosen(grid->GetPointData(), points, output->GetPointData());
  CopyChosen(boundary->GetCellData(), cells, output->GetCellData());
  output->GetFieldData()->ShallowCopy(boundary->GetFieldData());
  return output;
}
} // namespace

Layering MakeLayersInPlane(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const std::vector<std::string>& tags, const LayerParameters& parameters, Monitor& monitor)
{
  const PlanarSolid solid = ReadPlanarSolid(grid, boundary);
  const std::vector<bool> isWall = WallTags(solid.Tags.Names, tags);
  std::vector<Id> wall;
  for (Id edge = 0; edge < 3 * solid.Mesh.NumberOfCells(); ++edge)
  {
    const Id label = solid.Mesh.Segments[edge / 3][edge % 3];
    if (solid.Mesh.Neighbors[edge / 3][edge % 3] == None &&
      label < static_cast<Id>(isWall.size()) && isWall[label])
    {
      wall.push_back(edge);
    }
  }
  LayerParameters inPlane = parameters;
  inPlane.FirstHeight = std::ldexp(parameters.FirstHeight, -solid.Plane.Exponent);
  const PlanarLayeredMesh made =
    MakePlanarLayers(solid.Places, solid.Mesh, wall, solid.Plane, inPlane, monitor);
  Layering result;
  result.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> types;
  AddCells(made.Triangles, VTK_TRIANGLE, cells, types);
  AddCells(made.Quads, VTK_QUAD, cells, types);
  result.Grid->SetPoints(MakePoints(PlacesOf(solid, made)));
  result.Grid->SetCells(types, cells);
  result.Statistics = made.Statistics;
  TransferLayers(grid, MixturesOf(solid, made), made.OriginalCells, made.Layers, result);
  result.Boundary = boundary ? MakeBoundary(boundary, solid, made, result.Grid)
                             : vtkSmartPointer<vtkPolyData>::New();
  WarnOfHeights(result);
  return result;
}
} // namespace vtkInsideOut
