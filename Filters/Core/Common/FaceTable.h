// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/ParallelLoop.h"
#include "Common/SortedTriangle.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace insideout
{
/** A face of a cell: the two higher ids of its three points, its cell, and its orientation. */
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

/** All faces of all cells, in buckets by lowest point, each sorted. */
class FaceTable
{
public:
  FaceTable(std::size_t points, const std::vector<Tetrahedron>& cells)
    : Entries(Buckets<FaceEntry>::Unordered(points, cells.size(), CostOfCell,
        [&](std::size_t c, const auto& visit)
        {
          for (int k = 0; k < 4; ++k)
          {
            const SortedTriangle face(FaceOf(cells[c], k));
            visit(static_cast<std::size_t>(face.Points[0]),
              FaceEntry{ FaceEntry::KeyOf(face), static_cast<Id>(c), static_cast<std::int8_t>(k),
                face.Turned });
          }
        }))
  {
    ParallelLoop(points, CostOfPoint,
      [this](std::size_t p) { this->Entries.Sort(p, std::less<FaceEntry>()); });
  }

  using Range = Buckets<FaceEntry>::Range;

  /** The one or two entries of a face; none if it is not a face or has the point None. */
  Range Find(const SortedTriangle& face) const
  {
    if (face.Points[0] == None)
    {
      return { nullptr, nullptr };
    }
    // Sorts before all cells.
    const FaceEntry wanted = { FaceEntry::KeyOf(face), None, 0, false };
    const Range all = this->Entries[face.Points[0]];
    const FaceEntry* const first = std::lower_bound(all.First, all.Last, wanted);
    return { first, EndOfFace(first, all.Last, wanted) };
  }

  /**
   * Call visit(range, lowest point) for each face once, on several threads. If it throws, the
   * exception for the first such face is rethrown; visit is then called twice for that face.
   */
  template <typename Visit>
  void ForEach(const Visit& visit) const
  {
    const auto visitFacesOf = [this, &visit](std::size_t p)
    {
      const Range all = this->Entries[p];
      for (const FaceEntry* first = all.First; first != all.Last;)
      {
        const FaceEntry* const last = EndOfFace(first, all.Last, *first);
        visit(Range{ first, last }, static_cast<Id>(p));
        first = last;
      }
    };
    try
    {
      ParallelLoop(this->Entries.Size(), CostOfPoint, visitFacesOf);
    }
    catch (...)
    {
      for (std::size_t p = 0; p < this->Entries.Size(); ++p)
      {
        visitFacesOf(p);
      }
      throw;
    }
  }

private:
  /** Nanoseconds for entering the faces of a cell. */
  static constexpr double CostOfCell = 40;

  /** Nanoseconds for sorting or visiting the faces of a point. */
  static constexpr double CostOfPoint = 500;

  /** The end of the entries from `first` on that are of the same face as `wanted`. */
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

  Buckets<FaceEntry> Entries;
};
} // namespace insideout
