// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/DisjointSets.h"
#include "Common/LoopProgress.h"
#include "Common/Types.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace insideout
{
/** Cells that share a point only if sides connect them around it. */
template <std::size_t Corners>
struct PartedCells
{
  std::vector<std::array<Id, Corners>> Cells; ///< outside cells are unchanged
  std::vector<Id> Places; ///< per point the one that it is a copy of; the original points first
};

/**
 * Separate the inside cells at each point into groups connected through sides at the point. The
 * first group keeps the point, each other one gets a copy (vertex and edge duplication of Attene,
 * Giorgi, Ferri and Falcidieno 2009). Copies are numbered by their first cell. Cells inside keep
 * the places of their points, and share the same sides.
 *
 * In the plane the groups are fans, and at each point of the boundary two of its edges end. In
 * space a group may surround a space that it does not fill, and touch itself: see ManifoldBoundary.
 *
 * @param[in] neighbors of each cell, None where there is none
 * @param[in] inside one value per cell, 0 for outside
 * @param[in] parted one value per point, 0 for points to leave alone
 * @throws Error Stopped
 */
template <std::size_t Corners>
PartedCells<Corners> PartCells(const std::vector<std::array<Id, Corners>>& cells,
  const std::vector<std::array<Id, Corners>>& neighbors, const std::vector<unsigned char>& inside,
  const std::vector<unsigned char>& parted, Monitor& monitor, const ProgressRange& progress)
{
  const auto count = static_cast<Id>(cells.size());
  const LoopProgress turns(monitor, progress, 2 * cells.size());
  const auto cornerOf = [](Id cell, std::size_t k)
  { return static_cast<Id>(Corners) * cell + static_cast<Id>(k); };
  DisjointSets sets(Corners * cells.size());
  for (Id cell = 0; cell < count; ++cell)
  {
    turns.Check(static_cast<std::size_t>(cell));
    for (const Id next : neighbors[cell])
    {
      if (next <= cell || !inside[cell] || !inside[next]) // each side once
      {
        continue;
      }
      for (std::size_t k = 0; k < Corners; ++k)
      {
        const auto other = std::find(cells[next].begin(), cells[next].end(), cells[cell][k]);
        if (other != cells[next].end())
        {
          sets.Join(cornerOf(cell, k),
            cornerOf(next, static_cast<std::size_t>(other - cells[next].begin())));
        }
      }
    }
  }

  PartedCells<Corners> result;
  result.Cells = cells;
  result.Places.resize(parted.size());
  std::iota(result.Places.begin(), result.Places.end(), 0);
  std::vector<unsigned char> isTaken(parted.size(), 0);
  // indices of the first corner of each group
  std::vector<Id> pointOf(Corners * cells.size(), None);
  for (Id cell = 0; cell < count; ++cell)
  {
    turns.Check(static_cast<std::size_t>(count + cell));
    for (std::size_t k = 0; inside[cell] != 0 && k < Corners; ++k)
    {
      const Id place = cells[cell][k];
      Id& point = pointOf[sets.Find(cornerOf(cell, k))];
      if (point == None && parted[place] && isTaken[place])
      {
        point = static_cast<Id>(result.Places.size());
        result.Places.push_back(place);
      }
      else if (point == None)
      {
        point = place;
        isTaken[place] = 1;
      }
      result.Cells[cell][k] = point;
    }
  }
  return result;
}
} // namespace insideout
