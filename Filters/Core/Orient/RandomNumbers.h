// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cmath>
#include <cstdint>

namespace insideout
{
/** Reproducible random numbers, one sequence per seed (Steele, Lea and Flood's SplitMix 2014). */
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint64_t seed)
    : State(seed * 0xD1342543DE82EF95u + 0x9E3779B97F4A7C15u)
  {
  }

  /** At least 0, below 1. */
  double Next()
  {
    this->State += 0x9E3779B97F4A7C15u;
    std::uint64_t bits = this->State;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    bits ^= bits >> 31;
    return static_cast<double>(bits >> 11) * 0x1p-53;
  }

  /** A direction, uniformly distributed. */
  Point OnSphere()
  {
    for (;;)
    {
      const Point p = { 2 * this->Next() - 1, 2 * this->Next() - 1, 2 * this->Next() - 1 };
      const double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      if (square <= 1 && square > 0x1p-20)
      {
        const double length = std::sqrt(square);
        return { p[0] / length, p[1] / length, p[2] / length };
      }
    }
  }

private:
  std::uint64_t State;
};
} // namespace insideout
