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
 * Near a point its term grows beyond all bounds; and between points, nearer to them than they are
 * to each other, w means nothing. So within the radius r_i of a disk of the point's area, pi r_i^2
 * = a_i, the term is a_i n_i . (p_i - q) / (4 pi r_i^3): it falls to 0 at the point itself, is at
 * most 1/4, and has no step. (It is the field of a dipole that is spread evenly over a ball.)
 *
 * Sums over all points, or over a tree, in which the points of a part that is far away count as the
 * first three terms of a Taylor series. The n-th term of a point that is d from the part's center
 * is at most n a d^(n - 1) / (4 pi r^(n + 1)), at r from the center. So of a part with points at
 * most R from it, and with t = R / r, what is left out is at most
 *
 *     (sum of a_i d_i^3) / (4 pi r^5) * (4 - 3 t) / (1 - t)^2.
 *
 * A part is far where this is at most Accuracy times (sum of a_i) / (4 pi (r + R)^2), so that in
 * all
 *
 *     error  <=  Accuracy * sum over i of a_i / (4 pi |p_i - q|^2),
 *
 * the sum without the cosines: some 1 to 3 beside a closed cloud. The terms left out have both
 * signs, and errors are a hundredth of that.
 */
class CloudWindingNumber
{
public:
  static constexpr double Accuracy = 1e-2;

  /**
   * @param[in] cloud that was checked
   * @param[in] sums whether to sum over all points, without the tree
   */
  CloudWindingNumber(const PointCloud& cloud, bool sums);

  /** At one place; NaN where it is not finite. Safe to call from several threads. */
  double At(const Point& place) const;

  /**
   * At each of several places; the same as one by one.
   *
   * @throws Error (Stopped)
   */
  std::vector<double> At(
    const std::vector<Point>& places, Monitor& monitor, const ProgressRange& progress) const;

  /** By how much w rises per unit of length: of the same parts and points, without a bound on its
   * error; 0 where the place is not finite. Safe to call from several threads. */
  Point Gradient(const Point& place) const;

private:
  struct Dipole
  {
    Point Where;
    Point VectorArea;
    double SquaredRadius; ///< of a disk of its area
  };

  /** A part of the tree. */
  struct Far
  {
    FarField Field;
    double SquaredReach; ///< from where on it counts as far
  };

  static std::vector<Dipole> DipolesOf(const PointCloud& cloud, int exponent);
  static std::vector<Box> BoxesOf(const std::vector<Dipole>& dipoles);
  Far FarOf(Id part) const;
  template <class VisitFar, class VisitNear>
  void Visit(const Point& scaled, const VisitFar& visitFar, const VisitNear& visitNear) const;

  int Exponent;
  std::vector<Dipole> Dipoles; ///< scaled, coordinates and areas to at most 1
  BoxTree Tree;
  std::vector<Far> Parts; ///< one per part of the tree; none where it sums
};
} // namespace insideout
