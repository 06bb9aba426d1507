// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/CoordinateGrid.h"
#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Resolve/ResolveSelfIntersections.h"

#include <string>

namespace insideout
{
/** Two bodies whose faces touch up to rounding. */
struct TouchingBodies
{
  Id First;
  Id Second;
  Id MovedPoints = 0;  ///< points of the second body moved onto the first
  double Distance = 0; ///< the largest distance between faces, and of a move
};

struct Touches
{
  std::vector<TouchingBodies> Bodies; ///< in order
  TouchingFacets Facets;              ///< facets of all chains, numbered consecutively
};

/**
 * Move points of bodies onto the faces of earlier ones that they touch up to rounding: onto the
 * nearest corner within the tolerance, else edge, else facet. The resolver then makes one interface
 * of the facets. No other point moves. A point stays if its move would turn a facet over, make
 * facets of its body cross, or merge it with another point of the body.
 *
 * Bodies that touch exactly stay unchanged for the resolver.
 *
 * @param[in,out] chains one per body
 * @param[in] grids one per body: facets touch if their distance is below 1.5 times the rounding
 * error of both grids. A body without a grid touches none
 * @param[in] tolerance replaces the grids if it is above 0
 * @param[in,out] crossings of each chain
 * @throws Error (Stopped)
 */
Touches TouchBodies(std::vector<FacetComplex>& chains,
  const std::vector<std::optional<CoordinateGrid>>& grids, double tolerance,
  std::vector<std::vector<std::array<Id, 2>>>& crossings, Monitor& monitor);

/**
 * A tolerance that closes a gap made by rounding: the argument is the sum of both rounding errors.
 */
double TouchToleranceOf(double roundings);

/** A line for each pair of bodies, up to a limit. @param[in] names of all bodies */
std::vector<std::string> WordsOf(
  const std::vector<TouchingBodies>& touching, const std::vector<std::string>& names);
} // namespace insideout
