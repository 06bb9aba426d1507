// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"

#include <string>
#include <vector>

namespace insideout
{
/** Two bodies with facets that coincide up to rounding, but are distinct. */
struct NearBodies
{
  Id First;
  Id Second;
  Id Triangles;     ///< of the input, of either body
  double Distance;  ///< at most, up to rounding
  double Tolerance; ///< a touch tolerance that makes them one interface
};

/**
 * Find bodies that nearly touch: facets of different bodies lie on each other within the resolver's
 * snapping radius (FindLayers, SnappingRadius). The resolver merged such facets if they cross.
 * Others stay apart, which is exact but hardly ever intended.
 *
 * @param[in] candidates all facets that may be near one of another body, and perhaps more
 * @return by bodies
 * @throws Error (Stopped)
 */
std::vector<NearBodies> FindNearBodies(
  const ResolvedBodies& bodies, const std::vector<Id>& candidates, Monitor& monitor);

/**
 * A line for each of the first pairs of bodies: their names, and a touch tolerance that makes them
 * touch, if that is larger than the present one.
 *
 * @param[in] names of all bodies
 * @param[in] tolerance the present one
 */
std::vector<std::string> WordsOf(
  const std::vector<NearBodies>& near, const std::vector<std::string>& names, double tolerance);
} // namespace insideout
