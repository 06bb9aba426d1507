// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/SolidAngleProduct.h"

#include <vector>

namespace insideout
{
constexpr int MultipoleDegree = 23; ///< the highest one of an expansion

/**
 * The winding number of a chain outside a ball around it: a harmonic function that vanishes far
 * away, as a sum of solid harmonics (MacRobert 1927) up to some degree. With r the distance from
 * the ball's center, in units of the radius at which the function was sampled,
 *
 *   w = 1/r Re sum over m of ((x + i y) / r^2)^m sum over l of c_lm Q_lm,    0 <= m <= l,
 *
 * where Q_lm are the monic Legendre functions: Q_mm = 1, Q_l-1,m = 0 for l = m,
 *
 *   Q_l+1,m = z / r^2 Q_lm - (l^2 - m^2) / (4 l^2 - 1) / r^2 Q_l-1,m.
 */
struct Multipole
{
  static constexpr int NumberOfTerms = (MultipoleDegree + 1) * (MultipoleDegree + 2) / 2;

  /** The index of c_lm: sorted by m, then l. */
  static constexpr int TermOf(int l, int m) { return m * MultipoleDegree - m * (m - 1) / 2 + l; }

  std::array<double, NumberOfTerms> Real; ///< of c_lm
  std::array<double, NumberOfTerms> Imaginary;
};

/** Points of the sphere of radius 1 which determine a multipole. */
const std::vector<Point>& MultipoleSamples();

/** The multipole with these values at MultipoleSamples, unless it has terms of higher degree. */
Multipole MultipoleOf(const std::vector<double>& values);

/** The most that each degree's terms add to w at a distance of 1. */
std::array<double, MultipoleDegree + 1> MultipoleBounds(const Multipole& multipole);

/**
 * Add the terms up to a degree to each site's value.
 *
 * @param[in] at the sites' vectors from the center; not shorter than 1
 */
void AddMultipole(
  const Multipole& multipole, int degree, const double (&at)[3][Lanes], double (&w)[Lanes]);

/**
 * Add a function that is harmonic inside the ball of radius 1, in solid harmonics up to a degree:
 * the formula of Multipole with z and r^2 in place of z / r^2 and 1 / r^2, x + i y in place of
 * (x + i y) / r^2, and no 1 / r.
 *
 * @param[in] at the sites' vectors from the center; not longer than 1
 */
void AddLocal(const Multipole& local, int degree, const double (&at)[3][Lanes], double (&w)[Lanes]);
} // namespace insideout
