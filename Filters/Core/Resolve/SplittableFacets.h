// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/Edge.h"
#include "Common/Types.h"

#include <map>
#include <vector>

namespace insideout
{
bool HasCorner(const Triangle& corners, Id point);

/** A facet that replaces a part of another one. */
struct ReplacedFacet
{
  Triangle Corners; ///< with the parent's orientation
  Id Parent;
};

/** The facets that replace a list of facets. */
struct Replacement
{
  std::vector<Id> Removed; ///< ascending
  std::vector<ReplacedFacet> Added;
};

/**
 * Facets that can be split at an edge, all facets along it at once, so that closed chains stay
 * closed. New parts are numbered after the given facets.
 */
class SplittableFacets
{
public:
  /** Keeps a reference to the facets. */
  SplittableFacets(std::size_t numberOfPoints, const std::vector<Triangle>& facets);

  const Triangle& CornersOf(Id f) const;

  /** Whether it was neither split nor removed. */
  bool IsThere(Id f) const { return this->IsAlive[f] != 0; }

  /**
   * The parts that splitting an edge would make of the facets along it; none of a facet that has
   * the point as a corner.
   */
  std::vector<ReplacedFacet> PartsOfSplit(const Edge& edge, Id point) const;

  /**
   * Split the facets along an edge.
   * @return the number of the first part; later parts follow
   */
  Id Split(const Edge& edge, Id point);

  /** Split a facet into three at a point, which becomes a corner of each. */
  void SplitFacet(Id f, Id point);

  void Remove(Id f) { this->IsAlive[f] = 0; }

  Id Count() const { return static_cast<Id>(this->IsAlive.size()); }

  Replacement Result() const;

private:
  std::vector<Id> FacetsAlong(const Edge& edge) const;
  Id ParentOf(Id f) const;
  void Replace(const std::vector<Id>& facets, const std::vector<ReplacedFacet>& parts);

  const std::vector<Triangle>& Given;
  const Buckets<Id> AtPoints; ///< the given facets at each point
  std::vector<ReplacedFacet> Added;
  std::vector<char> IsAlive;
  std::map<Edge, std::vector<Id>> AddedAlong;
};
} // namespace insideout
