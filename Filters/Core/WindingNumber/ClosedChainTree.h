// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/ReferenceGrid.h"
#include "WindingNumber/ReferenceTree.h"

#include <memory>

namespace insideout
{
/**
 * The winding number of a closed chain of triangles, exactly, for any number of sites.
 *
 * Space is cut into boxes that hold few triangles each, and the winding number is known at one
 * reference place in every box. At a site it is that of its box's reference plus the signed count
 * of the box's triangles between the two. Exact predicates decide; if the line between them meets
 * an edge or a corner a detour is made. In a box that no triangle meets there is nothing to count.
 * The boxes are the cubes of a grid, about twice as many as triangles at most; those which hold
 * many triangles are cut further, so that time grows at most with the logarithm of their number.
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

  /** The same for wanted sites only, which is faster if they are few: `wanted` are the rounded
   * sites, RoundedSite::High. At any other site the winding number is NaN or right. */
  ClosedChainTree(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles,
    const std::vector<Point>& wanted, Monitor& monitor, const ProgressRange& progress);

  ClosedChainTree(const ClosedChainTree&) = delete;
  void operator=(const ClosedChainTree&) = delete;

  /**
   * The winding number at a site: a whole number, except on the chain, where it is right to about
   * 1e-15. Thread-safe.
   */
  double At(const Site& site) const;

  /** At a point. */
  double At(const Point& point) const;

  /**
   * Set w[order[i]] to the winding number at site order[i], for all i.
   *
   * @throws Error (Stopped)
   */
  void Evaluate(const Sites& sites, const std::vector<Id>& order, std::vector<double>& w,
    Monitor& monitor, const ProgressRange& progress) const;

  /** Set w[i] to the winding number at points[i], for all i. */
  void Evaluate(const std::vector<Point>& points, std::vector<double>& w, Monitor& monitor,
    const ProgressRange& progress) const;

  const ChainFacets& AllFacets() const { return this->Facets; }

private:
  void Build(const std::vector<Point>* wanted, Monitor& monitor, const ProgressRange& progress);
  void BuildTrees(
    const std::vector<Point>* wanted, Monitor& monitor, const ProgressRange& progress);
  void BuildOneTree(
    const std::vector<Point>* wanted, Monitor& monitor, const ProgressRange& progress);

  std::size_t TreeOf(std::size_t cube) const;

  /** False if no triangle is near, and w is already known. */
  bool Locate(const RoundedSite& site, KnownBox& box, double& w) const;

  const ChainFacets Facets;
  std::unique_ptr<ReferenceGrid> Grid; ///< none if doubles did not decide
  std::vector<char> IsWanted;          ///< of the grid's cubes; empty for all

  /** One per grid cube that holds many facets; without a grid, one for the whole chain. */
  std::vector<std::unique_ptr<const ReferenceTree>> Trees;
  std::vector<std::size_t> Crowded; ///< those cubes, ascending
  Box Whole;                        ///< index of the single tree
};
} // namespace insideout
