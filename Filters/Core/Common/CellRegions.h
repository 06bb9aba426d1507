// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LoopProgress.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

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
 * The parts of the solid, numbered by their first cell. Sides connect: cells that have less in
 * common belong to one region only if there is a way from one to the other through sides of cells
 * inside.
 *
 * @param[in] neighbors of each cell, by operator[], None where there is none; they have a size()
 * @param[in] inside one value per cell, 0 for outside
 * @throws Error Stopped
 */
template <typename Neighbors>
SolidRegions FindRegions(const Neighbors& neighbors, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
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
