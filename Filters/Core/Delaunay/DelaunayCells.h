// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace insideout
{
/** A vertex beyond the hull. Tetrahedra between it and the hull's faces fill the space there. */
constexpr Id InfiniteVertex = 0;

/** What the search for cells to replace found about a cell. */
enum class CellState : std::uint8_t
{
  Unknown,
  Goes,
  Stays,
};

/**
 * A tetrahedron under construction. Its numbers are atomic, because threads that search for a place
 * read what others are changing; they are in no order, and cost nothing.
 *
 * Corners have positive orientation (Orient3D). The infinite vertex is the last one, and counts as
 * if it lay outside. Neighbor k is across from corner k, as a FaceNumber. The first corner of a
 * cell that is not there is None.
 */
struct DelaunayCell
{
  std::array<std::atomic<Id>, 4> Corners;
  std::array<std::atomic<Id>, 4> Neighbors;
  std::atomic<CellState> State;

  Id Corner(int k) const { return this->Corners[k].load(std::memory_order_relaxed); }
  Id Neighbor(int k) const { return this->Neighbors[k].load(std::memory_order_relaxed); }
  Tetrahedron AllCorners() const
  {
    return { { this->Corner(0), this->Corner(1), this->Corner(2), this->Corner(3) } };
  }
  void SetCorner(int k, Id vertex) { this->Corners[k].store(vertex, std::memory_order_relaxed); }
  void SetNeighbor(int k, Id face) { this->Neighbors[k].store(face, std::memory_order_relaxed); }
};

/** The number of a face as a neighbor: its cell, and the corner of it across. */
constexpr Id FaceNumber(Id cell, int corner)
{
  return cell << 2 | corner;
}
constexpr Id CellOfFace(Id face)
{
  return face >> 2;
}
constexpr int CornerAcross(Id face)
{
  return face & 3;
}

/**
 * The cells, and which thread holds which vertex. A thread that replaces cells holds all finite
 * vertices of these and of those that it makes. Then no other thread changes a cell of these, nor
 * removes one of their neighbors, for whatever removes it holds all of its vertices, too.
 */
class DelaunayCells
{
public:
  /** @param[in] points of vertices 1 and on; the first one is never read */
  explicit DelaunayCells(std::vector<Point> points);

  const Point& PointOf(Id vertex) const { return this->Points[vertex]; }

  /** Ids of cells are below this; some may not be there. */
  std::size_t NumberOfIds() const { return this->Taken.load(std::memory_order_relaxed); }
  bool IsThere(Id cell) const { return this->Cells[cell].Corner(0) != None; }

  DelaunayCell& operator[](Id cell) { return this->Cells[cell]; }
  const DelaunayCell& operator[](Id cell) const { return this->Cells[cell]; }

  CellState State(Id cell) const { return this->Cells[cell].State.load(std::memory_order_relaxed); }
  void SetState(Id cell, CellState state)
  {
    this->Cells[cell].State.store(state, std::memory_order_relaxed);
  }

  /**
   * Make room for this many more cells, or for fewer up to a limit; no thread may be at work.
   * @param[in] most limit of the number of cells
   * @return whether there is room for any more
   */
  bool Reserve(std::size_t more, std::size_t most);

  /** Append the ids of up to `count` new cells, fewer if there is no more room. */
  void Take(std::size_t count, std::vector<Id>& free);

  /**
   * Hold a vertex that nobody holds.
   * @param[in] thread 1 to 2^16 - 1
   * @param[in] place of the vertex among those that the thread holds, from 1 on
   * @return 0, or the thread that holds the vertex, which may be this one
   */
  std::uint32_t Hold(Id vertex, std::uint32_t thread, std::uint32_t place)
  {
    std::uint32_t holder = 0;
    this->Holders[vertex].compare_exchange_strong(holder,
      thread << 16 | std::min(place, MostPlaces), std::memory_order_acquire,
      std::memory_order_relaxed);
    return holder >> 16;
  }

  /** The place of a vertex that this thread holds, if below MostPlaces; 0 of the infinite vertex.
   */
  std::uint32_t PlaceOf(Id vertex) const
  {
    return this->Holders[vertex].load(std::memory_order_relaxed) & MostPlaces;
  }
  void Release(Id vertex) { this->Holders[vertex].store(0, std::memory_order_release); }

private:
  static constexpr std::uint32_t MostPlaces = 0xffff;

  std::vector<Point> Points;
  std::unique_ptr<std::atomic<std::uint32_t>[]> Holders;
  std::unique_ptr<DelaunayCell[]> Cells;
  std::size_t Room = 0;
  std::atomic<std::size_t> Taken{ 0 };
};
} // namespace insideout
