// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/Sites.h"

#include <cstddef>
#include <vector>

/**
 * The sum of solid angles in doubles, side by side for a block of sites (WindingNumberSum.h).
 *
 * A sum of arctangents is the argument of a product. The solid angle of a facet is twice the
 * argument of z = real + i imaginary (SolidAngle.h). So the product of all z is kept, with the
 * number of turns of its argument, and one arctangent at the end gives the rest. The loop consists
 * of multiplications and comparisons, which the compiler vectorizes over a block of sites.
 *
 * With u, v, w the unit vectors from the site to the facet's corners,
 *
 *   real = 1 + u.v + v.w + w.u      imaginary = det(u, v, w)      |z| from 0 (on an edge) to 4.
 *
 * Unit vectors are computed once per point, because about six facets share a point. Doubles decide
 * nearly all pairs. A pair that they do not decide (close to the negative real axis, where the side
 * matters by a whole turn, or close to 0) goes to HalfSolidAngle.
 *
 * All coordinates here are below 1.
 */
namespace insideout
{
constexpr int Lanes = 8; ///< sites of a block

/** A facet, prepared for the sum. */
struct SummedFacet
{
  Triangle Corners;         ///< points of the complex
  std::array<int, 3> Local; ///< the same corners, as indices of the available unit vectors
  Point Normal;             ///< cross product of the edges from corner 0
  double UndecidedSide;     ///< |u . Normal| up to this does not decide the side
};

/** The sites of a block in double-double precision: High + Low. */
struct SiteBlock
{
  double High[3][Lanes];
  double Low[3][Lanes];
};

/** From each site to one point: unit vector and 1 / distance; NaN where too near. */
struct UnitVectors
{
  double X[Lanes];
  double Y[Lanes];
  double Z[Lanes];
  double InverseDistance[Lanes];
};

/** Per site the product so far, and the number of times its argument has wrapped around. */
struct Products
{
  double Real[Lanes];
  double Imaginary[Lanes];
  double Turns[Lanes];
};

/**
 * Turn a triangle until it begins with the corner whose edges have the least product, to which the
 * error of the side is proportional. From a site near the short side of a needle, the side of its
 * tip would be undecided.
 */
Triangle FromBluntCorner(const std::vector<Point>& points, const Triangle& corners);

/** Set all but Corners and Local from the positions of the corners. */
void SetGeometry(SummedFacet& facet, const Point& a, const Point& b, const Point& c);

/** The corners of a block's sites: four points and weights per site. */
struct SiteCorners
{
  double Of[4][3][Lanes];
};

/** Round the sites as RoundedSite does. */
void SetSites(SiteBlock& block, const SiteCorners& corners, const SiteWeights& weights);

/** The unit vectors to `count` points. */
void ComputeUnitVectors(
  const Point* points, std::size_t count, const SiteBlock& from, UnitVectors* vectors);

/**
 * Multiply each site's product by the facets from `first` on, up to the end or the first facet,
 * included, that is undecided for some site. Undecided sites get a 1 in `undecided`, and their
 * product lacks that facet; all others get a 0.
 *
 * @return the facet after the last one that was multiplied
 */
const SummedFacet* MultiplyByFacets(const SummedFacet* first, const SummedFacet* last,
  const UnitVectors* vectors, Products& products, double (&undecided)[Lanes]);

/** Multiply one site's product by a z of modulus 1 that is not a negative real number. */
void MultiplyBy(Products& products, int lane, double real, double imaginary);

/** The sum of the half angles over 2 pi, that is of the solid angles over 4 pi. */
double WindingNumber(const Products& products, int lane);
} // namespace insideout
