// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace insideout
{
/**
 * Run independent jobs, each on one thread, several at once. The largest start first, so that
 * threads end at about the same time.
 *
 * The calling thread is one of the threads, and the only one that asks `monitor`; with no jobs
 * left, it waits for the others. If a job fails, jobs after it are ended.
 *
 * @param[in] sizes one per job: the amount of work, in any unit
 * @param[in] threads limit of threads; at most AllowedThreads are used, and one within a team
 * @param[in] stage the stage whose progress is the jobs'; from reports on other stages only the
 * check for a stop is passed on
 * @param[in] work is called with the job's number and its own monitor
 * @throws Error Stopped; else the exception of the first failed job, in the order in which they
 * start: the same for any number of threads
 */
void JobsAtOnce(const std::vector<double>& sizes, int threads, const char* stage,
  const std::function<void(std::size_t, Monitor&)>& work, Monitor& monitor);
} // namespace insideout
