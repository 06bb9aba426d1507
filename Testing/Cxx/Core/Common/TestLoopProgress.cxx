// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/LoopProgress.h"

#include "Support/StopAtEveryReport.h"

#include <gtest/gtest.h>

#include <vector>

using namespace insideout;

namespace
{
std::vector<double> FractionsOf(std::size_t turns, std::size_t guess)
{
  struct Recorder : Monitor
  {
    bool Continue(const char*, double fraction) override
    {
      this->Fractions.push_back(fraction);
      return true;
    }
    std::vector<double> Fractions;
  };
  Recorder recorder;
  const LoopProgress progress(recorder, { "working", 0.5, 1 }, guess);
  for (std::size_t turn = 0; turn < turns; ++turn)
  {
    progress.Check(turn);
  }
  return recorder.Fractions;
}
} // namespace

TEST(LoopProgress, ReportsInTheFirstTurnAndThenInFew)
{
  constexpr std::size_t few = LoopProgress::TurnsPerCheck;
  EXPECT_EQ(FractionsOf(0, 0), std::vector<double>());
  EXPECT_EQ(FractionsOf(1, 1), std::vector<double>({ 0.5 }));
  EXPECT_EQ(FractionsOf(few, few), std::vector<double>({ 0.5 }));
  EXPECT_EQ(FractionsOf(3 * few + 1, 4 * few), std::vector<double>({ 0.5, 0.625, 0.75, 0.875 }));
}

TEST(LoopProgress, EndsWithItsRangeWhereMoreTurnsComeThanWereGuessed)
{
  constexpr std::size_t few = LoopProgress::TurnsPerCheck;
  EXPECT_EQ(FractionsOf(3 * few, few), std::vector<double>({ 0.5, 1, 1 }));
  EXPECT_EQ(FractionsOf(2 * few, 0), std::vector<double>({ 0.5, 1 }));
}

TEST(LoopProgress, CanBeStopped)
{
  const int reports = testmeshes::StopAtEveryReport(
    [](Monitor& monitor, const ProgressRange& range)
    {
      const LoopProgress progress(monitor, range, 10000);
      for (std::size_t turn = 0; turn < 10000; ++turn)
      {
        progress.Check(turn);
      }
    });
  EXPECT_EQ(reports, 3);
}
