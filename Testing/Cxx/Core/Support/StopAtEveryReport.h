// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

#include <gtest/gtest.h>

#include <limits>

namespace testmeshes
{
/** Allows this number of reports of progress, which have to ascend within the range. */
class CountingMonitor : public insideout::Monitor
{
public:
  static constexpr insideout::ProgressRange Range = { "working", 0.25, 0.75 };

  explicit CountingMonitor(int allowed)
    : Allowed(allowed)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    EXPECT_STREQ(stage, Range.Stage);
    EXPECT_GE(fraction, this->Last);
    EXPECT_LE(fraction, Range.End);
    this->Last = fraction;
    return ++this->Reports <= this->Allowed;
  }

  int Reports = 0;

private:
  const int Allowed;
  double Last = Range.Begin;
};

/**
 * Runs work(monitor, range) to its end, then stops it at each of its reports.
 * @return how many these are
 */
template <class Work>
int StopAtEveryReport(const Work& work)
{
  CountingMonitor patient(std::numeric_limits<int>::max());
  work(patient, CountingMonitor::Range);
  for (int allowed = 0; allowed < patient.Reports; ++allowed)
  {
    CountingMonitor monitor(allowed);
    try
    {
      work(monitor, CountingMonitor::Range);
      ADD_FAILURE() << "went on after report " << allowed;
    }
    catch (const insideout::Error& error)
    {
      EXPECT_EQ(error.Code, insideout::ErrorCode::Stopped);
    }
    EXPECT_EQ(monitor.Reports, allowed + 1);
  }
  return patient.Reports;
}
} // namespace testmeshes
