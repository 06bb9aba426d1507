// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "CountedBoundary.h"
#include "ParallelLoop.h"
#include "SitePredicates.h"

namespace insideout
{
/**
 * The winding number of a closed chain of triangles, exactly, for any number of sites.
 *
 * Space is cut into boxes that hold few triangles each, and the winding number is known at one
 * reference place in every box. At a site it is that of its box's reference plus the signed count
 * of the box's triangles between the two: exact predicates decide, and where the line between them
 * meets an edge or a corner a detour is made. In a box that no triangle meets there is nothing to
 * count. Time grows with the logarithm of the number of triangles.
 *
 * On the chain itself the winding number is the mean of its values around the site, weighted by
 * solid angle: halfway between both sides on a triangle, the dihedral angle over 2 pi on the edge
 * of a solid, the solid angle over 4 pi on its corner.
 */
class ClosedChainTree
{
public:
  /**
   * @param[in] points below 1 in each coordinate
   * @param[in] triangles not degenerate; their boundary is empty
   * @throws Error (Stopped)
   */
  ClosedChainTree(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles,
    Monitor& monitor, const ProgressRange& progress);

  /** The same for sites near certain places only, which is quicker where these are few: `wanted`
   * are the rounded sites, RoundedSite::High. At any other site the winding number is NaN or right.
   */
  ClosedChainTree(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles,
    const std::vector<Point>& wanted, Monitor& monitor, const ProgressRange& progress);

  /**
   * The winding number at a site. It is a whole number but on the chain, where it is right to about
   * 1e-15. Safe to call from several threads.
   */
  double At(const Site& site) const;

  /**
   * Set w[order[i]] to the winding number at site order[i], for all i, on all threads. Fastest
   * where neighbours in `order` are neighbours in space.
   *
   * @throws Error (Stopped)
   */
  void Evaluate(const Sites& sites, const std::vector<Id>& order, std::vector<double>& w,
    Monitor& monitor, const ProgressRange& progress) const;

private:
  struct Facet
  {
    PlaneOfTriangle Plane;
    std::array<Point, 3> Corners;
    int Count;
  };
  struct FacetBox
  {
    Point Low;
    Point High;
  };
  /** Inner nodes are split across an axis; leaves have Axis -1 and their index in Children[0]. */
  struct Node
  {
    double Split;
    std::int32_t Axis;
    std::array<std::int32_t, 2> Children;
  };
  struct Leaf
  {
    Point Low; ///< of its box
    Point High;
    Point Reference;
    double Value; ///< the winding number at the reference
    std::size_t FirstFacet;
    std::size_t LastFacet;
  };
  struct Arena
  {
    std::vector<Node> Nodes;
    std::vector<Leaf> Leaves;
    std::vector<Id> LeafFacets;
    std::vector<std::int8_t> ReferenceSides; ///< one per LeafFacet
  };
  /** A box with the facets that may meet it, and where the winding number is known. */
  struct Region
  {
    Point Low;
    Point High;
    Point Reference;
    double Value;
    std::vector<Id> Facets;
    int Depth;
    int FruitlessSplits; ///< in a row
    double Budget;       ///< how many facets its leaves may have together
    std::vector<Id> Wanted;
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

  Split ChooseSplit(const Region& region) const;
  bool FitsLeaf(const Region& region) const;
  bool MayMeet(Id facet, const Point& low, const Point& high) const;
  bool FindReference(const Region& parent, Region& child, int axis) const;
  bool Divide(const Region& region, Split& split, std::array<Region, 2>& children) const;
  std::vector<Id> FacetsBetween(
    const std::vector<Id>& facets, const Point& a, const Point& b) const;
  void Build(Region region, std::int32_t node, Arena& arena, std::vector<Job>* jobs) const;
  void Append(const Arena& arena, std::int32_t node);

  void BuildAll(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles,
    Monitor& monitor, const ProgressRange& progress);
  void AddLeaf(const Region& region, std::int32_t node, Arena& arena) const;

  const Leaf& LeafOf(const RoundedSite& site) const;
  double AtInLeaf(const Leaf& leaf, const PreparedSite& site) const;
  /** Facets, and on which side of each the place is that a line goes to, if that is known. */
  struct FacetRange
  {
    const Id* First;
    const Id* Last;
    const std::int8_t* Sides;
  };
  bool CountCrossings(const FacetRange& facets, const PreparedSite& from, const Point& to,
    std::vector<Id>* touched, double& sum) const;
  double AngleOfTouched(
    const std::vector<Id>& touched, const PreparedSite& site, const Point& towards) const;

  std::vector<Facet> Facets;
  std::vector<FacetBox> Boxes;
  std::vector<Point> Wanted;
  bool WantsAll = true;
  Arena Tree;
};
} // namespace insideout
