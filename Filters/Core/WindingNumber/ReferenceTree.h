// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "WindingNumber/KnownBox.h"

namespace insideout
{
/**
 * A recursive bisection of a box, until its cells hold few facets each or cutting no longer
 * separates them. The winding number is carried to a reference place in every cell. Exact
 * predicates decide; if the line between two references meets an edge or a corner, another
 * reference is taken. Finding a site's cell takes time logarithmic in the number of facets.
 */
class ReferenceTree
{
public:
  /** A box with the facets that may meet it, and a point where the winding number is known. */
  struct Region
  {
    Box Bounds;
    Point Reference; ///< on no facet; need not be in the box
    double Value;
    std::vector<Id> Facets;
    std::vector<Id> Wanted = {};
    double Budget = 0; ///< limit of the facets of its leaves together
    int Depth = 0;
    int FruitlessSplits = 0; ///< futile divisions in a row
  };

  /**
   * @param[in] wanted the sites at which the winding number is wanted; null for all places.
   * Elsewhere it may be unknown.
   * @param[in] monitor asked if the region is large and built on all threads
   * @throws Error (Stopped)
   */
  ReferenceTree(const ChainFacets& facets, const std::vector<Point>* wanted, Region region,
    Monitor& monitor, const ProgressRange& progress);

  /** The known winding number around a site in the box. */
  KnownBox At(const RoundedSite& site) const;

private:
  /** Inner nodes are split across an axis; leaves have Axis -1 and their index in Children[0]. */
  struct Node
  {
    double Split;
    std::int32_t Axis;
    std::array<std::int32_t, 2> Children;
  };
  struct Leaf
  {
    Box Bounds;
    Point Reference;
    double Value;
    std::size_t FirstFacet;
    std::size_t LastFacet;
  };
  struct Arena
  {
    std::vector<Node> Nodes;
    std::vector<Leaf> Leaves;
    std::vector<SidedFacet> LeafFacets;
  };
  struct Job
  {
    std::int32_t Node;
    Region Work;
  };
  struct Split
  {
    int Axis;
    double Place;
  };
  class Builder;

  void Append(const Arena& arena, std::int32_t node);

  Arena Tree;
};
} // namespace insideout
