// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** A surface as it was given: points and triangles, nothing checked. */
struct TriangleSoup
{
  std::vector<Point> Points;
  std::vector<Triangle> Triangles;

  /** How often each triangle counts, where that is known (a resolved surface); else empty. */
  std::vector<std::int16_t> Multiplicity = {};

  /** Not 0 for triangles that shape the mesh but do not count; empty where every triangle does. */
  std::vector<unsigned char> NonParticipating = {};
};

/**
 * Where a point comes from: the input points it interpolates and their weights (which sum to 1). An
 * input point is {i, i, i} with weights {1, 0, 0}, and no other point is, though one that is near
 * to i may have these weights, rounded; a Steiner point in the volume comes from nowhere: {None,
 * None, None}.
 */
struct PointOrigin
{
  Triangle Points{ { None, None, None } };
  std::array<double, 3> Weights{ { 1, 0, 0 } };

  static PointOrigin Input(Id point) { return { { { point, point, point } }, { { 1, 0, 0 } } }; }

  /** A new point that has the data of one input point. */
  static PointOrigin Like(Id point) { return { { { point, point, point } }, { { 0.5, 0.5, 0 } } }; }

  bool IsInput() const
  {
    const auto& [a, b, c] = this->Points;
    return a != None && a == b && b == c && this->Weights[0] == 1;
  }
};

/** An input triangle that a facet is a piece of, and whether the facet runs the other way. */
struct FacetSource
{
  Id Triangle;
  bool Reversed;
};

/**
 * Facets with what they count: the surface between the stages. After validation no two facets have
 * the same three points and none is degenerate; after resolving, no two constraints meet except in
 * shared points and edges, and no point lies within a constraint or an edge of one.
 *
 * Facet f is made of the input triangles Sources[SourceOffsets[f]] to Sources[SourceOffsets[f +
 * 1]], one as often as pieces of it lie there. Multiplicity[f] is their signed count along the
 * facet's own orientation by the rules of the counted chain (CountedChain.h), which may be 0.
 */
struct FacetComplex
{
  std::vector<Point> Points;
  std::vector<PointOrigin> Origins; ///< one per point
  std::vector<Triangle> Facets;
  std::vector<std::int16_t> Multiplicity; ///< one per facet

  /** After validation, one per facet: how many pairs of opposite copies cancel; else empty. */
  std::vector<std::int16_t> Opposed = {};

  std::vector<Id> SourceOffsets = { 0 }; ///< one per facet, and the end
  std::vector<FacetSource> Sources;      ///< sorted by triangle within a facet

  /** One per source: the closed surface among those appended in the input that its triangle belongs
   * to (GivenSurfaces.h). Set by CountFacets if edges are non-manifold, else empty. */
  std::vector<Id> SourceSurfaces = {};

  /**
   * Facets from here on could not be resolved: they are no constraints (they may cross others), but
   * still count in the winding number. At most Facets.size(), and equal to it nearly always.
   */
  Id NumberOfConstraints = 0;

  Id NumberOfFacets() const { return static_cast<Id>(this->Facets.size()); }
};

/**
 * The lowest input triangle that a facet is a piece of: of those whose normal is on `side` (+1 the
 * facet's own, -1 the other) if there is one.
 */
inline Id SourceOfFacet(const FacetComplex& surface, Id facet, int side)
{
  const Id first = surface.SourceOffsets[facet];
  for (Id s = first; s < surface.SourceOffsets[facet + 1]; ++s)
  {
    if (surface.Sources[s].Reversed == (side < 0))
    {
      return surface.Sources[s].Triangle;
    }
  }
  return surface.Sources[first].Triangle;
}
} // namespace insideout
