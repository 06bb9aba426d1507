// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/DelaunayCells.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <utility>

namespace insideout
{
DelaunayCells::DelaunayCells(std::vector<Point> points)
  : Points(std::move(points))
  , Holders(new std::atomic<std::uint32_t>[this->Points.size()])
{
  for (std::size_t vertex = 0; vertex < this->Points.size(); ++vertex)
  {
    this->Holders[vertex].store(0, std::memory_order_relaxed);
  }
}

bool DelaunayCells::Reserve(std::size_t more, std::size_t most)
{
  const std::size_t needed = this->NumberOfIds() + more;
  const std::size_t room = std::min(std::max(needed, this->Room + this->Room / 2), most);
  if (needed <= this->Room || room <= this->Room)
  {
    return this->NumberOfIds() < this->Room;
  }
  std::unique_ptr<DelaunayCell[]> cells(new DelaunayCell[room]);
  constexpr double nanosecondsPerCell = 5;
  ParallelLoop(room, nanosecondsPerCell,
    [&](std::size_t cell)
    {
      const bool isOld = cell < this->Room;
      for (int k = 0; k < 4; ++k)
      {
        cells[cell].SetCorner(k, isOld ? this->Cells[cell].Corner(k) : None);
        cells[cell].SetNeighbor(k, isOld ? this->Cells[cell].Neighbor(k) : None);
      }
      cells[cell].State.store(CellState::Unknown, std::memory_order_relaxed);
    });
  this->Cells = std::move(cells);
  this->Room = room;
  return true;
}

void DelaunayCells::Take(std::size_t count, std::vector<Id>& free)
{
  std::size_t first = this->Taken.load(std::memory_order_relaxed);
  std::size_t last;
  do
  {
    last = std::min(first + count, this->Room);
  } while (!this->Taken.compare_exchange_weak(first, last, std::memory_order_relaxed));
  for (std::size_t cell = last; cell > first; --cell)
  {
    free.push_back(static_cast<Id>(cell - 1));
  }
}
} // namespace insideout
