// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** The shells to turn over. */
struct ShellTurns
{
  std::vector<char> Turned; ///< one per shell

  /** One per shell: 1 if turning it changes volumes, but not certainly more than their sampling
   * error. */
  std::vector<char> Undecided;
};

/**
 * The law of orientation. The solid is the region with w = 1; parts overlap where w is above 1; w
 * below -1/2 has no meaning. Among all ways to turn shells over, take one with
 *
 * 1. the least volume where w is below -1/2; among these
 * 2. the least volume where w is not 0 or 1, not counting overlap that exists as given, or with
 *      all shells turned: it is intended; among these
 * 3. the fewest facets turned against the others (all turned counts as none); on a tie, as given.
 *
 * So an inward shell within an outward one stays a cavity; if both are inverted, both are turned;
 * and of two overlapping bodies only the inverted one is turned. Shells that share no region are
 * independent. In a cluster of up to `MostTried` shells all combinations are tried; in a larger one
 * shells are turned one by one, larger ones first, as long as that improves the result.
 *
 * Volumes are sampled. They are taken as equal if their difference is below a fraction of the
 * volume that only one of them has. The same holds below a hundred-thousandth of the volume where w
 * differs: coincident faces, such as the ends of two tubes, differ by rounding.
 *
 * @param[in] regions of shells 0 to facets.size() - 1
 * @param[in] facets number of facets per shell
 */
ShellTurns ChooseTurns(const std::vector<ShellRegion>& regions, const std::vector<Id>& facets);
} // namespace insideout
