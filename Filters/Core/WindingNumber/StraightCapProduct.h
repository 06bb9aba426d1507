// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/SolidAngleProduct.h"

/**
 * The sum of solid angles of triangles that share no points, side by side for a block of sites.
 *
 * As in SolidAngleProduct.h, but with vectors a, b, c that are not divided by their lengths, for
 * here each of them serves one triangle only: with z times these lengths,
 *
 *   real = |a||b||c| + a.b |c| + b.c |a| + c.a |b|      imaginary = det(a, b, c)
 *
 * there are three roots and no division. All coordinates here are below 1.
 */
namespace insideout
{
/** A triangle that stands in for pieces (StraightCaps.h). */
struct CapTriangle
{
  std::array<Point, 3> Corners;
  Point Normal;         ///< cross product of the edges from corner 0
  double UndecidedSide; ///< |a . Normal| up to this times |a| does not tell the side
  double Thickness;     ///< the same, without |a|: a site may be amid the pieces
};

/** Everything from the corners; their distances are above 2^-20. */
CapTriangle MakeCapTriangle(const std::array<Point, 3>& corners, double height);

/**
 * Multiply each site's product by the triangles from `first` on, up to the end or up to and
 * including the first one that is not decided for every site: sites that it is not decided for get
 * a 1 in `undecided`, and their product lacks it. All others get a 0. A site that may be as near to
 * the triangle as ReachOfStraightCap is not decided.
 *
 * @return the triangle after the last one that was taken
 */
const CapTriangle* MultiplyByTriangles(const CapTriangle* first, const CapTriangle* last,
  const SiteBlock& sites, Products& products, double (&undecided)[Lanes]);

/** A triangle about as thin as rounding errors, and how often it counts. */
struct Sliver
{
  std::array<Point, 3> Corners;
  Point Normal;       ///< times its count
  double NormalError; ///< of its length, likewise
};

Sliver MakeSliver(const std::array<Point, 3>& corners, int count);

/** As many slivers as there are lanes, taken for lines; the last ones may be of no area. */
struct SliverLines
{
  double From[3][Lanes];
  double Along[3][Lanes];      ///< to the other end
  double InverseSquare[Lanes]; ///< 1 over its squared length
  double Area[Lanes];          ///< over that of a sphere of radius 1
  double Width[Lanes];         ///< w at a distance of 1 from an endless strip as wide
};

/** Take a sliver for the line from its first to its last corner, the other one being between. */
void SetLine(SliverLines& lines, int lane, const Sliver& sliver);

/**
 * Which of the slivers may be seen: have more than so large a winding number somewhere in a ball.
 *
 * @param[out] seen 1 or 0
 */
void SeeSlivers(const SliverLines& lines, const Point& centre, double radius, double leastSeen,
  double (&seen)[Lanes]);

/**
 * Add half the solid angle of a sliver to each site's sum, except in the sites where doubles do not
 * decide it to 2^-49: those get a 1 in `undecided`, the others a 0.
 *
 * @return whether any site is undecided
 */
bool AddSliver(
  const Sliver& sliver, const SiteBlock& sites, double (&sums)[Lanes], double (&undecided)[Lanes]);
} // namespace insideout
