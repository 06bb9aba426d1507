// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/RawTetrahedra.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * Make a TetrahedralMesh of what a tetrahedralizer gave, and believe none of it: the complex's
 * points must come first bit by bit and each be in a cell (or equal one that is). Every cell gets a
 * positive volume by an exact predicate, every face at most two cells, on its two sides. The
 * boundary is that of the convex hull (CheckConvexHull.h). A constraint that is neither a face nor
 * a union of marked faces goes to LostFacets, and no face then carries it. Input points that such a
 * union has beside the facet's corners lie on the facet exactly, Steiner points up to rounding.
 *
 * Surface Steiner points take their origin from the lowest facet that has them: on its edge between
 * two corners, else between three (ComposeOrigin).
 *
 * @param[in] raw ids in range
 * @throws Error Inconsistent, Stopped
 */
TetrahedralMesh AssembleMesh(const FacetComplex& surface, RawTetrahedra raw, Monitor& monitor);
} // namespace insideout
