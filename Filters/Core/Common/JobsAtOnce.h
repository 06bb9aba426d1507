// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace insideout
{
/**
 * Does jobs that have nothing to do with each other, each on one thread, several at once. The
 * largest begin first, so that threads end at about the same time.
 *
 * The calling thread is one of them, and the only one that asks `monitor`; when no job is left for
 * it, it listens while others work. A job that fails ends those that begin after it.
 *
 * @param[in] sizes one per job: how much there is to do, in any unit
 * @param[in] threads how many at most; no more than may work, and one within a team
 * @param[in] stage whose progress the jobs' is: of what they report of other stages only the
 *            question whether to stop is passed on
 * @param[in] work is called with the job's number and its own monitor
 * @throws Error Stopped; else what the first job that failed threw, in the order in which they
 *         begin: the same for any number of threads
 */
void JobsAtOnce(const std::vector<double>& sizes, int threads, const char* stage,
  const std::function<void(std::size_t, Monitor&)>& work, Monitor& monitor);
} // namespace insideout
