// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Validate/FacetEdges.h"

/** The rest of each body among all that are resolved together. */
namespace insideout
{
/**
 * Per body whether it has no boundary: on every edge its counts cancel.
 *
 * @param[in] edges those of Surface.Facets
 */
std::vector<char> FindClosedBodies(
  const ResolvedBodies& bodies, const std::vector<FacetEdge>& edges);

/** Whether no body has a boundary. */
bool AreClosed(const ResolvedBodies& bodies, const std::vector<FacetEdge>& edges);

/** The facets with their multiplicities for one body: the body's w is that of this complex. */
FacetComplex ComplexOfBody(const ResolvedBodies& bodies, Id body);
} // namespace insideout
