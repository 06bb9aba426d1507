// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Validate/FacetEdges.h"

/** Properties of single bodies among bodies that are resolved together. */
namespace insideout
{
/**
 * Per body, whether it has no boundary: its counts cancel at every edge.
 *
 * @param[in] edges those of Surface.Facets
 */
std::vector<char> FindClosedBodies(const ResolvedBodies& bodies, const FacetEdges& edges);

/** Whether no body has a boundary. */
bool AreClosed(const ResolvedBodies& bodies, const FacetEdges& edges);

/** The facets with their multiplicities in one body: w of this complex is that of the body. */
FacetComplex ComplexOfBody(const ResolvedBodies& bodies, Id body);
} // namespace insideout
