// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/DoubleDouble.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insideout
{
/** Three vectors, and the common error bound of their components. */
template <typename Number>
struct Rows
{
  std::array<std::array<Number, 3>, 3> Entries;
  std::array<double, 3> Errors;
};

/** Relative error of a sum or product of doubles. */
constexpr double DoubleEpsilon = 0x1p-53;

/** Sizes at which products of three neither over- nor underflow. */
constexpr double SmallestSize = 1e-90;
constexpr double LargestSize = 1e90;

/** SignOfDeterminant's result if uncertain. */
constexpr int Undecided = 2;

/** The sign of the vectors' determinant, if certain. */
template <typename Number>
int SignOfDeterminant(const Rows<Number>& rows, double epsilon)
{
  const auto& m = rows.Entries;
  std::array<double, 3> sizes;
  for (int k = 0; k < 3; ++k)
  {
    sizes[k] = rows.Errors[k] +
      std::max({ std::abs(static_cast<double>(m[0][k])), std::abs(static_cast<double>(m[1][k])),
        std::abs(static_cast<double>(m[2][k])) });
    if (sizes[k] == 0) // exactly, in a plane across an axis
    {
      return 0;
    }
    if (!(sizes[k] > SmallestSize && sizes[k] < LargestSize))
    {
      return Undecided;
    }
  }
  const double determinant = static_cast<double>(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
  // Six products, each with an error in one of its factors and of some 16 roundings.
  const double bound = 7 *
      (rows.Errors[0] * sizes[1] * sizes[2] + sizes[0] * rows.Errors[1] * sizes[2] +
        sizes[0] * sizes[1] * rows.Errors[2]) +
    100 * epsilon * sizes[0] * sizes[1] * sizes[2];
  return determinant > bound ? 1 : determinant < -bound ? -1 : Undecided;
}
} // namespace insideout
