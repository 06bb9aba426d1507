// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <malloc.h>

/** What the benchmarks of all stages have in common: medians, and the lines that they print. */
namespace benchmark
{
/** A number that a stage has to reach. */
struct Limit
{
  enum class Side
  {
    AtMost,
    AtLeast
  };
  Side Which;
  double Value;
};

constexpr Limit AtMost(double value)
{
  return { Limit::Side::AtMost, value };
}

constexpr Limit AtLeast(double value)
{
  return { Limit::Side::AtLeast, value };
}

/** The name of a surface: its file's name without folder and ending. */
inline std::string StemOf(const std::string& path)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  return name.substr(0, name.find_last_of('.'));
}

inline double SecondsOf(const std::function<void()>& work)
{
  insideout::Stopwatch watch;
  work();
  return watch.Lap();
}

/** Processor time of all threads since the process began, in seconds. */
inline double ProcessorSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

inline double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/**
 * Median seconds of two pieces of work, run by turns so that both meet the same machine: once for
 * warming up, then five times, and short ones more often.
 */
inline std::array<double, 2> MedianSeconds(
  const std::function<void()>& first, const std::function<void()>& second)
{
  constexpr std::size_t leastRuns = 5;
  constexpr std::size_t mostRuns = 15;
  constexpr double enoughSeconds = 5;
  SecondsOf(first);
  SecondsOf(second);
  std::array<std::vector<double>, 2> seconds;
  double spent = 0;
  while (seconds[0].size() < leastRuns || (seconds[0].size() < mostRuns && spent < enoughSeconds))
  {
    seconds[0].push_back(SecondsOf(first));
    seconds[1].push_back(SecondsOf(second));
    spent += seconds[0].back() + seconds[1].back();
  }
  return { Median(seconds[0]), Median(seconds[1]) };
}

/** The resident memory of this process at its highest since the last reset, in MiB. */
inline double HighWaterMark()
{
  std::ifstream status("/proc/self/status");
  std::string word;
  double kibibytes = 0;
  while (status >> word && !(word == "VmHWM:" && status >> kibibytes))
  {
  }
  return kibibytes / 1024;
}

/** Make the mark fall to what is in use now. @return the mark */
inline double ResetHighWaterMark()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  return HighWaterMark();
}

/** A line for machines. Names begin with the stage: pre, cdt, w, cut, rerun, scale, busy, ... */
inline void PrintRatio(const std::string& name, double value, const Limit& limit)
{
  std::printf("ratio %s %.3f %s %g\n", name.c_str(), value,
    limit.Which == Limit::Side::AtMost ? "at most" : "at least", limit.Value);
  std::fflush(stdout);
}

/** A line for people: seconds of a stage and of what it is compared with. */
inline void PrintSeconds(const std::string& name, std::size_t size, const char* stage,
  const char* reference, const std::array<double, 2>& seconds)
{
  std::printf("%-28s %9zu facets   %s %8.4f s   %s %8.4f s\n", name.c_str(), size, stage,
    seconds[0], reference, seconds[1]);
  std::fflush(stdout);
}
} // namespace benchmark
