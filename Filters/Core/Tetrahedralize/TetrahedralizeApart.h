// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Tetrahedralize/ConstrainedDelaunay.h"

namespace insideout
{
/**
 * As ConstrainedDelaunay, but each of the surface's parts (PartsApart.h) has a convex hull of its
 * own, which is tetrahedralized by a thread of its own: there are no cells between them. A surface
 * of one part becomes the same mesh, bit by bit.
 *
 * Points are the complex's in their order, then the Steiner points of one part after the other, as
 * the cells are. Rung is the last one on the ladder that a part took; reasons of failed rungs name
 * the part by one of its input points. A time budget is divided among the parts by their facets;
 * the memory budget holds for each part.
 *
 * The same for any number of threads.
 *
 * @param[in] surface resolved
 * @throws Error as ConstrainedDelaunay, naming the part
 */
Tetrahedralization TetrahedralizeApart(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters, Monitor& monitor);
} // namespace insideout
