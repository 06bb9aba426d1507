// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace insideout
{
/** The budget of one rung. */
struct TetrahedralizerBudget
{
  double Seconds = HUGE_VAL; ///< wall-clock time
  /// processor time of a separate process; other rungs count their work
  double ProcessorSeconds = HUGE_VAL;
  double Mebibytes = HUGE_VAL; ///< memory held at a time, where enforced
};
} // namespace insideout
