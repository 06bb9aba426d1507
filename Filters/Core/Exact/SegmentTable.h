// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/Types.h"

#include <memory>
#include <unordered_map>
#include <vector>

namespace insideout
{
/**
 * The edges of facets, each once, and the Steiner points that split them. Steiner points have
 * higher ids than all corners of facets. Copies share the constant data.
 */
class SegmentTable
{
public:
  explicit SegmentTable(const std::vector<Triangle>& facets);

  Id Size() const { return static_cast<Id>(this->Given->Ends.size()); }

  /** The lower end first. */
  const std::array<Id, 2>& EndsOf(Id segment) const { return this->Given->Ends[segment]; }

  /** The segment of edge k of a facet, which runs from corner k to the next. */
  Id OfFacet(Id facet, int k) const { return this->Given->OfFacets[facet][k]; }

  /** The segment that an edge is, or is a piece of; None for none. */
  Id Find(Id u, Id v) const;

  /** Whether Steiner points split it. */
  bool IsSplit(Id segment) const { return this->Inner.count(segment) > 0; }

  /** All points from end to end. */
  std::vector<Id> Path(Id segment) const;

  /** The segment that a Steiner point lies within, None for none. */
  Id Around(Id steiner) const;

  /** Insert a Steiner point between two neighbors on the segment. */
  void Split(Id segment, Id u, Id v, Id steiner);

  /** Remove a Steiner point. */
  void Join(Id segment, Id steiner);

  /** Release a segment that no facet needs any more. */
  void Release(Id segment);

  /** Reinstate a released segment, without Steiner points. */
  void Restore(Id segment);

  /** The points before and after a Steiner point. */
  std::array<Id, 2> NeighborsOnPath(Id segment, Id steiner) const;

private:
  static std::uint64_t Key(Id u, Id v);

  struct HigherEnd
  {
    Id Vertex;
    Id Segment;
  };
  struct GivenEdges
  {
    std::vector<std::array<Id, 2>> Ends;
    std::vector<std::array<Id, 3>> OfFacets;
    Buckets<HigherEnd> ByLowerEnd; ///< ascending
  };

  std::shared_ptr<const GivenEdges> Given;
  std::vector<char> IsWhole;                     ///< per segment: neither released nor split
  std::unordered_map<std::uint64_t, Id> OfPiece; ///< the segments of edges at Steiner points
  std::unordered_map<Id, std::vector<Id>> Inner; ///< Steiner points of the segments that have some
  std::unordered_map<Id, Id> OfPoint;            ///< and the segment of each of these points
};
} // namespace insideout
