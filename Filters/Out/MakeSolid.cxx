// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeSolid.h"

#include "Data/Arrays.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
/** The numbers and names of groups. */
struct GroupWords
{
  const char* Array;
  const char* Names;
  const char* Prefix; ///< name of unnamed groups, if others have names
  bool HasOutside;    ///< whether a last group of that name is -1
};

constexpr GroupWords Regions = { "RegionId", "RegionNames", "region_", true };
constexpr GroupWords Tags = { "BoundaryTag", "BoundaryTagNames", "tag_", false };

void AddGroups(const std::vector<Id>& groupOf, const std::vector<SolidGroup>& groups,
  const GroupWords& words, vtkDataSet* data)
{
  Id last = 0;
  bool hasNames = false;
  for (const SolidGroup& group : groups)
  {
    last = std::max(last, group.Number);
    hasNames = hasNames || !group.Name.empty();
  }
  std::vector<Id> numbers;
  std::vector<std::string> names;
  for (const SolidGroup& group : groups)
  {
    // vtkSolidWriter numbers the outside after all regions.
    const bool isOutside = words.HasOutside && group.Number == last && group.Name == "outside";
    numbers.push_back(isOutside ? None : group.Number - 1);
    if (!isOutside)
    {
      names.resize(std::max(names.size(), static_cast<std::size_t>(group.Number)));
      names[static_cast<std::size_t>(group.Number) - 1] =
        group.Name.empty() ? words.Prefix + std::to_string(group.Number - 1) : group.Name;
    }
  }
  auto array = MakeArray<vtkIntArray>(words.Array, static_cast<vtkIdType>(groupOf.size()));
  std::transform(groupOf.begin(), groupOf.end(), array->GetPointer(0),
    [&numbers](Id group) { return numbers[static_cast<std::size_t>(group)]; });
  data->GetCellData()->AddArray(array);
  if (hasNames && !names.empty())
  {
    data->GetFieldData()->AddArray(MakeStrings(words.Names, names));
  }
}

/** Corners, then midpoints. */
template <std::size_t Corners, std::size_t Edges>
std::vector<std::array<Id, Corners + Edges>> QuadraticCells(
  const SolidElements<Corners, Edges>& elements)
{
  std::vector<std::array<Id, Corners + Edges>> cells(elements.Cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const auto behind =
      std::copy(elements.Cells[c].begin(), elements.Cells[c].end(), cells[c].begin());
    std::copy(elements.Midpoints[c].begin(), elements.Midpoints[c].end(), behind);
  }
  return cells;
}

template <std::size_t Corners, std::size_t Edges>
void SetCells(const SolidElements<Corners, Edges>& elements, int linear, int quadratic,
  vtkUnstructuredGrid* grid)
{
  elements.Midpoints.empty() ? grid->SetCells(linear, MakeCells(elements.Cells))
                             : grid->SetCells(quadratic, MakeCells(QuadraticCells(elements)));
  AddGroups(elements.GroupOf, elements.Groups, Regions, grid);
}
} // namespace

vtkSmartPointer<vtkUnstructuredGrid> MakeSolid(const SolidContent& solid)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(MakePoints(solid.Points));
  solid.Tetrahedra.Cells.empty()
    ? SetCells(solid.Triangles, VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE, grid)
    : SetCells(solid.Tetrahedra, VTK_TETRA, VTK_QUADRATIC_TETRA, grid);
  return grid;
}

vtkSmartPointer<vtkPolyData> MakeSolidBoundary(const SolidContent& solid)
{
  auto boundary = vtkSmartPointer<vtkPolyData>::New();
  if (solid.Tetrahedra.Cells.empty())
  {
    boundary->Initialize();
    return boundary;
  }
  std::vector<Id> places(solid.Points.size(), None);
  std::vector<Point> points;
  std::vector<Triangle> triangles = solid.Triangles.Cells;
  for (Triangle& triangle : triangles)
  {
    for (Id& corner : triangle)
    {
      Id& place = places[corner];
      if (place == None)
      {
        place = static_cast<Id>(points.size());
        points.push_back(solid.Points[corner]);
      }
      corner = place;
    }
  }
  boundary->SetPoints(MakePoints(points));
  boundary->SetPolys(MakeCells(triangles));
  AddGroups(solid.Triangles.GroupOf, solid.Triangles.Groups, Tags, boundary);
  return boundary;
}
} // namespace vtkInsideOut
