// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/ConnectRegions.h"

#include "Common/DisjointSets.h"
#include "Common/SortUniquely.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

namespace insideout
{
namespace
{
constexpr double Unreached = std::numeric_limits<double>::infinity();

/** The smoothness term of the side between two cells with different labels. */
double CostBetween(const CutEnergy& energy, Id cell, Id beyond)
{
  for (const CutEnergy::Neighbor& neighbor : energy.Neighbors(cell))
  {
    if (neighbor.Cell == beyond)
    {
      return energy.CostInEnergy(neighbor);
    }
  }
  return 0;
}

/** The shortest way from the nearest part of the solid to each cell. */
struct Ways
{
  std::vector<double> Costs; ///< 0 for cells inside
  std::vector<Id> Regions;   ///< the part that the way starts from; None for cells without a way
  std::vector<Id> Previous;  ///< the cell before on the way; None for cells inside
};

/** Dijkstra's algorithm from all parts at once, through outside cells whose label may change. */
Ways FindWays(const SimplicialCells& cells, const CutEnergy& energy, const FixedLabels& fixed,
  const std::vector<unsigned char>& inside, const SolidRegions& regions, Monitor& monitor,
  const ProgressRange& progress)
{
  Ways ways = { std::vector<double>(inside.size(), Unreached), regions.OfCell,
    std::vector<Id>(inside.size(), None) };
  using Entry = std::pair<double, Id>; // ties: the lowest cell first
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    if (inside[cell])
    {
      ways.Costs[cell] = 0;
      queue.emplace(0.0, cell);
    }
  }
  const LoopProgress visits(monitor, progress, inside.size());
  for (std::size_t visit = 0; !queue.empty(); ++visit)
  {
    visits.Check(visit);
    const auto [cost, cell] = queue.top();
    queue.pop();
    if (cost > ways.Costs[cell])
    {
      continue; // a shorter way was found meanwhile
    }
    for (const Id next : cells[cell])
    {
      if (next == None || inside[next] || fixed.Cells[next])
      {
        continue;
      }
      // The side crossed by the way counts as a side to the outside in both of its cells.
      const double step = GrowthByFlip(energy, inside, next) -
        (inside[cell] ? 0 : 2 * CostBetween(energy, cell, next));
      const double whole = cost + std::max(step, 0.0);
      if (whole < ways.Costs[next])
      {
        ways.Costs[next] = whole;
        ways.Regions[next] = ways.Regions[cell];
        ways.Previous[next] = cell;
        queue.emplace(whole, next);
      }
    }
  }
  return ways;
}

/** An action that reduces the number of parts by one, and the energy it adds. */
struct Action
{
  double Cost;
  Id First;  ///< a cell at the end of the way; or None
  Id Second; ///< the cell beyond, reached from another part; or the part to be dropped

  bool operator<(const Action& other) const
  {
    // Ties: joining comes before dropping.
    return std::make_tuple(this->Cost, this->First == None, this->First, this->Second) <
      std::make_tuple(other.Cost, other.First == None, other.First, other.Second);
  }
};

/** Each side at which ways from two parts meet, once. */
void AddMeetings(const SimplicialCells& cells, const CutEnergy& energy,
  const std::vector<unsigned char>& inside, const Ways& ways, std::vector<Action>& actions)
{
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    for (const Id beyond : cells[cell])
    {
      if (beyond > cell && ways.Regions[cell] != None && ways.Regions[beyond] != None &&
        ways.Regions[cell] != ways.Regions[beyond])
      {
        const double shared =
          inside[cell] || inside[beyond] ? 0 : 2 * CostBetween(energy, cell, beyond);
        actions.push_back(
          { std::max(ways.Costs[cell] + ways.Costs[beyond] - shared, 0.0), cell, beyond });
      }
    }
  }
}

