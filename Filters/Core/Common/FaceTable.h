// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/SortedTriangle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace insideout
{
/** Face of a cell: the two higher ids of its three points, whose it is, how it is turned. */
struct FaceEntry
{
  std::uint64_t Key; ///< the middle id above the highest
  Id Cell;
  std::int8_t Face;
  bool Turned;

  static std::uint64_t KeyOf(const SortedTriangle& face)
  {
    return static_cast<std::uint64_t>(face.Points[1]) << 32 |
      static_cast<std::uint32_t>(face.Points[2]);
  }
  Id Middle() const { return static_cast<Id>(this->Key >> 32); }
  Id Highest() const { return static_cast<Id>(this->Key & 0xFFFFFFFFu); }

  bool operator<(const FaceEntry& other) const
  {
    return this->Key < other.Key || (this->Key == other.Key && this->Cell < other.Cell);
  }
};

/** Every face of every cell, in buckets by lowest point and sorted in each. */
class FaceTable
{
public:
  FaceTable(std::size_t points, const std::vector<Tetrahedron>& cells)
    : Begin(points + 2, 0)
    , Entries(4 * cells.size())
  {
    // Counted one bucket ahead, so that filling moves each Begin to where it belongs.
    this->ForEachFace(cells,
      [&](const SortedTriangle& face, Id, int)
      { ++this->Begin[static_cast<std::size_t>(face.Points[0]) + 2]; });
    for (std::size_t p = 2; p < this->Begin.size(); ++p)
    {
      this->Begin[p] += this->Begin[p - 1];
    }
    this->ForEachFace(cells,
      [&](const SortedTriangle& face, Id cell, int k)
      {
        this->Entries[this->Begin[static_cast<std::size_t>(face.Points[0]) + 1]++] = {
          FaceEntry::KeyOf(face), cell, static_cast<std::int8_t>(k), face.Turned
        };
      });
    for (std::size_t p = 0; p < points; ++p)
    {
      std::sort(&this->Entries[0] + this->Begin[p], &this->Entries[0] + this->Begin[p + 1]);
    }
  }

  struct Range
  {
    const FaceEntry* First;
    const FaceEntry* Last;
    const FaceEntry* begin() const { return this->First; }
    const FaceEntry* end() const { return this->Last; }
  };

  /** The one or two entries of a face, none if it is not one or has the point None. */
  Range Find(const SortedTriangle& face) const
  {
    if (face.Points[0] == None)
    {
      return { nullptr, nullptr };
    }
    // Any cell comes behind None.
    const FaceEntry wanted = { FaceEntry::KeyOf(face), None, 0, false };
    const FaceEntry* const end = this->EndOf(face.Points[0]);
    const FaceEntry* const first = std::lower_bound(this->BeginOf(face.Points[0]), end, wanted);
    return { first, EndOfFace(first, end, wanted) };
  }

  /** Call visit(range, lowest point) for each face once. */
  template <typename Visit>
  void ForEach(Visit visit) const
  {
    for (std::size_t p = 0; p + 2 < this->Begin.size(); ++p)
    {
      const FaceEntry* const end = this->EndOf(static_cast<Id>(p));
      for (const FaceEntry* first = this->BeginOf(static_cast<Id>(p)); first != end;)
      {
        const FaceEntry* const last = EndOfFace(first, end, *first);
        visit(Range{ first, last }, static_cast<Id>(p));
        first = last;
      }
    }
  }

private:
  template <typename Visit>
  static void ForEachFace(const std::vector<Tetrahedron>& cells, Visit visit)
  {
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        const std::array<int, 3>& corners = TetrahedronFaces[k];
        visit(SortedTriangle({ cells[c][corners[0]], cells[c][corners[1]], cells[c][corners[2]] }),
          static_cast<Id>(c), k);
      }
    }
  }

  const FaceEntry* BeginOf(Id p) const { return this->Entries.data() + this->Begin[p]; }
  const FaceEntry* EndOf(Id p) const { return this->Entries.data() + this->Begin[p + 1]; }

  /** Behind the last of the entries from `first` on that are of the same face as `wanted`. */
  static const FaceEntry* EndOfFace(
    const FaceEntry* first, const FaceEntry* end, const FaceEntry& wanted)
  {
    const FaceEntry* last = first;
    while (last != end && last->Key == wanted.Key)
    {
      ++last;
    }
    return last;
  }

  std::vector<std::size_t> Begin;
  std::vector<FaceEntry> Entries;
};
} // namespace insideout
