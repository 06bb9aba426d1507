// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

/** Surfaces made of others, to see how time grows. */
namespace benchmark
{
/** Every triangle in four, at the midpoints of its edges. */
insideout::TriangleSoup Subdivided(const insideout::TriangleSoup& soup);

/**
 * The surface less `holes` patches of triangles around random ones, each grown until it has about
 * `edgesPerHole` edges to the rest. The same for the same surface.
 */
insideout::TriangleSoup WithHoles(
  const insideout::TriangleSoup& soup, int holes, std::size_t edgesPerHole);
} // namespace benchmark
