// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/SurfacePatches.h"

#include <array>
#include <cstdint>

namespace insideout
{
/** A patch at a seam. Facets with a negative count are taken as turned over here. */
struct PatchAtSeam
{
  Id Patch;
  int Direction; ///< signed number of its facets that run along the seam; not 0

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

/** Patches, the counts of their facets, and the seams between them. */
struct SeamedPatches
{
  SurfacePatches Patches;

  std::vector<int> Count;   ///< one per patch: copies of each of its facets that count, at least 0
  std::vector<int> Weight;  ///< one per patch: the count of each copy; 1 unless there are very many
  std::vector<int> Opposed; ///< one per patch: pairs of copies that cancel, per facet
  std::vector<PatchSeam> Seams; ///< empty where there is one patch
  std::vector<Point> Points; ///< of the surface, scaled to below 1; empty where there is one patch

  /** The signed count of a patch along a seam. */
  std::int64_t RunOf(const PatchAtSeam& at) const
  {
    return static_cast<std::int64_t>(at.Direction) * this->Count[at.Patch] * this->Weight[at.Patch];
  }
};

/**
 * The patches of a surface and the seams where they meet: edges of more than two facets, or of two
 * that do not agree. A patch that balances at an edge by itself is left out there.
 *
 * @param[in] edges those of facets that count, or of whose copies some cancel
 */
SeamedPatches FindSeams(const FacetComplex& surface, const FacetEdges& edges);

/**
 * A facet's own orientation along the seam: PatchAtSeam has facets with a negative count turned
 * over.
 */
inline int SignOfCount(int multiplicity)
{
  return multiplicity < 0 ? -1 : 1;
}
} // namespace insideout
