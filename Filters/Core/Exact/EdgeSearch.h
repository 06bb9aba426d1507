// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/Mesh.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace insideout
{
/** Finds cells at edges; the scratch memory of one thread. */
class EdgeSearch
{
public:
  /**
   * A cell with both vertices, None if they share no edge. Searched around both in turn: the
   * smaller star decides, where the other may have thousands of cells.
   */
  template <class Policy>
  Id Find(const Mesh<Policy>& mesh, Id u, Id v);

  /** The number of cells looked at in each star so far. */
  std::int64_t Steps() const { return this->Taken; }

private:
  struct Slot
  {
    Id Cell;
    std::uint32_t Epoch;
  };

  std::size_t SlotOf(Id cell) const;
  bool Has(Id cell) const { return this->Slots[this->SlotOf(cell)].Epoch == this->Epoch; }
  void Add(std::size_t side, Id cell);
  void Grow();

  std::array<std::vector<Id>, 2> Stars;
  std::vector<Slot> Slots = std::vector<Slot>(256, { 0, 0 }); ///< hash table of the cells in both
  std::uint32_t Epoch = 0;
  std::int64_t Taken = 0;
};

/** The slot with the cell, or the one that it would be put into. */
inline std::size_t EdgeSearch::SlotOf(Id cell) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot = (static_cast<std::uint32_t>(cell) * 0x9E3779B1u >> 8) & mask;
  while (this->Slots[slot].Epoch == this->Epoch && this->Slots[slot].Cell != cell)
  {
    slot = (slot + 1) & mask;
  }
  return slot;
}

inline void EdgeSearch::Add(std::size_t side, Id cell)
{
  if (2 * (this->Stars[0].size() + this->Stars[1].size()) >= this->Slots.size())
  {
    this->Grow();
  }
  this->Slots[this->SlotOf(cell)] = { cell, this->Epoch };
  this->Stars[side].push_back(cell);
}

inline void EdgeSearch::Grow()
{
  this->Slots.assign(2 * this->Slots.size(), { 0, 0 });
  this->Epoch = 1;
  for (const std::vector<Id>& star : this->Stars)
  {
    for (const Id cell : star)
    {
      this->Slots[this->SlotOf(cell)] = { cell, this->Epoch };
    }
  }
}

template <class Policy>
Id EdgeSearch::Find(const Mesh<Policy>& mesh, Id u, Id v)
{
  const std::array<Id, 2> ends = { { u, v } };
  const std::array<Id, 2> cells = { { mesh.CellAt(u), mesh.CellAt(v) } };
  if (cells[0] == None || cells[1] == None)
  {
    return None;
  }
  for (int side = 0; side < 2; ++side)
  {
    if (mesh.Has(cells[side], ends[1 - side]))
    {
      return cells[side];
    }
  }
  if (++this->Epoch == 0) // after 2^32 searches
  {
    this->Slots.assign(this->Slots.size(), { 0, 0 });
    this->Epoch = 1;
  }
  for (int side = 0; side < 2; ++side)
  {
    this->Stars[side].clear();
  }
  this->Add(0, cells[0]);
  this->Add(1, cells[1]);
  Id found = None;
  std::size_t next = 0;
  for (; found == None && next < std::min(this->Stars[0].size(), this->Stars[1].size()); ++next)
  {
    for (int side = 0; side < 2 && found == None; ++side)
    {
      const auto& cell = mesh.Cell(this->Stars[side][next]);
      for (int k = 0; k < 4; ++k)
      {
        const Id neighbor = cell.Neighbors[k];
        if (cell.Corners[k] == ends[side] || neighbor == None || this->Has(neighbor))
        {
          continue;
        }
        if (mesh.Has(neighbor, ends[1 - side]))
        {
          found = neighbor;
        }
        this->Add(side, neighbor);
      }
    }
  }
  this->Taken += static_cast<std::int64_t>(next);
  return found;
}
} // namespace insideout
