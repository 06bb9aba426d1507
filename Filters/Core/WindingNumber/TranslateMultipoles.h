// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/Multipole.h"

namespace insideout
{
/** One multipole per lane, far from a ball. */
struct FarMultipoles
{
  const Multipole* Fields[Lanes];
  double Direction[3][Lanes]; ///< from the multipole's center to the ball's, of length 1
  double Unit[Lanes];         ///< of the multipole, over the distance; 0 leaves the lane out
  double Radius[Lanes];       ///< of the ball, over the distance; below 1
};

/**
 * Add the multipoles' terms up to a degree to a function inside the ball (AddLocal), expanded up to
 * a degree of its own, in units of the ball's radius.
 *
 * Both expansions are rotated so that the centers are on the z axis, where only terms of the same m
 * meet: time grows with the third power of the degrees (White, Head-Gordon 1996).
 */
void TranslateMultipoles(const FarMultipoles& far, int degree, int localDegree, Multipole& local);
} // namespace insideout
