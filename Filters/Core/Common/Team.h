// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace insideout
{
/** Four for each of the machine's processors: more would only take memory from each other. */
int MostThreads();

/** As many as OpenMP would take (OMP_NUM_THREADS, omp_set_num_threads), but at most MostThreads and
 * at most the host's limit. */
int AllowedThreads();

/**
 * From now on AllowedThreads asks this function, on the thread that gathers a team, for the limit
 * that the program around has for its threads.
 *
 * @param[in] limit returns 0 for none
 */
void SetHostLimit(int (*limit)());

/** That more threads are asked for than MostThreads, in words; empty where it is not so. */
std::string TooManyThreads();

/**
 * The number of threads that pays for work of this many nanoseconds of one thread. At
 * most AllowedThreads; one within a team.
 */
int TeamSize(double nanoseconds);

/**
 * Calls work() on this thread and on up to threads - 1 others, and returns when all is done. Work
 * takes what is to do piece by piece, and must not throw.
 *
 * A thread that comes when nothing is left is not waited for, and nobody spins. OpenMP's teams do
 * both: beside two busy processes on two processors, a loop of 0.05 ms took 13 ms with them, and
 * 0.06 ms like this. To ask another thread to come costs 0.01 ms, busy or not.
 *
 * Where the system gives no more threads, or no memory for them, those that there are do the work.
 * Threads live as long as the work, so that a process that is forked between two works lacks none.
 *
 * @throws Error Forked in a process that was forked by the work itself
 */
void WorkAsTeam(int threads, const std::function<void()>& work);

/**
 * While it lives, all work is worth all threads, and none of them begins before all have come: for
 * tests, to which small surfaces are to show what large ones would. Not while something works.
 */
class WholeTeams
{
public:
  WholeTeams();
  ~WholeTeams();
  WholeTeams(const WholeTeams&) = delete;
  WholeTeams& operator=(const WholeTeams&) = delete;
};
} // namespace insideout
