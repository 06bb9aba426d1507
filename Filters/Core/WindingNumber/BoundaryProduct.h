// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/SolidAngleProduct.h"

#include <vector>

/**
 * The winding number modulo 1, from the boundary alone.
 *
 * Modulo 1 it is the same for all surfaces with the same boundary, so it is a function of the
 * boundary's edges: half the solid angle of a loop of directions is the argument of a product of
 * spinors (Pancharatnam 1956),
 *
 *   solid angle / 2 = arg prod <s(u_i) | s(u_i+1)>   modulo 2 pi,   |<s(u) | s(v)>| = cos(angle /
 * 2)
 *
 * where s(u) = (1 + z, x + i y) / norm points to the direction u = (x, y, z). Scaling a spinor by a
 * complex number changes nothing, because each occurs once in a bra and once in a ket. So the norm
 * can be left out, and u need not be a unit vector. (x - i y, 1 - z) is the same spinor without
 * cancellation where z is negative, and may stand in for it. A point costs one root and an edge two
 * complex products, without division, arctangent or branch.
 */
namespace insideout
{
/** Closed loops: the points of all loops in sequence, and the number of points of each. */
struct BoundaryLoops
{
  const Point* Points;
  const std::int32_t* FirstSize;
  const std::int32_t* LastSize;
};

/** The partial product per site. */
struct PhaseProducts
{
  double Real[Lanes];
  double Imaginary[Lanes];
};

/**
 * Multiply each site's product by the edges of some loops. Sites have to keep away from the edges:
 * the relative error of a factor is some 2^-52 / cos(half the angle that the edge is seen under).
 *
 * @param[in] loops of points scaled into [-1, 1]
 * @param[in] sites at least 2^-45 away from all points, below 2^50 in each coordinate
 */
void MultiplyByBoundary(
  const BoundaryLoops& loops, const SiteBlock& sites, PhaseProducts& products);

/** A permutation of the axes, the third one perhaps reversed: a right-handed frame. */
struct Frame
{
  int X;
  int Y;
  int Z;
  double Sign; ///< of Z
};

/**
 * The same for sites from which all points lie in the direction of the frame's third axis. This is
 * faster: one of the two spinors suffices.
 *
 * @param[in] sites at least 2^-6 away from all points along that axis, so that their High is
 * enough, and no more than 8 away along any
 */
void MultiplyByBoundaryAhead(
  const BoundaryLoops& loops, const Frame& frame, const SiteBlock& sites, PhaseProducts& products);
} // namespace insideout
