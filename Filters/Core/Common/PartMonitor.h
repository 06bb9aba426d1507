// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"

namespace insideout
{
/** Passes on the reports of one of several parts of a stage. */
class PartMonitor : public Monitor
{
public:
  PartMonitor(Monitor& whole, std::size_t part, std::size_t parts)
    : Whole(whole)
    , Part(static_cast<double>(part))
    , Parts(static_cast<double>(parts))
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    return this->Whole.Continue(stage, (this->Part + fraction) / this->Parts);
  }

private:
  Monitor& Whole;
  const double Part;
  const double Parts;
};

/** Asks whether to go on, but reports the same stage and progress all the time. */
class QuietMonitor : public Monitor
{
public:
  QuietMonitor(Monitor& caller, const ProgressRange& step)
    : Caller(caller)
    , Step(step)
  {
  }

  bool Continue(const char* /*stage*/, double /*fraction*/) override
  {
    return this->Caller.Continue(this->Step.Stage, this->Step.Begin);
  }

private:
  Monitor& Caller;
  const ProgressRange Step;
};
} // namespace insideout
