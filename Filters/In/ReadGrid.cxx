// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadGrid.h"

#include "Common/Error.h"
#include "Common/SortUniquely.h"
#include "Data/Arrays.h"
#include "GraphCut/ConnectCells.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** A cell array with this number of components and one tuple per cell; nullptr if there is none. */
vtkDataArray* FindArray(vtkUnstructuredGrid* grid, const char* name, int components)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  const bool fits = array && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == grid->GetNumberOfCells();
  return fits ? array : nullptr;
}

/** The k-th point of a cell, checked. */
Id PointOf(vtkIdType cell, vtkIdList* ids, int k, std::size_t points)
{
  const vtkIdType id = k < ids->GetNumberOfIds() ? ids->GetId(k) : -1;
  if (id < 0 || id >= static_cast<vtkIdType>(points))
  {
    throw Error(ErrorCode::PointOutOfRange,
      "cell " + std::to_string(cell) + " has the point " + std::to_string(id) +
        ", but there are only points 0 to " + std::to_string(static_cast<long>(points) - 1));
  }
  return static_cast<Id>(id);
}

/** The corners of a cell, checked. */
template <class Cell>
Cell CornersOf(vtkIdType cell, vtkIdList* ids, std::size_t points)
{
  Cell corners;
  for (int k = 0; k < static_cast<int>(corners.size()); ++k)
  {
    corners[k] = PointOf(cell, ids, k, points);
    if (std::find(corners.begin(), corners.begin() + k, corners[k]) != corners.begin() + k)
    {
      throw Error(ErrorCode::InvalidParameter,
        "cell " + std::to_string(cell) + " has the point " + std::to_string(corners[k]) + " twice");
    }
  }
  return corners;
}

/** The checked mid-edge nodes; None for a cell of first order. */
std::array<Id, 6> MidpointsOf(vtkIdType cell, int type, vtkIdList* ids, std::size_t points)
{
  std::array<Id, 6> midpoints;
  for (int k = 0; k < 6; ++k)
  {
    midpoints[k] = type == VTK_TETRA ? None : PointOf(cell, ids, 4 + k, points);
  }
  return midpoints;
}

/** @throws Error unless the cell is linear and of the grid's dimension, 2 or 3 */
void CheckCell(vtkIdType id, vtkCell* cell, int dimension)
{
  if (!cell->IsLinear())
  {
    throw Error(ErrorCode::InvalidParameter,
      "cell " + std::to_string(id) + " is curved; only linear cells can be segmented");
  }
  if (cell->GetCellDimension() != dimension || dimension < 2)
  {
    throw Error(ErrorCode::InvalidParameter,
      "cell " + std::to_string(id) + " has dimension " + std::to_string(cell->GetCellDimension()) +
        "; all cells must be volumes, or all polygons");
  }
}
} // namespace

std::string CellName(int type)
{
  // vtkCellTypes provides these names, too, but VTK 9.6 deprecates it.
  const auto cell = vtk::TakeSmartPointer(vtkGenericCell::InstantiateCell(type));
  return cell ? cell->GetClassName() : "UnknownClass";
}

vtkIdType FindOtherCell(vtkUnstructuredGrid* grid)
{
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != VTK_TETRA)
    {
      return c;
    }
  }
  return -1;
}

namespace
{
GridTetrahedra ReadCells(vtkUnstructuredGrid* grid, bool takesLayers)
{
  GridTetrahedra tetrahedra;
  std::vector<vtkIdType> pyramids;
  std::vector<vtkIdType> prisms;
  tetrahedra.Points = ReadPoints(grid, "the grid");
  RequireFinite(tetrahedra.Points);
  vtkNew<vtkIdList> ids;
  vtkNew<vtkGenericCell> other;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    if (type == VTK_TETRA || type == VTK_QUADRATIC_TETRA)
    {
      grid->GetCellPoints(c, ids);
      tetrahedra.Cells.push_back(CornersOf<Tetrahedron>(c, ids, tetrahedra.Points.size()));
      tetrahedra.Midpoints.push_back(MidpointsOf(c, type, ids, tetrahedra.Points.size()));
      tetrahedra.CellIds.push_back(c);
      continue;
    }
    if (takesLayers && type == VTK_PYRAMID)
    {
      grid->GetCellPoints(c, ids);
      tetrahedra.Pyramids.push_back(CornersOf<Pyramid>(c, ids, tetrahedra.Points.size()));
      pyramids.push_back(c);
      continue;
    }
    if (takesLayers && type == VTK_WEDGE)
    {
      grid->GetCellPoints(c, ids);
      tetrahedra.Prisms.push_back(CornersOf<Prism>(c, ids, tetrahedra.Points.size()));
      prisms.push_back(c);
      continue;
    }
    other->SetCellType(type);
    if (other->GetCellDimension() == 3)
    {
      throw Error(ErrorCode::InvalidParameter,
        "cell " + std::to_string(c) + " is a " + CellName(type) + "; volumes must be tetrahedra" +
          (takesLayers ? ", or pyramids and prisms of layers" : ""));
    }
  }
  for (const auto* more : { &pyramids, &prisms })
  {
    tetrahedra.CellIds.insert(tetrahedra.CellIds.end(), more->begin(), more->end());
  }
  return tetrahedra;
}
} // namespace

