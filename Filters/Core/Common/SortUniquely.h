// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace insideout
{
/** Sort the values and remove duplicates. */
template <typename Value>
void SortUniquely(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/** The values in both of two sorted lists. */
template <typename Value>
std::vector<Value> InBoth(const std::vector<Value>& a, const std::vector<Value>& b)
{
  std::vector<Value> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

/** The index of a value among sorted ones. */
template <typename Value>
Id IndexIn(const std::vector<Value>& sorted, const Value& value)
{
  return static_cast<Id>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}
} // namespace insideout
