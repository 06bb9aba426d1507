// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace insideout
{
/** A set of edges by their ends, cleared in constant time. */
class EdgeSet
{
public:
  /** Begin with no edge, and make room for this number of them. */
  void Start(std::size_t edges)
  {
    std::size_t size = 64;
    while (size < 2 * edges)
    {
      size *= 2;
    }
    if (size > this->Slots.size())
    {
      this->Slots.assign(size, { 0, 0 });
      this->Epoch = 0;
    }
    this->Mask = size - 1;
    ++this->Epoch;
  }

  bool Has(Id u, Id v) const { return this->IsTaken(this->SlotOf(KeyOf(u, v))); }

  void Add(Id u, Id v)
  {
    const std::uint64_t key = KeyOf(u, v);
    this->Slots[this->SlotOf(key)] = { key, this->Epoch };
  }

private:
  struct Slot
  {
    std::uint64_t Key;
    std::uint32_t Epoch;
  };

  static std::uint64_t KeyOf(Id u, Id v)
  {
    return static_cast<std::uint64_t>(std::min(u, v)) << 32 |
      static_cast<std::uint64_t>(std::max(u, v));
  }

  bool IsTaken(std::size_t slot) const { return this->Slots[slot].Epoch == this->Epoch; }

  /** The slot with the edge, or the one that it would be put into. */
  std::size_t SlotOf(std::uint64_t key) const
  {
    std::size_t slot = (key * 0x9E3779B97F4A7C15u >> 32) & this->Mask;
    while (this->IsTaken(slot) && this->Slots[slot].Key != key)
    {
      slot = (slot + 1) & this->Mask;
    }
    return slot;
  }

  std::vector<Slot> Slots;
  std::size_t Mask = 0;
  std::uint32_t Epoch = 0;
};
} // namespace insideout