/** The energy added by dropping each part; infinite if that is forbidden. */
std::vector<double> CostsOfDropping(const CutEnergy& energy, const FixedLabels& fixed,
  const std::vector<unsigned char>& inside, const SolidRegions& regions)
{
  std::vector<double> costs(static_cast<std::size_t>(regions.Count), 0.0);
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    if (!inside[cell])
    {
      continue;
    }
    double& cost = costs[regions.OfCell[cell]];
    cost -= energy.ExtraInside(cell);
    for (const CutEnergy::Neighbor& neighbor : energy.Neighbors(cell))
    {
      cost -= inside[neighbor.Cell] ? 0 : energy.CostInEnergy(neighbor);
    }
    if (fixed.Cells[cell])
    {
      cost = Unreached;
    }
  }
  const auto regionOf = [&](Id cell) { return cell == None ? None : regions.OfCell[cell]; };
  for (std::size_t p = 0; fixed.Pieces && p < fixed.Pieces->size(); ++p)
  {
    const Id first = regionOf((*fixed.Pieces)[p].First);
    const Id second = regionOf((*fixed.Pieces)[p].Second);
    if (first == None || second == None || first == second)
    {
      const Id needed = std::max(first, second);
      if (needed != None)
      {
        costs[needed] = Unreached;
      }
    }
  }
  return costs;
}

Buckets<Id> CellsOf(const SolidRegions& regions)
{
  return Buckets<Id>(static_cast<std::size_t>(regions.Count),
    [&](const auto& visit)
    {
      for (std::size_t cell = 0; cell < regions.OfCell.size(); ++cell)
      {
        if (regions.OfCell[cell] != None)
        {
          visit(static_cast<std::size_t>(regions.OfCell[cell]), static_cast<Id>(cell));
        }
      }
    });
}

/** Perform a list of actions, as far as each is still valid. */
class Round
{
public:
  Round(const Ways& ways, const SolidRegions& regions, std::vector<unsigned char>& inside,
    ConnectedRegions& result)
    : Found(ways)
    , CellsOfRegions(CellsOf(regions))
    , Inside(inside)
    , Result(result)
    , Sets(static_cast<std::size_t>(regions.Count))
    , Was(static_cast<std::size_t>(regions.Count), Untouched)
  {
  }

  void Do(const Action& action)
  {
    if (action.First == None)
    {
      this->Drop(action.Second);
    }
    else
    {
      this->Join(action.First, action.Second);
    }
  }

private:
  enum State : unsigned char
  {
    Untouched,
    IsJoined,
    IsDropped,
    Waits ///< for new ways: the next part was dropped
  };

  void Drop(Id region)
  {
    if (this->Was[region] != Untouched || this->Result.Left == 1)
    {
      return;
    }
    for (const Id cell : this->CellsOfRegions[region])
    {
      this->Inside[cell] = 0;
      this->Result.Dropped.push_back(cell);
    }
    this->Was[region] = IsDropped;
    ++this->Result.DroppedRegions;
    --this->Result.Left;
  }

  void Join(Id first, Id second)
  {
    const Id from = this->Found.Regions[first];
    const Id to = this->Found.Regions[second];
    const auto isOpen = [&](Id region)
    { return this->Was[region] == Untouched || this->Was[region] == IsJoined; };
    if (!isOpen(from) || !isOpen(to))
    {
      for (const Id region : { from, to })
      {
        this->Was[region] = this->Was[region] == Untouched ? Waits : this->Was[region];
      }
      return;
    }
    if (this->Sets.Find(from) == this->Sets.Find(to))
    {
      return;
    }
    this->Sets.Join(from, to);
    this->Was[from] = this->Was[to] = IsJoined;
    for (Id cell : { first, second })
    {
      for (; this->Found.Previous[cell] != None; cell = this->Found.Previous[cell])
      {
        this->Inside[cell] = 1;
      }
    }
    ++this->Result.Joined;
    --this->Result.Left;
  }

