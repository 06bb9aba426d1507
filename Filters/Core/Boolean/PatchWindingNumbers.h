// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Orient/SurfacePatches.h"
#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/** Winding numbers on both sides of a patch, at one of its facets; the normal points to the
 * front. */
struct PatchSides
{
  int Front;
  int Back;
};

/**
 * The winding numbers of closed chains on both sides of patches, without any mesh. One exact query
 * in the middle of a patch's largest facet gives the mean of both sides, and the facet's
 * multiplicity is their difference. Both are constant along the patch. They decide which patches a
 * set operation keeps (Zhou, Grinspun, Zorin and Jacobson 2016).
 */
class PatchPlaces
{
public:
  /** @param[in] surface resolved: its facets meet in shared points and edges only */
  PatchPlaces(const FacetComplex& surface, const SurfacePatches& patches);

  /**
   * The facet that represents a patch: the largest; of several equal ones, the one with the lowest
   * id.
   */
  Id FacetOf(Id patch) const { return this->Largest[patch]; }

  /**
   * The winding numbers of a chain of the surface's facets on both sides of all patches.
   *
   * @param[in] chain without boundary
   * @param[in] counts one per patch: the multiplicity of its FacetOf in the chain
   * @return one per patch
   * @throws Error (Stopped)
   */
  std::vector<PatchSides> WindingNumbers(const std::vector<CountedTriangle>& chain,
    const std::vector<int>& counts, Monitor& monitor, const ProgressRange& progress) const;

private:
  std::vector<Point> Points; ///< of the surface, scaled
  std::vector<Id> Largest;
  std::vector<Tetrahedron> Middles;
};
} // namespace insideout
