// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HullMesh.h"
#include "Output/Outliers.h"

#include <string>
#include <vector>

namespace insideout
{
/** The fraction of a surface's area that is neither on the solid's boundary nor within it. */
struct LostArea
{
  double Share = 0;  ///< sum of the following
  double Sheets = 0; ///< encloses nothing
  double Turned = 0; ///< was turned over, and is still not part of the solid
  double Unmet = 0;  ///< the mesh does not contain it
  double Others =
    0; ///< w is below 1/2 on both sides, the cut smoothed it away, or a region was dropped

  std::vector<HoledShell> Shells; ///< with holes, lost as a whole
};

LostArea MeasureLostArea(const HullMesh& hull, const std::vector<OutlierPiece>& outliers);

/** Warn of shells that are lost as a whole, and of a lost area above a tenth: the amount, the
 * cause, and the options to set. */
std::vector<std::string> WarningsAbout(const LostArea& lost);
} // namespace insideout
