// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Finds for each of many values, which are numbered, the first that is equal: a hash table without
 * links, several times as fast as sorting. */
class FirstOfEqual
{
public:
  /** @param[in] count that at most will be put in */
  explicit FirstOfEqual(std::size_t count)
  {
    std::size_t places = 2;
    while (places < 2 * count)
    {
      places *= 2;
    }
    this->Places.assign(places, None);
  }

  /**
   * The first value put in that is equal to this one; itself where there is none, and it is in
   * then.
   *
   * @param[in] hash the same for values that are equal, different in its lower bits for most others
   * @param[in] isEqual whether a value is equal to this one
   */
  template <typename IsEqual>
  Id Find(Id value, std::size_t hash, const IsEqual& isEqual)
  {
    const std::size_t mask = this->Places.size() - 1;
    std::size_t place = hash & mask;
    while (this->Places[place] != None && !isEqual(this->Places[place]))
    {
      place = (place + 1) & mask;
    }
    if (this->Places[place] == None)
    {
      this->Places[place] = value;
    }
    return this->Places[place];
  }

private:
  std::vector<Id> Places; ///< a power of two of them, half of which at least stay None
};
} // namespace insideout