  const Ways& Found;
  const Buckets<Id> CellsOfRegions;
  std::vector<unsigned char>& Inside;
  ConnectedRegions& Result;
  DisjointSets Sets;
  std::vector<State> Was;
};
} // namespace

double GrowthByFlip(const CutEnergy& energy, const std::vector<unsigned char>& inside, Id cell)
{
  double growth = energy.ExtraInside(cell);
  for (const CutEnergy::Neighbor& neighbor : energy.Neighbors(cell))
  {
    const double cost = energy.CostInEnergy(neighbor);
    growth += inside[neighbor.Cell] ? -cost : cost;
  }
  return inside[cell] ? -growth : growth;
}

ConnectedRegions ConnectRegions(const SimplicialCells& cells, const CutEnergy& energy,
  const FixedLabels& fixed, std::vector<unsigned char>& inside, Monitor& monitor,
  const ProgressRange& progress)
{
  const ProgressRange round = { progress.Stage, progress.Begin, progress.Begin };
  ConnectedRegions result;
  for (Id before = None;; before = result.Left)
  {
    const SolidRegions regions = FindRegions(cells, inside, monitor, round);
    result.Left = regions.Count;
    if (regions.Count < 2 || regions.Count == before)
    {
      return result;
    }
    const Ways ways = FindWays(cells, energy, fixed, inside, regions, monitor, round);
    std::vector<Action> actions;
    AddMeetings(cells, energy, inside, ways, actions);
    const std::vector<double> dropping = CostsOfDropping(energy, fixed, inside, regions);
    for (Id region = 0; region < regions.Count; ++region)
    {
      if (dropping[region] < Unreached)
      {
        actions.push_back({ dropping[region], None, region });
      }
    }
    std::sort(actions.begin(), actions.end());
    Round doing(ways, regions, inside, result);
    for (const Action& action : actions)
    {
      doing.Do(action);
    }
    result.Left = regions.Count;
  }
}

Buckets<Id> CellsAtPoints(const SimplicialCells& cells)
{
  return Buckets<Id>(cells.NumberOfPoints,
    [&](const auto& visit)
    {
      for (Id cell = 0; cell < static_cast<Id>(cells.size()); ++cell)
      {
        for (const Id point : cells.CornersOf(cell))
        {
          visit(static_cast<std::size_t>(point), cell);
        }
      }
    });
}

OneRegion::OneRegion(const SimplicialCells& cells)
  : Cells(cells)
  , AtPoints(CellsAtPoints(cells))
{
}

bool OneRegion::Allows(const GreedyLabels& labels, Id cell)
{
  std::vector<Id> beside;
  for (const Id next : this->Cells[cell])
  {
    if (next != None && labels.IsInside(next))
    {
      beside.push_back(next);
    }
  }
  if (!labels.IsInside(cell) || beside.size() < 2)
  {
    return !beside.empty();
  }
  std::vector<Id> around;
  for (const Id point : this->Cells.CornersOf(cell))
  {
    for (const Id other : this->AtPoints[point])
    {
      if (other != cell && labels.IsInside(other))
      {
        around.push_back(other);
      }
    }
  }
  SortUniquely(around);
  const auto indexOf = [&](Id other) -> Id
  {
    const auto found = std::lower_bound(around.begin(), around.end(), other);
    return found != around.end() && *found == other ? static_cast<Id>(found - around.begin())
                                                    : None;
  };
  DisjointSets sets(around.size());
  for (std::size_t i = 0; i < around.size(); ++i)
  {
    for (const Id next : this->Cells[around[i]])
    {
      const Id j = next == None ? None : indexOf(next);
      if (j != None)
      {
        sets.Join(static_cast<Id>(i), j);
      }
    }
  }
  return std::all_of(beside.begin(), beside.end(),
    [&](Id next) { return sets.Find(indexOf(next)) == sets.Find(indexOf(beside.front())); });
}
} // namespace insideout
