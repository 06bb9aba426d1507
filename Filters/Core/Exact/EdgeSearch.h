// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Mesh/IdSet.h"
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
  void Add(std::size_t side, Id cell)
  {
    this->Known.Add(cell);
    this->Stars[side].push_back(cell);
  }

  std::array<std::vector<Id>, 2> Stars;
  IdSet Known; ///< the cells in both
  std::int64_t Taken = 0;
};

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
  this->Known.Clear();
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
        if (cell.Corners[k] == ends[side])
        {
          continue;
        }
        const Id neighbor = cell.Neighbors[k];
        if (neighbor == None || this->Known.Has(neighbor))
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
