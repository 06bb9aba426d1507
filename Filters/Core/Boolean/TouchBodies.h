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
  Id MovedPoints = 0;  ///< of the second, onto the first
  double Distance = 0; ///< largest between faces, and of moves
};

struct Touches
{
  std::vector<TouchingBodies> Bodies; ///< in order
  TouchingFacets Facets;              ///< those of all chains numbered in a row
};

/**
 * Move points of bodies onto the faces of earlier ones that they touch up to rounding: onto the
 * nearest corner within the tolerance, else edge, else facet. The resolver then makes one interface
 * of the facets. No other point moves; a point stays if its move would turn a facet over, make
 * facets of its body cross, or put it on another point of the body.
 *
 * Bodies that touch exactly are left to the resolver as they are.
 *
 * @param[in,out] chains one per body
 * @param[in] grids one per body: facets touch if their distance is below 1.5 times the rounding
 * error of both grids. Without a grid a body touches none
 * @param[in] tolerance instead of the grids', where it is above 0
 * @param[in,out] crossings of each chain
 * @throws Error (Stopped)
 */
Touches TouchBodies(std::vector<FacetComplex>& chains,
  const std::vector<std::optional<CoordinateGrid>>& grids, double tolerance,
  std::vector<std::vector<std::array<Id, 2>>>& crossings, Monitor& monitor);

/** A tolerance that surely closes a gap by rounding errors of two coordinates, whose sum is
 * given. */
double TouchToleranceOf(double roundings);

/** A line for each pair of bodies, up to a limit. @param[in] names of all bodies */
std::vector<std::string> WordsOf(
  const std::vector<TouchingBodies>& touching, const std::vector<std::string>& names);
} // namespace insideout
