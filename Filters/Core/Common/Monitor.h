// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Common/ProgressRange.h"

#include <algorithm>

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

  /** The same where `part` (0 to 1) of a step of a stage is done. */
  void Check(const ProgressRange& step, double part) { this->Check(step.Stage, step.At(part)); }

  /** The same without exception, for loops that have to tidy up first: true to go on. */
  virtual bool Continue(const char* /*stage*/, double /*fraction*/) { return true; }
};

/** Passes on what is reported, but no step back: for work that may begin anew. */
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
