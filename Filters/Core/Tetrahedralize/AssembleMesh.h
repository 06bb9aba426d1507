// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/RawTetrahedra.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * Make a TetrahedralMesh from a tetrahedralizer's output and verify all of it. The complex's points
 * must come first, bit for bit, and each must be in a cell (or equal a point that is). Every cell
 * gets a positive volume by an exact predicate, every face at most two cells, on its two sides. The
 * boundary is that of the convex hull (CheckConvexHull.h). A constraint that is neither a face nor
 * a union of marked faces goes to LostFacets, and no face then carries it. Further input points of
 * such a union lie on the facet exactly, Steiner points up to rounding.
 *
 * Surface Steiner points take their origin from the lowest facet that has them: on its edge between
 * two corners, else between three (ComposeOrigin).
 *
 * @param[in] raw ids in range
 * @throws Error Inconsistent, Stopped
 */
TetrahedralMesh AssembleMesh(const FacetComplex& surface, RawTetrahedra raw, Monitor& monitor);
} // namespace insideout
