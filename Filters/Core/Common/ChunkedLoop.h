// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <cstdint>

namespace insideout
{
/**
 * Call body(i) for every i in [0, count), on as many threads as pay off. The monitor is asked
 * between chunks of about a tenth of a second, outside any parallel loop, at the same points for
 * any number of threads.
 *
 * @param[in] cost estimated nanoseconds of one call of body
 * @throws exceptions of a body or of the monitor
 */
template <class Body>
void ChunkedLoop(
  Id count, double cost, Monitor& monitor, const ProgressRange& progress, const Body& body)
{
  const double nanosecondsPerChunk = 1e8; // the monitor is asked ten times a second
  const Id perChunk =
    static_cast<Id>(std::min(std::max(nanosecondsPerChunk / std::max(cost, 1.0), 16.0), 1e9));
  for (std::int64_t first = 0; first < count; first += perChunk)
  {
    monitor.Check(progress.Stage,
      progress.Begin + (progress.End - progress.Begin) * static_cast<double>(first) / count);
    const Id size = static_cast<Id>(std::min<std::int64_t>(perChunk, count - first));
    ParallelLoop(size, cost, [&](Id i) { body(static_cast<Id>(first + i)); });
  }
}
} // namespace insideout
