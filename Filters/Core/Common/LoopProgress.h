// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"

#include <algorithm>
#include <cstddef>

namespace insideout
{
/** Progress of a loop on one thread with short iterations: the monitor is asked in few of them. */
class LoopProgress
{
public:
  static constexpr std::size_t TurnsPerCheck = 4096; ///< ten questions a second, or more

  /** @param[in] turns estimated number of iterations */
  LoopProgress(Monitor& monitor, const ProgressRange& range, std::size_t turns)
    : Watch(monitor)
    , Range(range)
    , Turns(static_cast<double>(turns))
  {
  }

  /**
   * Call in each iteration, starting with 0.
   * @throws Error Stopped
   */
  void Check(std::size_t turn) const
  {
    if (turn % TurnsPerCheck == 0)
    {
      this->CheckNow(turn);
    }
  }

  /** The same without skipping, for an iteration that may be long. */
  void CheckNow(std::size_t turn) const
  {
    const double part = std::min(static_cast<double>(turn) / std::max(this->Turns, 1.0), 1.0);
    this->Watch.Check(this->Range, part);
  }

private:
  Monitor& Watch;
  const ProgressRange Range;
  const double Turns;
};
} // namespace insideout
