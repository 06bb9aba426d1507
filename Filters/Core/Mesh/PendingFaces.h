// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/MeshCell.h"

#include <vector>

namespace insideout
{
/** A face with one known cell, while the other is searched for. */
struct PendingFace
{
  Triangle Corners; ///< ascending
  std::uint32_t Epoch;
  Id Cell;        ///< None outside the boundary
  Id Fresh;       ///< index of that cell among the fresh ones, None for an old one
  Id Facet;       ///< facets inherited by fresh cells
  Id Other;       ///< index of the matching fresh cell, None until it is found
  std::int8_t At; ///< indices of the face in the two cells
  std::int8_t AtOther;
  bool IsOnBoundary; ///< no second cell is expected
};

/** A hash table of faces by their corners, cleared in constant time. */
class PendingFaces
{
public:
  /** Make room for the faces of a number of cells, and clear the table. */
  void Start(std::size_t cells)
  {
    std::size_t size = 32;
    while (size < 6 * cells)
    {
      size *= 2;
    }
    if (size > this->Slots.size())
    {
      this->Slots.assign(size, PendingFace());
      this->Epoch = 0;
    }
    this->Mask = size - 1;
    ++this->Epoch;
  }

  /** The existing or new slot of a face. */
  PendingFace& At(const Triangle& sorted)
  {
    std::size_t slot = static_cast<std::size_t>(sorted[0]) * 0x9E3779B1u ^
      static_cast<std::size_t>(sorted[1]) * 0x85EBCA77u ^
      static_cast<std::size_t>(sorted[2]) * 0xC2B2AE3Du;
    slot = (slot ^ (slot >> 15)) & this->Mask;
    while (this->IsTaken(this->Slots[slot]) && this->Slots[slot].Corners != sorted)
    {
      slot = (slot + 1) & this->Mask;
    }
    return this->Slots[slot];
  }

  bool IsTaken(const PendingFace& face) const { return face.Epoch == this->Epoch; }

  /** Enter a face in its slot. */
  void Enter(PendingFace& slot, const Triangle& sorted, const MeshFace& of, Id fresh, Id facet)
  {
    slot = { sorted, this->Epoch, of.Cell, fresh, facet, None, static_cast<std::int8_t>(of.Face),
      -1, false };
  }

private:
  std::vector<PendingFace> Slots;
  std::size_t Mask = 0;
  std::uint32_t Epoch = 0;
};
} // namespace insideout
