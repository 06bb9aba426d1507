// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** A surface as given: points and triangles, unchecked. */
struct TriangleSoup
{
  std::vector<Point> Points;
  std::vector<Triangle> Triangles;

  /** The count of each triangle, if known (a resolved surface); else empty. */
  std::vector<std::int16_t> Multiplicity = {};

  /** Not 0 for triangles that shape the mesh but do not count; empty if all count. */
  std::vector<unsigned char> NonParticipating = {};
};

/**
 * The origin of a point: the input points it interpolates, with weights that sum to 1. An input
 * point, and no other, is {i, i, i} with weights {1, 0, 0}; points near i may have these weights,
 * rounded, with other ids. A Steiner point in the volume has no origin: {None, None, None}.
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

/**
 * An input triangle that a facet is a piece of, and whether the facet is oriented the other way.
 */
struct FacetSource
{
  Id Triangle;
  bool Reversed;
};

/**
 * Facets with their counts: the surface between the stages. After validation no two facets have the
 * same three points and none is degenerate; after resolving, no two constraints meet except in
 * shared points and edges, and no point lies within a constraint or an edge of one.
 *
 * Facet f is made of the input triangles Sources[SourceOffsets[f]] to Sources[SourceOffsets[f +
 * 1]], repeated for each of its pieces there. Multiplicity[f] is their signed count along the
 * facet's own orientation by the rules of the counted chain (CountedChain.h), which may be 0.
 */
struct FacetComplex
{
  std::vector<Point> Points;
  std::vector<PointOrigin> Origins; ///< one per point
  std::vector<Triangle> Facets;
  std::vector<std::int16_t> Multiplicity; ///< one per facet

  /**
   * After validation, one per facet: the number of pairs of opposite copies that cancel; else
   * empty.
   */
  std::vector<std::int16_t> Opposed = {};

  std::vector<Id> SourceOffsets = { 0 }; ///< one per facet, and the end
  std::vector<FacetSource> Sources;      ///< sorted by triangle within a facet

  /** One per source: the closed surface among those appended in the input that its triangle belongs
   * to (GivenSurfaces.h). Set by CountFacets if edges are non-manifold, else empty. */
  std::vector<Id> SourceSurfaces = {};

  /**
   * Facets from here on could not be resolved: they are not constraints (they may cross others),
   * but still count in the winding number. At most Facets.size(), and nearly always equal to it.
   */
  Id NumberOfConstraints = 0;

  Id NumberOfFacets() const { return static_cast<Id>(this->Facets.size()); }
};

/**
 * The lowest input triangle that a facet is a piece of, preferring those whose normal is on `side`
 * (+1 the facet's own, -1 the other).
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
