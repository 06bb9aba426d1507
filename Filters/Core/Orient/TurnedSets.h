// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Union-find over 0 to count - 1, in which each member is turned against the set's representative
 * or not. */
class TurnedSets
{
public:
  explicit TurnedSets(Id count)
    : Parents(count)
    , AgainstParent(count, 0)
  {
    for (Id i = 0; i < count; ++i)
    {
      this->Parents[i] = i;
    }
  }

  struct Place
  {
    Id Set;
    char Turned;
  };

  Place Find(Id i)
  {
    Place place = { i, 0 };
    while (this->Parents[place.Set] != place.Set)
    {
      // Path halving, as in DisjointSets.
      const Id parent = this->Parents[place.Set];
      this->AgainstParent[place.Set] ^= this->AgainstParent[parent];
      this->Parents[place.Set] = this->Parents[parent];
      place.Turned ^= this->AgainstParent[place.Set];
      place.Set = this->Parents[place.Set];
    }
    return place;
  }

  void Join(Id i, Id j, bool turned)
  {
    const Place a = this->Find(i);
    const Place b = this->Find(j);
    if (a.Set != b.Set)
    {
      this->Parents[b.Set] = a.Set;
      this->AgainstParent[b.Set] = static_cast<char>(a.Turned ^ b.Turned ^ turned);
    }
  }

private:
  std::vector<Id> Parents;
  std::vector<char> AgainstParent;
};
} // namespace insideout
