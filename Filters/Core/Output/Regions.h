// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LoopProgress.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/** Which part of the solid each cell belongs to. */
struct SolidRegions
{
  std::vector<Id> OfCell; ///< one per cell, None for those outside
  Id Count = 0;
};

/**
 * The parts of the solid, numbered by their first cell. Faces connect: cells that have no more than
 * an edge or a point in common belong to one region only if there is a way from one to the other
 * through faces of cells inside. Facets between cells inside part nothing.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @throws Error InvalidParameter when there is not one label per cell; Stopped
 */
SolidRegions FindRegions(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/**
 * The same of cells of any kind.
 *
 * @param[in] neighbors of each cell, None where there is none
 */
template <std::size_t Sides>
SolidRegions FindRegions(const std::vector<std::array<Id, Sides>>& neighbors,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress)
{
  const LoopProgress visits(monitor, progress, neighbors.size());
  SolidRegions regions;
  regions.OfCell.assign(neighbors.size(), None);
  std::vector<Id> reached; // cells whose neighbours are still to be looked at
  std::size_t visited = 0;
  const auto reach = [&](Id cell)
  {
    if (cell != None && inside[cell] != 0 && regions.OfCell[cell] == None)
    {
      regions.OfCell[cell] = regions.Count;
      reached.push_back(cell);
    }
  };
  for (Id first = 0; first < static_cast<Id>(neighbors.size()); ++first)
  {
    reach(first);
    const bool isNew = !reached.empty();
    while (!reached.empty())
    {
      visits.Check(visited++);
      const Id cell = reached.back();
      reached.pop_back();
      for (const Id neighbor : neighbors[cell])
      {
        reach(neighbor);
      }
    }
    regions.Count += isNew;
  }
  return regions;
}
} // namespace insideout
