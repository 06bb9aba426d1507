// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/Types.h"

#include <atomic>
#include <exception>
#include <omp.h>

namespace insideout
{
/**
 * Calls body(i) for every i in [0, count) on all threads. The monitor is asked from the calling
 * thread only. The first exception that a body or the monitor throws ends the loop and is thrown
 * on to the caller.
 */
template <class Body>
void ParallelLoop(Id count, Monitor& monitor, const ProgressRange& progress, const Body& body)
{
  std::atomic<Id> done{ 0 };
  std::atomic<bool> stop{ false };
  std::exception_ptr error;
  const int caller = 0; // OpenMP numbers the thread that meets the parallel region 0.
#pragma omp parallel for schedule(dynamic)
  for (Id i = 0; i < count; ++i)
  {
    if (stop)
    {
      continue;
    }
    try
    {
      body(i);
      const double fraction = static_cast<double>(++done) / count;
      if (omp_get_thread_num() == caller)
      {
        monitor.Check(progress.Stage, progress.Begin + fraction * (progress.End - progress.Begin));
      }
    }
    catch (...)
    {
#pragma omp critical(InsideOutParallelLoop)
      {
        error = error ? error : std::current_exception();
      }
      stop = true;
    }
  }
  if (error)
  {
    std::rethrow_exception(error);
  }
}
} // namespace insideout
