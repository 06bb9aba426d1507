// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"

#include <algorithm>
#include <cstddef>

namespace insideout
{
/** The progress of a loop on one thread, whose turns are short: the monitor is asked in few. */
class LoopProgress
{
public:
  static constexpr std::size_t TurnsPerCheck = 4096; ///< ten questions a second, or more

  /** @param[in] turns how many there will be; a guess will do */
  LoopProgress(Monitor& monitor, const ProgressRange& range, std::size_t turns)
    : Watch(monitor)
    , Range(range)
    , Turns(static_cast<double>(turns))
  {
  }

  /**
   * To be called in each turn, the first of which is 0.
   * @throws Error Stopped
   */
  void Check(std::size_t turn) const
  {
    if (turn % TurnsPerCheck == 0)
    {
      this->CheckNow(turn);
    }
  }

  /** The same at once, for a turn that may be a long one. */
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
