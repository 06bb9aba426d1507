// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <array>

namespace insideout
{
/**
 * The far field of facets or dipoles (Barill, Dickson, Schmidt, Levin and Jacobson 2018): the first
 * three terms of the Taylor series about a center. A vector area n at x contributes
 *
 *     w(p) = n . (x - p) / (4 pi |x - p|^3).
 *
 * Its derivatives are symmetric in the axes, and so are the stored moments.
 */
struct FarField
{
  Point Centre = {};
  Point First = {};                  ///< sum of the vector areas n
  std::array<double, 6> Second = {}; ///< mean of n_i d_j over orders, d from the center: SecondAxes
  std::array<double, 10> Third = {}; ///< mean of n_i d_j d_k over orders: ThirdAxes

  static constexpr std::array<std::array<int, 2>, 6> SecondAxes = { { { { 0, 0 } }, { { 1, 1 } },
    { { 2, 2 } }, { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } } } };
  static constexpr std::array<std::array<int, 3>, 10> ThirdAxes = { { { { 0, 0, 0 } },
    { { 1, 1, 1 } }, { { 2, 2, 2 } }, { { 0, 0, 1 } }, { { 0, 0, 2 } }, { { 0, 1, 1 } },
    { { 1, 1, 2 } }, { { 0, 2, 2 } }, { { 1, 2, 2 } }, { { 0, 1, 2 } } } };

  /** Add a vector area distributed over offsets d from the center: the means of d_j and, in the
   * order of SecondAxes, of d_j d_k. */
  void Add(const Point& n, const Point& mean, const std::array<double, 6>& meanOfProducts);

  /** Add a vector area at a single offset d from the center. */
  void AddDipole(const Point& n, const Point& d);

  /** w by this number of terms, 1 to 3; r leads from the place to the center. */
  double At(const Point& r, int terms) const;

  /** The gradient of w by all three terms there. */
  Point Gradient(const Point& r) const;
};
} // namespace insideout
