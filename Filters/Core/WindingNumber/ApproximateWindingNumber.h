// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/FarField.h"

namespace insideout
{
/**
 * The winding number by a far-field expansion (Barill, Dickson, Schmidt, Levin and Jacobson 2018):
 * a tree of facets in which a node that is far enough away counts as the first terms of the Taylor
 * series about its center. Within the leaves that are near, facets count exactly. Errs by some 1e-3
 * at the usual setting, second order and accuracy 2; the error shrinks about as
 * accuracy^-(order + 1).
 */
class ApproximateWindingNumber
{
public:
  /**
   * @param[in] points below 1 in each coordinate; has to live as long as this object
   * @param[in] order of the expansion, 1 to 3
   * @param[in] accuracy how many of its radii away from its center a node is far, at least 1
   * @throws Error (InvalidParameter)
   */
  ApproximateWindingNumber(const std::vector<Point>& points, std::vector<CountedTriangle> triangles,
    int order, double accuracy);

  double At(const Point& p) const;

private:
  struct Expansion
  {
    FarField Field;
    double SquaredReach; ///< squared, radius times accuracy
  };

  Expansion Expand(Id part) const;

  const std::vector<Point>& Points;
  const std::vector<CountedTriangle> Triangles;
  const int Order;
  const double Accuracy;
  const BoxTree Tree;
  std::vector<Expansion> Expansions; ///< one per part of the tree
};
} // namespace insideout
