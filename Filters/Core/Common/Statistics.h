// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace insideout
{
/** Figures about a run by name, as in the filters' field data and the report. */
using Statistics = std::vector<std::pair<std::string, double>>;

/** The peak memory of this process so far, in MiB. */
double PeakMemory();

/** Wall-clock seconds since construction, or since the last lap. */
class Stopwatch
{
public:
  double Lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - this->Start).count();
    this->Start = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};
} // namespace insideout
