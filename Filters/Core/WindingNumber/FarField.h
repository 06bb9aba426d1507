// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <array>

namespace insideout
{
/**
 * What facets or dipoles count far away from them (Barill, Dickson, Schmidt, Levin and Jacobson
 * 2018): the first three terms of the Taylor series about a centre. A vector area n at x counts
 *
 *     w(p) = n . (x - p) / (4 pi |x - p|^3).
 *
 * As the derivatives of this are the same for any order of axes, so are the moments that are kept.
 */
struct FarField
{
  Point Centre = {};
  Point First = {};                  ///< sum of the vector areas n
  std::array<double, 6> Second = {}; ///< mean of n_i d_j over orders, d from the centre: SecondAxes
  std::array<double, 10> Third = {}; ///< mean of n_i d_j d_k over orders: ThirdAxes

  static constexpr std::array<std::array<int, 2>, 6> SecondAxes = { { { { 0, 0 } }, { { 1, 1 } },
    { { 2, 2 } }, { { 0, 1 } }, { { 1, 2 } }, { { 2, 0 } } } };
  static constexpr std::array<std::array<int, 3>, 10> ThirdAxes = { { { { 0, 0, 0 } },
    { { 1, 1, 1 } }, { { 2, 2, 2 } }, { { 0, 0, 1 } }, { { 0, 0, 2 } }, { { 0, 1, 1 } },
    { { 1, 1, 2 } }, { { 0, 2, 2 } }, { { 1, 2, 2 } }, { { 0, 1, 2 } } } };

  /** Add a vector area whose places d from the centre have these means, of d_j and, in the order of
   * SecondAxes, of d_j d_k. */
  void Add(const Point& n, const Point& mean, const std::array<double, 6>& meanOfProducts);

  /** Add a vector area in a single place, d from the centre. */
  void AddDipole(const Point& n, const Point& d);

  /** w by this number of terms, 1 to 3, at a place from which r leads to the centre. */
  double At(const Point& r, int terms) const;

  /** The gradient of w by all three terms there. */
  Point Gradient(const Point& r) const;
};
} // namespace insideout
