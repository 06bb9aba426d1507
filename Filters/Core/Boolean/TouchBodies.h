// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/CoordinateGrid.h"
#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Resolve/ResolveSelfIntersections.h"

#include <string>

namespace insideout
{
/** Two bodies whose faces touch but for rounding. */
struct TouchingBodies
{
  Id First;
  Id Second;
  Id MovedPoints = 0;  ///< of the second, onto the first
  double Distance = 0; ///< between their faces, and how far points moved: the most
};

struct Touches
{
  std::vector<TouchingBodies> Bodies; ///< in order
  TouchingFacets Facets;              ///< those of all chains numbered in a row
};

/**
 * Move points of bodies onto the faces of earlier ones that they touch but for rounding: onto a
 * corner, else an edge, else a facet, the nearest that is within the tolerance. The resolver then
 * makes one interface of the facets. No other point moves; a point stays if its move would
 * turn a facet over, make facets of its body cross, or put it on another point of the body.
 *
 * Bodies that touch exactly are left to the resolver as they are.
 *
 * @param[in,out] chains one per body
 * @param[in] grids one per body: facets touch that are nearer than what rounding to both grids can
 *   part, half of that more. Without a grid a body touches none
 * @param[in] tolerance instead of the grids', where it is above 0
 * @param[in,out] crossings of each chain
 * @throws Error (Stopped)
 */
Touches TouchBodies(std::vector<FacetComplex>& chains,
  const std::vector<std::optional<CoordinateGrid>>& grids, double tolerance,
  std::vector<std::vector<std::array<Id, 2>>>& crossings, Monitor& monitor);

/** A tolerance that surely closes what is apart by a rounding of each of two coordinates, of which
 * the sum is given. */
double TouchToleranceOf(double roundings);

/** A line for each pair of bodies, of many for the first. @param[in] names of all bodies */
std::vector<std::string> WordsOf(
  const std::vector<TouchingBodies>& touching, const std::vector<std::string>& names);
} // namespace insideout
