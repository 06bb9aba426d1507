// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace insideout
{
/** The nearest float; infinite beyond the largest. Volatile, because GCC 12 omits the conversion
 * when it vectorizes. */
inline double InFloat(double x)
{
  const volatile auto single = static_cast<float>(x);
  return double(single) + 0.0; // -0 is 0
}

/** Whether a double is the value of a float. */
inline bool IsFloat(double x)
{
  return std::abs(x) <= std::numeric_limits<float>::max() && InFloat(x) == x;
}
} // namespace insideout
