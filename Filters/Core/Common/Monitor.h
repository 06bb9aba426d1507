// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"

namespace insideout
{
/**
 * The stages' one line to whoever called them: how far they are, and whether to stop. Derive from
 * it to show progress or to cancel; the base class does neither. Called only from the thread that
 * called the stage.
 */
class Monitor
{
public:
  virtual ~Monitor() = default;

  /**
   * Report that `fraction` (0 to 1) of the stage called `stage` is done.
   * @throws Error (Stopped) when the user wants to stop.
   */
  void Check(const char* stage, double fraction)
  {
    if (!this->Continue(stage, fraction))
    {
      throw Error(ErrorCode::Stopped, std::string("stopped while ") + stage);
    }
  }

  /** The same without exception, for loops that have to tidy up first: true to go on. */
  virtual bool Continue(const char* /*stage*/, double /*fraction*/) { return true; }
};
} // namespace insideout
