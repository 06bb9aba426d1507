// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"

#include <algorithm>

namespace insideout
{
/** Add figures to those of the same name; append the others. */
inline void AddUp(const Statistics& figures, Statistics& sums)
{
  for (const auto& figure : figures)
  {
    const auto sum = std::find_if(
      sums.begin(), sums.end(), [&](const auto& other) { return other.first == figure.first; });
    if (sum == sums.end())
    {
      sums.push_back(figure);
    }
    else
    {
      sum->second += figure.second;
    }
  }
}
} // namespace insideout
