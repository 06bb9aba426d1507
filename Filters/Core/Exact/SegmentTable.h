// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <unordered_map>
#include <vector>

namespace insideout
{
/** The edges of facets, each once, and where Steiner points split them. */
class SegmentTable
{
public:
  explicit SegmentTable(const std::vector<Triangle>& facets);

  Id Size() const { return static_cast<Id>(this->Ends.size()); }

  /** The lower end first. */
  const std::array<Id, 2>& EndsOf(Id segment) const { return this->Ends[segment]; }

  /** The segment of edge k of a facet, which runs from corner k to the next. */
  Id OfFacet(Id facet, int k) const { return this->Segments[facet][k]; }

  /** The segment that an edge is (a piece of), None for none. */
  Id Find(Id u, Id v) const;

  /** All points from end to end. */
  std::vector<Id> Path(Id segment) const;

  /** Insert a Steiner point between two neighbors on the segment. */
  void Split(Id segment, Id u, Id v, Id steiner);

  /** Take a Steiner point out again. */
  void Join(Id segment, Id steiner);

  /** Let a segment go, which no facet needs any more. */
  void Release(Id segment);

  /** Have a segment again, without Steiner points, that was let go. */
  void Restore(Id segment);

  /** The points before and after a Steiner point. */
  std::array<Id, 2> NeighborsOnPath(Id segment, Id steiner) const;

private:
  static std::uint64_t Key(Id u, Id v);

  std::vector<std::array<Id, 2>> Ends;
  std::vector<std::array<Id, 3>> Segments;
  std::unordered_map<std::uint64_t, Id> OfEdge;
  std::unordered_map<Id, std::vector<Id>> Inner; ///< Steiner points of the segments that have some
};
} // namespace insideout
