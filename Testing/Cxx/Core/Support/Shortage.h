// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/**
 * A program that links Shortage.cxx has its own malloc, calloc, realloc and pthread_create, in all
 * libraries, too, which fail when they are told to.
 */
namespace shortage
{
enum class Of
{
  Memory,
  Threads
};

/** While it lives, calls for memory or threads are counted, and one or all from it on fail. */
class Shortage
{
public:
  /**
   * @param[in] first the call that fails, from 1; 0 for none
   * @param[in] forGood whether all that follow it fail too
   */
  explicit Shortage(Of what, std::size_t first = 0, bool forGood = false);
  ~Shortage();
  Shortage(const Shortage&) = delete;
  Shortage& operator=(const Shortage&) = delete;

  /** How many calls there were up to now. */
  std::size_t Calls() const;

private:
  const Of What;
};

/** While it lives, a thread is made only when somebody has seen that, and slowly then. */
class SlowThreads
{
public:
  SlowThreads();
  ~SlowThreads();
  SlowThreads(const SlowThreads&) = delete;
  SlowThreads& operator=(const SlowThreads&) = delete;

  /** Waits until one is being made. */
  void AwaitOne() const;

  bool IsOneInTheMaking() const;
};
} // namespace shortage
