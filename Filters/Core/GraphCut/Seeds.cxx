// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/Seeds.h"

#include "Common/BoxTree.h"
#include "Common/Error.h"
#include "Common/PointPredicates.h"
#include "Common/Vectors.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Whether the point lies in the cell or on its boundary. */
bool Contains(const std::vector<Point>& points, const Tetrahedron& cell, const Point& point)
{
  return std::all_of(TetrahedronFaces.begin(), TetrahedronFaces.end(),
    [&](const std::array<int, 3>& face)
    {
      // From outside a face's corners run counter-clockwise, and the outside is the positive side.
      return Orient3D(points[cell[face[0]]], points[cell[face[1]]], points[cell[face[2]]], point) <=
        0;
    });
}

BoxTree MakeTree(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  std::vector<Box> boxes;
  for (const Tetrahedron& cell : cells)
  {
    boxes.push_back(BoundingBox(points, cell));
  }
  return BoxTree(std::move(boxes));
}

const char* NameOf(bool inside)
{
  return inside ? "inside" : "outside";
}
} // namespace

SeededCells FindSeededCells(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
  const std::vector<Seed>& seeds)
{
  const BoxTree tree = MakeTree(points, seeds.empty() ? std::vector<Tetrahedron>() : cells);
  return FindSeededCells(seeds, static_cast<Id>(cells.size()),
    [&](const Point& place)
    {
      Id found = None;
      tree.Visit({ place, place },
        [&](Id cell)
        {
          if ((found == None || cell < found) && Contains(points, cells[cell], place))
          {
            found = cell;
          }
        });
      return found;
    });
}

SeededCells FindSeededCells(
  const std::vector<Seed>& seeds, Id numberOfCells, const std::function<Id(const Point&)>& find)
{
  SeededCells result;
  if (seeds.empty())
  {
    return result;
  }
  result.Demands.assign(numberOfCells, 0);
  result.Seeds.assign(numberOfCells, None);
  for (std::size_t s = 0; s < seeds.size(); ++s)
  {
    const std::string name = "seed " + std::to_string(s);
    if (!IsFinite(seeds[s].Position))
    {
      throw Error(ErrorCode::PointNotFinite, name + " is not finite");
    }
    const Id found = find(seeds[s].Position);
    if (found == None)
    {
      if (seeds[s].Inside)
      {
        ++result.Conflicts;
        result.Warnings.push_back(
          name + " is to be inside, but lies beyond all cells: it does not count");
      }
      continue;
    }
    const std::int8_t demand = seeds[s].Inside ? 1 : -1;
    if (result.Demands[found] == 0)
    {
      result.Demands[found] = demand;
      result.Seeds[found] = static_cast<Id>(s);
    }
    else if (result.Demands[found] != demand)
    {
      ++result.Conflicts;
      result.Warnings.push_back(name + " is to be " + NameOf(seeds[s].Inside) +
        ", but lies in one cell with seed " + std::to_string(result.Seeds[found]) +
        ", which is to be " + NameOf(!seeds[s].Inside) + " and comes first: it does not count");
    }
  }
  return result;
}
} // namespace insideout
