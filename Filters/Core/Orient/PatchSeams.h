// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SurfacePatches.h"

#include <array>
#include <cstdint>

namespace insideout
{
/** A patch at a seam. Facets that count negatively are taken as turned over here. */
struct PatchAtSeam
{
  Id Patch;
  int Direction; ///< how often its facets run along the seam, less the other way; not 0

  bool operator==(const PatchAtSeam& other) const
  {
    return this->Patch == other.Patch && this->Direction == other.Direction;
  }
};

/** Edges at which the same patches meet in the same way. */
struct PatchSeam
{
  std::vector<PatchAtSeam> Patches; ///< by patch
  double Length;                    ///< of scaled points
  std::array<Id, 2> Longest;        ///< range in the sorted edges: the facets at the longest edge
  Id Counting;                      ///< of these facets: that do not count 0
};

/** Patches, how often their facets count, and the seams between them. */
struct SeamedPatches
{
  SurfacePatches Patches;

  std::vector<int> Count;   ///< one per patch: copies of each of its facets that count, at least 0
  std::vector<int> Weight;  ///< one per patch: how often each copy counts; 1 but for very many
  std::vector<int> Opposed; ///< one per patch: pairs of copies that cancel, of each of its facets
  std::vector<PatchSeam> Seams; ///< empty where there is one patch
  std::vector<Point> Points; ///< of the surface, scaled to below 1; empty where there is one patch

  /** How often a patch runs along a seam, counted, less the other way. */
  std::int64_t RunOf(const PatchAtSeam& at) const
  {
    return static_cast<std::int64_t>(at.Direction) * this->Count[at.Patch] * this->Weight[at.Patch];
  }
};

/**
 * The patches of a surface and where they meet: where there are more than two facets, or two that
 * do not agree. A patch that balances at an edge by itself is not told of there.
 *
 * @param[in] edges those of facets that count, or of whose copies some cancel
 */
SeamedPatches FindSeams(const FacetComplex& surface, const std::vector<FacetEdge>& edges);

/** A facet's own orientation, less what PatchAtSeam says of those that count negatively. */
inline int SignOfCount(int multiplicity)
{
  return multiplicity < 0 ? -1 : 1;
}
} // namespace insideout
