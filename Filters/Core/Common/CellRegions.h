// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LoopProgress.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <algorithm>
#include <vector>

namespace insideout
{
/** The region of the solid of each cell. */
struct SolidRegions
{
  std::vector<Id> OfCell; ///< one per cell, None outside
  Id Count = 0;
};

/**
 * The components of the solid, numbered by their first cell. Cells are connected through sides
 * only, not through edges or points.
 *
 * @param[in] neighbors of each cell, by operator[], None for no neighbor; they have a size()
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
  std::vector<Id> reached; // cells with unvisited neighbors
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

/** The components of the outside. */
struct OutsideRegions
{
  SolidRegions Regions;
  std::vector<unsigned char> IsOpen; ///< per region 1 if it has a cell on the hull, 0 for a cavity
};

/** The same for the outside, with the regions that reach beyond the hull. */
template <typename Neighbors>
OutsideRegions FindOutside(const Neighbors& neighbors, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  std::vector<unsigned char> outside(inside.size());
  std::transform(inside.begin(), inside.end(), outside.begin(),
    [](unsigned char label) { return label == 0 ? 1 : 0; });
  OutsideRegions found = { FindRegions(neighbors, outside, monitor, progress), {} };
  found.IsOpen.assign(static_cast<std::size_t>(found.Regions.Count), 0);
  for (std::size_t cell = 0; cell < outside.size(); ++cell)
  {
    const auto& beyond = neighbors[static_cast<Id>(cell)];
    if (outside[cell] && std::find(beyond.begin(), beyond.end(), None) != beyond.end())
    {
      found.IsOpen[found.Regions.OfCell[cell]] = 1;
    }
  }
  return found;
}
} // namespace insideout
