// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Common/ProgressRange.h"

#include <algorithm>

namespace insideout
{
/**
 * Progress reports and stop requests between the stages and their caller. Derive from it to show
 * progress or to cancel; the base class does neither. Called only from the thread that called the
 * stage.
 */
class Monitor
{
public:
  virtual ~Monitor() = default;

  /**
   * Report that `fraction` (0 to 1) of the stage called `stage` is done.
   * @throws Error (Stopped) if the user requests a stop.
   */
  void Check(const char* stage, double fraction)
  {
    if (!this->Continue(stage, fraction))
    {
      throw Error(ErrorCode::Stopped, std::string("stopped while ") + stage);
    }
  }

  /** The same for `part` (0 to 1) of a step of a stage. */
  void Check(const ProgressRange& step, double part) { this->Check(step.Stage, step.At(part)); }

  /** The same without exception, for loops with cleanup: true to continue. */
  virtual bool Continue(const char* /*stage*/, double /*fraction*/) { return true; }
};

/** Passes on reports, but never decreasing progress: for work that may restart. */
class ForwardMonitor : public Monitor
{
public:
  explicit ForwardMonitor(Monitor& caller)
    : Caller(caller)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    this->Furthest = std::max(this->Furthest, fraction);
    return this->Caller.Continue(stage, this->Furthest);
  }

private:
  Monitor& Caller;
  double Furthest = 0;
};
} // namespace insideout
