// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Sites.h"

#include <complex>

namespace insideout
{
/**
 * The solid angle of a triangle seen from a site, as a complex number of modulus 1 whose argument
 * is half of it (van Oosterom and Strackee 1983, equation 8): positive where the triangle's normal
 * points away from the site. The argument is in (-pi, pi), never pi itself; it is 0 where the site
 * lies in the triangle's plane, within the triangle too.
 *
 * The site is exact, not rounded, and so is the decision on which side of the triangle it lies.
 * Slow, for the few pairs that double precision cannot decide.
 *
 * @param[in] triangle three finite corners, not on a line
 * @param[in] site of finite corners
 */
std::complex<double> HalfSolidAngle(const std::array<Point, 3>& triangle, const Site& site);
} // namespace insideout
