// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace insideout
{
/** What one way to tetrahedralize may use up before the next has its turn. */
struct TetrahedralizerBudget
{
  double Seconds = HUGE_VAL;          ///< wall-clock time
  double ProcessorSeconds = HUGE_VAL; ///< of a process of its own; other ways count their work
  double Mebibytes = HUGE_VAL;        ///< memory held at a time, where it is watched
};
} // namespace insideout
