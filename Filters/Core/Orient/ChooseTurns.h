// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SampleRegions.h"

namespace insideout
{
/** Which shells to turn over. */
struct ShellTurns
{
  std::vector<char> Turned; ///< one per shell

  /** One per shell: 1 where turning it makes no difference that the volumes are sure of, though it
   * makes one. */
  std::vector<char> Undecided;
};

/**
 * The law of orientation. A solid is where w is 1; where w is above 1 parts overlap; where w is
 * below -1/2 nothing can be meant. Among all ways to turn shells over, take one with
 *
 *   1. the least volume where w is below -1/2, of these
 *   2. the least volume where w is not 0 or 1; but overlap that is there as given, or with all
 *      turned over, is not counted: it is meant. Among these
 *   3. the fewest facets turned against the others; all of them turned over are none. As given
 *      goes before turned over.
 *
 * So an inward shell within an outward one stays a cavity; both the wrong way round are turned as a
 * whole; and of two bodies that overlap only the one that is inside out is turned. Shells that no
 * region has in common are independent. For up to `MostTried` that are not, all ways are looked at;
 * of more, shells are turned one by one, larger ones first, as long as one gains by it.
 *
 * Volumes are sampled: they are taken as equal if their difference is below a share of the volume
 * that only one of them has. They are also taken as equal if it is below a hundred-thousandth of
 * the volume where w differs: faces that coincide, as the ends of two tubes, do so but for
 * rounding.
 *
 * @param[in] regions of shells 0 to facets.size() - 1
 * @param[in] facets how many each shell has
 */
ShellTurns ChooseTurns(const std::vector<ShellRegion>& regions, const std::vector<Id>& facets);
} // namespace insideout
