// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/ReadSolid.h"

#include "Common/Error.h"
#include "Common/SortUniquely.h"
#include "Data/Arrays.h"
#include "Data/FieldNames.h"
#include "Data/StatisticsArrays.h"
#include "Files/SolidFaces.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
constexpr int CornersOfTetra = 4;
constexpr int CornersOfTriangle = 3;

[[noreturn]] void Refuse(const std::string& what)
{
  throw Error(ErrorCode::InvalidParameter, what);
}

struct Parts
{
  vtkUnstructuredGrid* Solid = nullptr;
  vtkPolyData* Boundary = nullptr;
};

/** The solid, and the boundary if there is one, among the blocks with cells. */
Parts PartsOfBlocks(vtkCompositeDataSet* blocks)
{
  Parts parts;
  int grids = 0;
  int surfaces = 0;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    auto* block = vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject());
    if (!block || block->GetNumberOfCells() == 0)
    {
      continue;
    }
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(block))
    {
      parts.Solid = grid;
      ++grids;
    }
    else if (auto* surface = vtkPolyData::SafeDownCast(block))
    {
      parts.Boundary = surface;
      ++surfaces;
    }
  }
  if (grids != 1 || surfaces > 1)
  {
    Refuse("the blocks are " + std::to_string(grids) + " solids and " + std::to_string(surfaces) +
      " surfaces; one is written, and its boundary");
  }
  return parts;
}

/** The same for an input that may be only the solid. */
Parts PartsOf(vtkDataObject* input)
{
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  return blocks ? PartsOfBlocks(blocks)
                : Parts{ vtkUnstructuredGrid::SafeDownCast(input), nullptr };
}

/** Points of a cell by unchecked ids. */
template <std::size_t Size>
void CopyIds(const vtkIdType* ids, vtkIdType cell, vtkIdType points, std::array<Id, Size>& corners)
{
  for (std::size_t k = 0; k < Size; ++k)
  {
    if (ids[k] < 0 || ids[k] >= points)
    {
      throw Error(ErrorCode::PointOutOfRange,
        "cell " + std::to_string(cell) + " refers to point " + std::to_string(ids[k]) + " of " +
          std::to_string(points));
    }
    corners[k] = static_cast<Id>(ids[k]);
  }
}

/** Whether a grid has pyramids or prisms. */
bool HasLayers(vtkUnstructuredGrid* grid)
{
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) == VTK_PYRAMID || grid->GetCellType(c) == VTK_WEDGE)
    {
      return true;
    }
  }
  return false;
}

/** Corners of cells with layers. @return for each cell of the solid that of the grid */
std::vector<vtkIdType> ReadLayers(vtkUnstructuredGrid* grid, SolidMesh& solid)
{
  std::array<std::vector<vtkIdType>, 3> order;
  vtkNew<vtkIdList> ids;
  const auto append = [&](auto& cells, vtkIdType c)
  {
    cells.emplace_back();
    CopyIds(ids->begin(), c, grid->GetNumberOfPoints(), cells.back());
  };
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    const int type = grid->GetCellType(c);
    grid->GetCellPoints(c, ids);
    if (type == VTK_TETRA)
    {
      append(solid.Cells, c);
    }
    else if (type == VTK_PYRAMID)
    {
      append(solid.Pyramids, c);
    }
    else if (type == VTK_WEDGE)
    {
      append(solid.Prisms, c);
    }
    else
    {
      Refuse("cell " + std::to_string(c) + " is of VTK's type " + std::to_string(type) +
        "; a solid with layers has tetrahedra (10), prisms (13) and pyramids (14)");
    }
    order[type == VTK_TETRA ? 0 : type == VTK_PYRAMID ? 1 : 2].push_back(c);
  }
  std::vector<vtkIdType> all = order[0];
  all.insert(all.end(), order[1].begin(), order[1].end());
  all.insert(all.end(), order[2].begin(), order[2].end());
  return all;
}

/** Corners and midpoints of the cells, which are all of one order. */
void ReadCells(vtkUnstructuredGrid* grid, SolidMesh& solid)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  const bool quadratic = cells > 0 && grid->GetCellType(0) == VTK_QUADRATIC_TETRA;
  solid.Cells.resize(cells);
  solid.Midpoints.resize(quadratic ? cells : 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < cells; ++c)
  {
    const int type = grid->GetCellType(c);
    if (type != (quadratic ? VTK_QUADRATIC_TETRA : VTK_TETRA))
    {
      Refuse("cell " + std::to_string(c) + " is of VTK's type " + std::to_string(type) +
        "; a solid has tetrahedra, all linear (10) or all quadratic (24)");
    }
    grid->GetCellPoints(c, ids);
    CopyIds(ids->begin(), c, grid->GetNumberOfPoints(), solid.Cells[c]);
    if (quadratic)
    {
      CopyIds(ids->begin() + CornersOfTetra, c, grid->GetNumberOfPoints(), solid.Midpoints[c]);
    }
  }
}

/** The numbers of a cell array, all 0 without it. */
std::vector<Id> ReadNumbers(vtkDataSet* data, const char* name, Id least)
{
  std::vector<Id> numbers(data->GetNumberOfCells(), 0);
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  if (!array)
  {
    return numbers;
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != data->GetNumberOfCells())
  {
    Refuse(std::string("the cell array ") + name + " has not one number per cell");
  }
  constexpr double most = std::numeric_limits<Id>::max() - 2; // files count from 1
  for (std::size_t c = 0; c < numbers.size(); ++c)
  {
    const double number = array->GetComponent(static_cast<vtkIdType>(c), 0);
    if (!(number >= least && number <= most && number == std::floor(number)))
    {
      Refuse(std::string("the cell array ") + name + " is " + std::to_string(number) + " at cell " +
        std::to_string(c) + "; it has to hold whole numbers from " + std::to_string(least));
    }
    numbers[c] = static_cast<Id>(number);
  }
  return numbers;
}

