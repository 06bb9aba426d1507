// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Clouds/PointCloud.h"
#include "Common/BoxTree.h"
#include "WindingNumber/FarField.h"

namespace insideout
{
/**
 * The winding number of a point cloud (Barill, Dickson, Schmidt, Levin and Jacobson 2018): each
 * point is a dipole, so that with areas a_i, unit normals n_i and places p_i
 *
 *     w(q) = sum over i of a_i n_i . (p_i - q) / (4 pi |p_i - q|^3).
 *
 * Near a point its term is unbounded; closer to points than their spacing, w is meaningless. So
 * within the radius r_i of a disk of the point's area, pi r_i^2 = a_i, the term is a_i n_i . (p_i -
 * q) / (4 pi r_i^3): it is 0 at the point itself, at most 1/4, and continuous. (It is the field of
 * a dipole spread evenly over a ball.)
 *
 * The sum is over all points, or over a tree in which a far node is replaced by the first three
 * terms of a Taylor series. The n-th term of a point at distance d from the node's center is at
 * most n a d^(n - 1) / (4 pi r^(n + 1)), at r from the center. So for a node of radius R, and with
 * t = R / r, the remainder is at most
 *
 *     (sum of a_i d_i^3) / (4 pi r^5) * (4 - 3 t) / (1 - t)^2.
 *
 * A node is far if this is at most Accuracy times (sum of a_i) / (4 pi (r + R)^2), so that in total
 *
 *     error  <=  Accuracy * sum over i of a_i / (4 pi |p_i - q|^2),
 *
 * the sum without the cosines: some 1 to 3 near a closed cloud. Remainders have both signs, and
 * actual errors are a hundredth of the bound.
 */
class CloudWindingNumber
{
public:
  static constexpr double Accuracy = 1e-2;

  /**
   * @param[in] cloud from CheckedCloud
   * @param[in] sums whether to sum over all points, without the tree
   */
  CloudWindingNumber(const PointCloud& cloud, bool sums);

  /** At one place; NaN if it is not finite. Thread-safe. */
  double At(const Point& place) const;

  /**
   * At each of several places; the same as one by one.
   *
   * @throws Error (Stopped)
   */
  std::vector<double> At(
    const std::vector<Point>& places, Monitor& monitor, const ProgressRange& progress) const;

  /** The gradient of w, by the same nodes and points, without an error bound; 0 if the place is not
   * finite. Thread-safe. */
  Point Gradient(const Point& place) const;

private:
  struct Dipole
  {
    Point Where;
    Point VectorArea;
    double SquaredRadius; ///< radius of a disk of its area
  };

  /** A node of the tree. */
  struct Far
  {
    FarField Field;
    double SquaredReach; ///< distance from which it counts as far
  };

  static std::vector<Dipole> DipolesOf(const PointCloud& cloud, int exponent);
  static std::vector<Box> BoxesOf(const std::vector<Dipole>& dipoles);
  Far FarOf(Id part) const;
  template <class VisitFar, class VisitNear>
  void Visit(const Point& scaled, const VisitFar& visitFar, const VisitNear& visitNear) const;

  int Exponent;
  std::vector<Dipole> Dipoles; ///< scaled, coordinates and areas to at most 1
  BoxTree Tree;
  std::vector<Far> Parts; ///< one per node of the tree; none when summing all points
};
} // namespace insideout
