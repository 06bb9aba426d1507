// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Finds for each of many numbered values the first equal one: an open-addressing hash table,
 * several times as fast as sorting. */
class FirstOfEqual
{
public:
  /** @param[in] count limit of insertions */
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
   * The first inserted value equal to this one; if there is none, this one is inserted and
   * returned.
   *
   * @param[in] hash equal for equal values, with different lower bits for most others
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
  std::vector<Id> Places; ///< a power of two of slots, at least half of which stay None
};
} // namespace insideout
