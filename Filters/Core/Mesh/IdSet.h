// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace insideout
{
/**
 * A set of ids for consecutive searches, cleared in constant time. Its memory is that of the
 * largest set so far, whatever the ids: each thread can have one.
 */
class IdSet
{
public:
  void Clear()
  {
    this->All.clear();
    if (++this->Epoch == 0) // after 2^32 searches
    {
      this->Slots.assign(this->Slots.size(), { 0, 0 });
      this->Epoch = 1;
    }
  }

  bool Has(Id id) const { return this->Slots[this->SlotOf(id)].Epoch == this->Epoch; }

  /** Add an id that may be there already. */
  void Add(Id id)
  {
    const std::size_t slot = this->SlotOf(id);
    if (this->Slots[slot].Epoch != this->Epoch)
    {
      this->Slots[slot] = { id, this->Epoch };
      this->All.push_back(id);
      if (2 * this->All.size() > this->Slots.size())
      {
        this->Grow();
      }
    }
  }

  /** The ids in the order in which they were added. */
  const std::vector<Id>& Members() const { return this->All; }

private:
  struct Slot
  {
    Id Member;
    std::uint32_t Epoch;
  };

  /** The slot with the id, or the one that it would be put into. */
  std::size_t SlotOf(Id id) const
  {
    const std::size_t mask = this->Slots.size() - 1;
    std::size_t slot = (static_cast<std::uint32_t>(id) * 0x9E3779B1u >> 8) & mask;
    while (this->Slots[slot].Epoch == this->Epoch && this->Slots[slot].Member != id)
    {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void Grow()
  {
    this->Slots.assign(2 * this->Slots.size(), { 0, 0 });
    this->Epoch = 1;
    for (const Id id : this->All)
    {
      this->Slots[this->SlotOf(id)] = { id, this->Epoch };
    }
  }

  std::vector<Slot> Slots = std::vector<Slot>(256, { 0, 0 }); ///< hash table
  std::uint32_t Epoch = 1;
  std::vector<Id> All;
};
} // namespace insideout
