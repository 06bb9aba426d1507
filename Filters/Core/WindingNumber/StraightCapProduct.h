// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/SolidAngleProduct.h"

/**
 * The sum of solid angles of triangles that share no points, side by side for a block of sites.
 *
 * As in SolidAngleProduct.h, but without dividing the vectors a, b, c by their lengths, because
 * each serves one triangle only. With z times these lengths,
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
  double UndecidedSide; ///< |a . Normal| up to this times |a| does not decide the side
  double Thickness;     ///< the same, without |a|: a site may be among the pieces
};

/** Everything from the corners; their distances are above 2^-20. */
CapTriangle MakeCapTriangle(const std::array<Point, 3>& corners, double height);

/**
 * Multiply each site's product by the triangles from `first` on, up to the end or the first
 * triangle, included, that is undecided for some site. Undecided sites get a 1 in `undecided`, and
 * their product lacks that triangle; all others get a 0. A site that may be within
 * ReachOfStraightCap of the triangle is undecided.
 *
 * @return the triangle after the last one that was multiplied
 */
const CapTriangle* MultiplyByTriangles(const CapTriangle* first, const CapTriangle* last,
  const SiteBlock& sites, Products& products, double (&undecided)[Lanes]);

/** A triangle about as thin as rounding errors, and its count. */
struct Sliver
{
  std::array<Point, 3> Corners;
  Point Normal;       ///< times its count
  double NormalError; ///< of its length, likewise
};

Sliver MakeSliver(const std::array<Point, 3>& corners, int count);

/** One sliver per lane, taken as lines; unused lanes have no area. */
struct SliverLines
{
  double From[3][Lanes];
  double Along[3][Lanes];      ///< to the other end
  double InverseSquare[Lanes]; ///< 1 over its squared length
  double Area[Lanes];          ///< over that of a sphere of radius 1
  double Width[Lanes];         ///< w at a distance of 1 from an endless strip of this width
};

/** Take a sliver as the line from its first to its last corner, with the other corner between. */
void SetLine(SliverLines& lines, int lane, const Sliver& sliver);

/**
 * Mark the slivers whose winding number may exceed a bound somewhere in a ball.
 *
 * @param[out] seen 1 or 0
 */
void SeeSlivers(const SliverLines& lines, const Point& centre, double radius, double leastSeen,
  double (&seen)[Lanes]);

/**
 * Add half the solid angle of a sliver to each site's sum, except for sites where doubles do not
 * decide it to 2^-49: those get a 1 in `undecided`, the others a 0.
 *
 * @return whether any site is undecided
 */
bool AddSliver(
  const Sliver& sliver, const SiteBlock& sites, double (&sums)[Lanes], double (&undecided)[Lanes]);
} // namespace insideout
