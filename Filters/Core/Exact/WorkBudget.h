// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace insideout
{
/**
 * The work done, and its limit. Its unit is about one predicate decided in doubles, some 10 ns.
 * Unlike time it is the same on every machine: a run that ends by it ends with the same mesh each
 * time.
 */
class WorkBudget
{
public:
  explicit WorkBudget(std::int64_t most = std::numeric_limits<std::int64_t>::max())
    : Most(most)
  {
  }

  void Spend(std::int64_t work) { this->Done += work; }

  std::int64_t Spent() const { return this->Done; }

  std::int64_t Left() const { return this->Most - this->Done; }

  bool IsUsedUp() const { return this->Done > this->Most; }

private:
  std::int64_t Done = 0;
  std::int64_t Most;
};
} // namespace insideout
