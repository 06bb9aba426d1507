// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/CellRegions.h"
#include "GraphCut/SimplicialCells.h"

namespace insideout
{
/** Which parts of the solid stay, and which holes. All that is asked for has to hold. */
struct ChooseRegionsParameters
{
  Id LargestRegions = 0;          ///< how many stay at most, the largest; 0 for any number
  double MinimumRegionVolume = 0; ///< of those that stay, an area in a plane, at least 0
  bool SeededRegions = false;     ///< only those with a cell that a seed wants inside
  bool FillCavities = false;      ///< nothing outside is cut off from beyond the hull

  bool ChooseAll() const
  {
    return this->LargestRegions == 0 && this->MinimumRegionVolume == 0 && !this->SeededRegions &&
      !this->FillCavities;
  }
};

/** What a choice, or a joining, changes of the solid. */
struct RegionChanges
{
  Id DroppedRegions = 0;
  double DroppedVolume = 0;
  Id FilledCavities = 0;
  double FilledVolume = 0;
};

/**
 * Drop the parts of the solid that are not wanted, then fill its cavities: the parts of the outside
 * that sides of cells do not connect with the hull. Parts of equal volume come in the order of
 * their lowest cells. A cavity with a cell that a seed wants outside stays.
 *
 * @param[in] demands per cell 1 to be inside, -1 outside, 0 either; or empty
 * @param[in,out] inside one label per cell
 * @throws Error InvalidParameter, Stopped
 */
RegionChanges ChooseRegions(const SimplicialCells& cells, const std::vector<std::int8_t>& demands,
  const ChooseRegionsParameters& parameters, std::vector<unsigned char>& inside, Monitor& monitor,
  const ProgressRange& progress);
} // namespace insideout
