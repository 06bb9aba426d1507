// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace insideout
{
/** Union-find over 0 to count - 1, in which the lowest member represents its set. */
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  Id Find(Id i)
  {
    while (this->Parents[i] != i)
    {
      this->Parents[i] = this->Parents[this->Parents[i]];
      i = this->Parents[i];
    }
    return i;
  }

  void Join(Id i, Id j)
  {
    const Id a = this->Find(i);
    const Id b = this->Find(j);
    this->Parents[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<Id> Parents;
};
} // namespace insideout