/** The groups of the occurring numbers, ascending, and each element's index in these. In files
 * numbers count from 1, and -1 becomes the last. */
template <typename NameOf>
std::vector<SolidGroup> MakeGroups(std::vector<Id>& numbers, const NameOf& nameOf)
{
  std::vector<Id> present = numbers;
  SortUniquely(present);
  const bool isAlone = !present.empty() && present.back() == 0; // except the outside's
  std::vector<SolidGroup> groups;
  for (const Id number : present)
  {
    groups.push_back({ nameOf(number, isAlone), 1 + (number < 0 ? present.back() + 1 : number) });
  }
  for (Id& number : numbers)
  {
    number = IndexIn(present, number);
  }
  return groups;
}

std::vector<Triangle> ReadTriangles(vtkPolyData* boundary)
{
  const vtkIdType triangles = boundary->GetNumberOfPolys();
  if (triangles != boundary->GetNumberOfCells())
  {
    Refuse("the boundary has cells that are not polygons");
  }
  std::vector<Triangle> corners(triangles);
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < triangles; ++t)
  {
    boundary->GetPolys()->GetCellAtId(t, ids);
    if (ids->GetNumberOfIds() != CornersOfTriangle)
    {
      Refuse("cell " + std::to_string(t) + " of the boundary has " +
        std::to_string(ids->GetNumberOfIds()) + " corners; it has to have 3");
    }
    CopyIds(ids->begin(), t, boundary->GetNumberOfPoints(), corners[t]);
  }
  return corners;
}

/** Leave away the second half of each quad of layers. */
void KeepQuadsOnce(SolidMesh& solid)
{
  std::vector<char> isSeen(5 * solid.NumberOfCells(), 0);
  std::size_t kept = 0;
  for (std::size_t f = 0; f < solid.Faces.size() && solid.HasLayers(); ++f)
  {
    const CellFace face = solid.Faces[f];
    char& seen = isSeen[5 * static_cast<std::size_t>(face.Cell) + face.Face];
    if (!IsQuad(solid, face) || seen == 0)
    {
      solid.TagOfFace[kept] = solid.TagOfFace[f];
      solid.Faces[kept++] = face;
    }
    seen = 1;
  }
  if (solid.HasLayers())
  {
    solid.Faces.resize(kept);
    solid.TagOfFace.resize(kept);
  }
}

void ReadBoundary(vtkPolyData* boundary, SolidMesh& solid)
{
  const std::vector<Point> points = ReadPoints(boundary, "the boundary");
  solid.Faces = FacesOfTriangles(solid, points, ReadTriangles(boundary));
  solid.TagOfFace = ReadNumbers(boundary, "BoundaryTag", 0);
  KeepQuadsOnce(solid);
  const std::vector<std::string> names =
    NamesByNumber(boundary->GetFieldData(), "BoundaryTagNames");
  solid.Tags = MakeGroups(solid.TagOfFace,
    [&names](Id tag, bool isAlone)
    {
      const auto number = static_cast<std::size_t>(tag);
      return number < names.size() && !names[number].empty() ? names[number]
        : isAlone                                            ? std::string("surface")
                                                             : "tag_" + std::to_string(tag);
    });
}
} // namespace

SolidMesh ReadSolid(vtkDataObject* input, vtkPolyData* boundary)
{
  Parts parts = PartsOf(input);
  parts.Boundary = boundary ? boundary : parts.Boundary;
  if (!parts.Solid)
  {
    Refuse("there is no solid to write");
  }

  SolidMesh solid;
  solid.Points = ReadPoints(parts.Solid, "the solid");
  solid.RegionOfCell = ReadNumbers(parts.Solid, "RegionId", None);
  if (HasLayers(parts.Solid))
  {
    const std::vector<Id> given = solid.RegionOfCell;
    const std::vector<vtkIdType> order = ReadLayers(parts.Solid, solid);
    std::transform(order.begin(), order.end(), solid.RegionOfCell.begin(),
      [&given](vtkIdType cell) { return given[cell]; });
  }
  else
  {
    ReadCells(parts.Solid, solid);
  }
  const std::vector<std::string> names = NamesByNumber(parts.Solid->GetFieldData(), "RegionNames");
  solid.Regions = MakeGroups(solid.RegionOfCell,
    [&names](Id region, bool isAlone)
    {
      const auto number = static_cast<std::size_t>(region);
      return region == None     ? std::string("outside")
        : number < names.size() ? names[number]
        : isAlone               ? std::string("solid")
                                : "region_" + std::to_string(region);
    });
  if (parts.Boundary)
  {
    ReadBoundary(parts.Boundary, solid);
  }
  else
  {
    solid.Faces = OuterFaces(solid);
    solid.TagOfFace.assign(solid.Faces.size(), 0);
    solid.Tags = { { "surface", 1 } };
  }
  return solid;
}

CellTreatment TreatmentOf(vtkDataObject* input)
{
  CellTreatment done = CellTreatment::None;
  for (const auto& [name, value] : StatisticsOf(PartsOf(input).Solid->GetFieldData()))
  {
    if (name == "SurfaceDistance")
    {
      return CellTreatment::Remeshed;
    }
    done = name == "RefinedCells" ? CellTreatment::Refined : done;
  }
  return done;
}

bool MayBeRemeshed(vtkDataObject* input)
{
  const auto statistics = StatisticsOf(PartsOf(input).Solid->GetFieldData());
  return std::none_of(statistics.begin(), statistics.end(),
    [](const auto& one) { return one.first == "KeptByOptions"; });
}
} // namespace vtkInsideOut
