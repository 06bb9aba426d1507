// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Team.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>

namespace insideout
{
/**
 * Calls per chunk of a thread: about 20 microseconds, so that scheduling is negligible and threads
 * end at about the same time.
 */
inline std::int64_t CallsPerTurn(double count, double cost, int threads)
{
  const double nanosecondsPerTurn = 20000;
  const double turnsPerThread = 8;
  return static_cast<std::int64_t>(
    std::max(std::min(nanosecondsPerTurn / cost, count / (turnsPerThread * threads)), 1.0));
}

/**
 * Call body(i) for every i in [0, count), on as many threads as pay off. The monitor is asked from
 * the calling thread only. The first exception of a body or the monitor ends the loop and is
 * rethrown.
 *
 * @param[in] cost estimated nanoseconds of one call of body
 */
template <class Index, class Body>
void ParallelLoop(
  Index count, double cost, Monitor& monitor, const ProgressRange& progress, const Body& body)
{
  const std::int64_t end = static_cast<std::int64_t>(count);
  const int threads = static_cast<int>(std::clamp<std::int64_t>(
    TeamSize(static_cast<double>(count) * cost), 1, std::max<std::int64_t>(end, 1)));
  const std::int64_t perTurn = CallsPerTurn(static_cast<double>(count), cost, threads);
  std::atomic<std::int64_t> next{ 0 };
  std::mutex mutex; // index of the call that failed
  std::exception_ptr error;
  const std::thread::id caller = std::this_thread::get_id();
  const auto takeTurns = [&]
  {
    try
    {
      for (std::int64_t first = next.fetch_add(perTurn); first < end;
           first = next.fetch_add(perTurn))
      {
        const std::int64_t last = std::min(first + perTurn, end);
        for (std::int64_t i = first; i < last; ++i)
        {
          body(static_cast<Index>(i));
        }
        if (std::this_thread::get_id() == caller)
        {
          const double fraction = static_cast<double>(last) / static_cast<double>(end);
          monitor.Check(
            progress.Stage, progress.Begin + fraction * (progress.End - progress.Begin));
        }
      }
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      error = error ? error : std::current_exception();
      next = end;
    }
  };
  WorkAsTeam(threads, takeTurns);
  if (error)
  {
    std::rethrow_exception(error);
  }
}

/** The same without a monitor, for short loops. */
template <class Index, class Body>
void ParallelLoop(Index count, double cost, const Body& body)
{
  Monitor silent;
  ParallelLoop(count, cost, silent, { "", 0, 1 }, body);
}
} // namespace insideout
