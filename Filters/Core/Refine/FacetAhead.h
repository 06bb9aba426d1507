// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableMesh.h"

namespace insideout
{
/** Where a ray into the solid begins. */
struct RayStart
{
  Point From;
  Id Cell;
  int Entry = -1; ///< the face of the cell that it comes through, opposite to this corner; or -1
  int Exit = -1;  ///< the only face that it may leave the cell by; -1: any
};

/** The facet that a ray meets first. */
struct FacetAhead
{
  double Way; ///< distance to the facet; else as far as rounding let it be followed, or infinite
  Id Cell;    ///< in front of it; None: there is no facet within the distance asked for
  int Face;   ///< opposite to this corner
};

/**
 * Follow a ray through cells to a facet.
 *
 * @param[in] enough facets farther than this do not matter
 */
FacetAhead FindFacetAhead(
  const RefinableMesh& mesh, const RayStart& start, const Point& direction, double enough);
} // namespace insideout
