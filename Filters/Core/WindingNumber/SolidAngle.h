// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/Sites.h"

#include <complex>

namespace insideout
{
/**
 * The solid angle of a triangle seen from a site, as a complex number of modulus 1 whose argument
 * is half of it (van Oosterom and Strackee 1983, equation 8): positive where the triangle's normal
 * points away from the site. The argument is in (-pi, pi), never pi itself; it is 0 where the site
 * lies in the triangle's plane, within the triangle too.
 *
 * The site is exact, not rounded, and so is the decision on which side of the triangle it lies. The
 * error is below 1e-13, however near to an edge or a corner the site is. Slow, for the few pairs
 * that double precision cannot decide.
 *
 * @param[in] triangle three corners, not on a line
 * @param[in] site coordinates are below 1, or not much above
 */
std::complex<double> HalfSolidAngle(const std::array<Point, 3>& triangle, const Site& site);

/**
 * The winding number of one triangle at a point: its solid angle over 4 pi. Quick, and as exact
 * about the side as HalfSolidAngle.
 *
 * @param[in] triangle, p below 1 in each coordinate
 */
double WindingNumberOfTriangle(const std::array<Point, 3>& triangle, const Point& p);
} // namespace insideout