GridTetrahedra ReadTetrahedraOfAnyOrder(vtkUnstructuredGrid* grid)
{
  return ReadCells(grid, false);
}

GridTetrahedra ReadTetrahedraAndLayers(vtkUnstructuredGrid* grid)
{
  return ReadCells(grid, true);
}

std::vector<double> ReadWindingNumbers(vtkUnstructuredGrid* grid)
{
  vtkDataArray* array = FindArray(grid, "w", 1);
  if (!array)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the grid has no cell array w of one value per cell: vtkGeneralizedWindingNumber makes it");
  }
  std::vector<double> w(grid->GetNumberOfCells());
  for (std::size_t c = 0; c < w.size(); ++c)
  {
    w[c] = array->GetComponent(static_cast<vtkIdType>(c), 0);
  }
  return w;
}

bool HasFacetIds(vtkUnstructuredGrid* grid)
{
  return FindArray(grid, "FacetIds", 4) != nullptr;
}

TetrahedralMesh ReadTetrahedra(vtkUnstructuredGrid* grid)
{
  std::vector<Point> points = ReadPoints(grid, "the grid");
  std::vector<Tetrahedron> cells(grid->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    grid->GetCellPoints(static_cast<vtkIdType>(c), ids);
    std::copy(ids->begin(), ids->end(), cells[c].begin());
  }
  const std::vector<Tetrahedron> given = cells;
  TetrahedralMesh mesh = ConnectCells(std::move(points), std::move(cells));
  if (vtkDataArray* facetIds = FindArray(grid, "FacetIds", 4))
  {
    for (std::size_t c = 0; c < given.size(); ++c)
    {
      const bool turned = mesh.Cells[c] != given[c];
      for (int k = 0; k < 4; ++k)
      {
        const int face = turned && (k == 0 || k == 3) ? 3 - k : k;
        mesh.Facets[c][face] = facetIds->GetComponent(static_cast<vtkIdType>(c), k) < 0 ? None : 0;
      }
    }
  }
  return mesh;
}

CellParts ReadSides(vtkUnstructuredGrid* grid)
{
  CellParts sides;
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType c = 0, dimension = -1; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    dimension = c == 0 ? cell->GetCellDimension() : dimension;
    CheckCell(c, cell, static_cast<int>(dimension));
    const int numberOfSides = dimension == 3 ? cell->GetNumberOfFaces() : cell->GetNumberOfEdges();
    for (int k = 0; k < numberOfSides; ++k)
    {
      vtkCell* side = dimension == 3 ? cell->GetFace(k) : cell->GetEdge(k);
      std::vector<vtkIdType> corners(side->GetPointIds()->begin(), side->GetPointIds()->end());
      if (side->GetCellType() == VTK_PIXEL) // corners that do not run around it
      {
        std::swap(corners[2], corners[3]);
      }
      sides.Add(static_cast<Id>(c), corners);
    }
  }
  return sides;
}

std::vector<double> ReadSizes(vtkUnstructuredGrid* grid)
{
  // Each simplex has its own points, because not all of VTK's cells provide their ids.
  std::vector<Point> points;
  CellParts simplices;
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCell(c, cell);
    cell->Triangulate(0, ids, corners);
    std::vector<Id> simplex(cell->GetCellDimension() + 1);
    const vtkIdType size = static_cast<vtkIdType>(simplex.size());
    for (vtkIdType first = 0; first + size <= corners->GetNumberOfPoints(); first += size)
    {
      for (vtkIdType k = 0; k < size; ++k)
      {
        simplex[k] = static_cast<Id>(points.size());
        points.emplace_back();
        corners->GetPoint(first + k, points.back().data());
      }
      simplices.Add(static_cast<Id>(c), simplex);
    }
  }
  return CellSizes(points, simplices, static_cast<Id>(grid->GetNumberOfCells()));
}

bool HasIntegers(vtkDataArray* array, vtkUnstructuredGrid* grid)
{
  return array->GetDataType() != VTK_DOUBLE && array->GetDataType() != VTK_FLOAT &&
    array->GetNumberOfTuples() == grid->GetNumberOfCells();
}

std::vector<Id> NumberedAnew(const std::vector<double>& values)
{
  std::vector<double> sorted = values;
  SortUniquely(sorted);
  std::vector<Id> numbers(values.size());
  std::transform(values.begin(), values.end(), numbers.begin(),
    [&](double value) { return static_cast<Id>(IndexIn(sorted, value)); });
  return numbers;
}
} // namespace vtkInsideOut
