// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/CellRegions.h"
#include "GraphCut/SimplicialCells.h"

namespace insideout
{
/** Criteria for the regions of the solid, and the cavities, that stay. All of them have to hold. */
struct ChooseRegionsParameters
{
  Id LargestRegions = 0;          ///< number of largest regions that stay; 0 for no limit
  double MinimumRegionVolume = 0; ///< of regions that stay, an area in a plane, at least 0
  bool SeededRegions = false;     ///< only regions with a cell that a seed wants inside
  /// fill cavities: nothing outside is disconnected from beyond the hull
  bool FillCavities = false;

  bool ChooseAll() const
  {
    return this->LargestRegions == 0 && this->MinimumRegionVolume == 0 && !this->SeededRegions &&
      !this->FillCavities;
  }
};

/** Changes of the solid by choosing or joining regions. */
struct RegionChanges
{
  Id DroppedRegions = 0;
  double DroppedVolume = 0;
  Id FilledCavities = 0;
  double FilledVolume = 0;
};

/**
 * Drop the parts of the solid that do not meet the criteria, then fill its cavities: parts of the
 * outside not connected with the hull through sides of cells. Parts of equal volume are ordered by
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
