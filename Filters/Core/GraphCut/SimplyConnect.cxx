// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SimplyConnect.h"

#include "Common/DisjointSets.h"
#include "Common/SortUniquely.h"

#include <algorithm>
#include <limits>
#include <map>
#include <queue>

namespace insideout
{
namespace
{
/** Limit of holes that are tried one by one: for each a new ball grows, which takes seconds for a
 * million cells. */
constexpr std::size_t MostMembranes = 16;

/** Faces of a cell, as bit sets of its corners. */
constexpr unsigned AllSets = 16;

/** A set of faces of a cell, closed under taking faces. */
class Faces
{
public:
  void Add(unsigned corners)
  {
    for (unsigned part = corners; part > 0; part = (part - 1) & corners)
    {
      this->Has[part] = true;
    }
  }

  bool HasAll(unsigned corners) const { return this->Has[corners]; }

  /** Whether they are contractible. In the boundary of a tetrahedron (a sphere) or a triangle this
   * holds if they are connected and have Euler characteristic 1. */
  bool AreContractible() const
  {
    int euler = 0;
    std::array<unsigned, 4> reached = { { 1, 2, 4, 8 } };
    unsigned points = 0;
    for (unsigned part = 1; part < AllSets; ++part)
    {
      if (!this->Has[part])
      {
        continue;
      }
      const int corners = CountBits(part);
      euler += corners % 2 == 1 ? 1 : -1;
      points |= part;
      for (int step = 0; corners == 2 && step < 4; ++step)
      {
        reached[step] |= (part >> step & 1u) != 0 ? part : 0u;
      }
    }
    if (euler != 1)
    {
      return false;
    }
    unsigned component = points & (~points + 1); // its lowest point
    for (int round = 0; round < 3; ++round)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        component |= (component >> corner & 1u) != 0 ? reached[corner] : 0u;
      }
    }
    return component == points;
  }

private:
  static int CountBits(unsigned set)
  {
    return static_cast<int>((set & 1u) + (set >> 1 & 1u) + (set >> 2 & 1u) + (set >> 3 & 1u));
  }

  std::array<bool, AllSets> Has = {};
};

/**
 * Per cell labelled `label`, the number of sides to the nearest cell with another label, from 1.
 */
std::vector<Id> Depths(
  const SimplicialCells& cells, const std::vector<unsigned char>& inside, unsigned char label)
{
  std::vector<Id> depths(inside.size(), 0);
  std::vector<Id> reached;
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    const SimplicialCells::Range beside = cells[cell];
    if (inside[cell] == label &&
      std::any_of(beside.begin(), beside.end(),
        [&](Id next) { return next != None && inside[next] != label; }))
    {
      depths[cell] = 1;
      reached.push_back(cell);
    }
  }
  for (std::size_t k = 0; k < reached.size(); ++k) // grows while it is read
  {
    for (const Id next : cells[reached[k]])
    {
      if (next != None && inside[next] == label && depths[next] == 0)
      {
        depths[next] = depths[reached[k]] + 1;
        reached.push_back(next);
      }
    }
  }
  return depths;
}

/** Cells by descending depth; ties: lowest first. */
using DeepestFirst = std::priority_queue<std::pair<Id, Id>>;

std::pair<Id, Id> EntryOf(const std::vector<Id>& depths, Id cell)
{
  return { depths[cell], -cell };
}

/**
 * Grow `label` in `changing` through sides, cell by cell, where a cell is simple and `mayChange`.
 * @param[in] starts cells to be checked first
 */
template <typename Predicate>
void Spread(const SimplicialCells& cells, const SimpleCells& simple, const std::vector<Id>& depths,
  const std::vector<Id>& starts, const Predicate& mayChange, unsigned char label,
  std::vector<unsigned char>& changing, const LoopProgress& visits)
{
  std::vector<Id> waiting = starts;
  std::size_t visit = 0;
  for (bool isChanged = true; isChanged;)
  {
    isChanged = false;
    DeepestFirst queue;
    for (const Id cell : waiting)
    {
      queue.push(EntryOf(depths, cell));
    }
    waiting.clear();
    while (!queue.empty())
    {
      visits.Check(visit++);
      const Id cell = -queue.top().second;
      queue.pop();
      if (changing[cell] == label)
      {
        continue;
      }
      if (!simple.IsSimple(changing, cell))
      {
        waiting.push_back(cell); // it may become simple later
        continue;
      }
      changing[cell] = label;
      isChanged = true;
      for (const Id next : cells[cell])
      {
        if (next != None && changing[next] != label && mayChange(next))
        {
          queue.push(EntryOf(depths, next));
        }
      }
    }
    SortUniquely(waiting);
  }
}

/** A ball of cells inside. */
std::vector<unsigned char> Cut(const SimplicialCells& cells, const SimpleCells& simple,
  const std::vector<unsigned char>& inside, const LoopProgress& visits)
{
  const std::vector<Id> depths = Depths(cells, inside, 1);
  std::vector<unsigned char> ball(inside.size(), 0);
  const Id deepest =
    static_cast<Id>(std::max_element(depths.begin(), depths.end()) - depths.begin());
  ball[deepest] = 1;
  std::vector<Id> starts;
  for (const Id next : cells[deepest])
  {
    if (next != None && inside[next])
    {
      starts.push_back(next);
    }
  }
  Spread(
    cells, simple, depths, starts, [&](Id cell) { return inside[cell] != 0; }, 1, ball, visits);
  return ball;
}

/** The hull minus cells outside. */
std::vector<unsigned char> Fill(const SimplicialCells& cells, const SimpleCells& simple,
  const std::vector<unsigned char>& inside, const LoopProgress& visits)
{
  const std::vector<Id> depths = Depths(cells, inside, 0);
  std::vector<unsigned char> ball(inside.size(), 1);
  std::vector<Id> starts;
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    const SimplicialCells::Range beside = cells[cell];
    if (!inside[cell] && std::find(beside.begin(), beside.end(), None) != beside.end())
    {
      starts.push_back(cell);
    }
  }
  Spread(
    cells, simple, depths, starts, [&](Id cell) { return inside[cell] == 0; }, 0, ball, visits);
  return ball;
}

/** Whether all fixed labels in `inside` are the same in `labels`. */
bool Obeys(const std::vector<unsigned char>& labels, const std::vector<unsigned char>& inside,
  const FixedLabels& fixed)
{
  for (std::size_t cell = 0; cell < labels.size(); ++cell)
  {
    if (fixed.Cells[cell] && labels[cell] != inside[cell])
    {
      return false;
    }
  }
  const auto has = [](const std::vector<unsigned char>& set, const FacetPiece& piece)
  { return set[piece.First] || (piece.Second != None && set[piece.Second]); };
  return !fixed.Pieces ||
    std::all_of(fixed.Pieces->begin(), fixed.Pieces->end(),
      [&](const FacetPiece& piece) { return has(labels, piece) || !has(inside, piece); });
}

/** The filled holes, components of cells connected by points; cheapest first. */
std::vector<std::vector<Id>> Membranes(const SimplicialCells& cells, const CutEnergy& energy,
  const std::vector<unsigned char>& inside, const std::vector<unsigned char>& filled)
{
  DisjointSets sets(cells.NumberOfPoints);
  const auto isAdded = [&](Id cell) { return filled[cell] && !inside[cell]; };
  const Id count = static_cast<Id>(inside.size());
  for (Id cell = 0; cell < count; ++cell)
  {
    const SimplicialCells::Range corners = cells.CornersOf(cell);
    for (const Id* corner = corners.begin(); isAdded(cell) && corner != corners.end(); ++corner)
    {
      sets.Join(*corners.begin(), *corner);
    }
  }
  std::map<Id, std::pair<double, std::vector<Id>>> bySet;
  std::vector<unsigned char> labels = inside;
  for (Id cell = 0; cell < count; ++cell)
  {
    if (isAdded(cell))
    {
      auto& [cost, members] = bySet[sets.Find(*cells.CornersOf(cell).begin())];
      cost += GrowthByFlip(energy, labels, cell);
      members.push_back(cell);
      labels[cell] = 1;
    }
  }
  std::vector<std::pair<double, std::vector<Id>>> byCost;
  for (const auto& [set, membrane] : bySet)
  {
    byCost.push_back(membrane);
  }
  std::sort(byCost.begin(), byCost.end());
  std::vector<std::vector<Id>> membranes;
  for (const auto& [cost, members] : byCost)
  {
    membranes.push_back(members);
  }
  return membranes;
}

/** The Euler characteristic of the cells inside with all their sides, edges and points. */
Id EulerCharacteristic(const SimplicialCells& cells, const std::vector<unsigned char>& inside)
{
  std::vector<Id> points;
  std::vector<std::array<Id, 2>> edges;
  Id tops = 0;
  Id sides = 0; // sides that two cells share occur twice
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    if (!inside[cell])
    {
      continue;
    }
    ++tops;
    for (const Id next : cells[cell])
    {
      sides += next == None || !inside[next] ? 2 : 1;
    }
    const SimplicialCells::Range corners = cells.CornersOf(cell);
    points.insert(points.end(), corners.begin(), corners.end());
    for (const Id* a = corners.begin(); a != corners.end(); ++a)
    {
      for (const Id* b = a + 1; b != corners.end(); ++b)
      {
        edges.push_back({ { std::min(*a, *b), std::max(*a, *b) } });
      }
    }
  }
  SortUniquely(points);
  SortUniquely(edges);
  const Id low = static_cast<Id>(points.size()) - static_cast<Id>(edges.size());
  return cells.NumberOfCorners == 4 ? low + sides / 2 - tops : low + tops;
}

/** Whether the boundary sides of the cells inside are connected by points, as a ball's are. */
bool IsBoundaryConnected(const SimplicialCells& cells, const std::vector<unsigned char>& inside)
{
  DisjointSets sets(cells.NumberOfPoints);
  std::vector<Id> onBoundary;
  for (Id cell = 0; cell < static_cast<Id>(inside.size()); ++cell)
  {
    const Id* const corners = cells.CornersOf(cell).First;
    for (std::size_t k = 0; inside[cell] && k < cells.NumberOfCorners; ++k)
    {
      const Id next = cells[cell].First[k];
      const Id first = corners[k == 0 ? 1 : 0]; // of the side
      for (std::size_t c = 0; (next == None || !inside[next]) && c < cells.NumberOfCorners; ++c)
      {
        if (c != k)
        {
          sets.Join(first, corners[c]);
          onBoundary.push_back(first);
        }
      }
    }
  }
  return std::all_of(onBoundary.begin(), onBoundary.end(),
    [&](Id point) { return sets.Find(point) == sets.Find(onBoundary.front()); });
}
} // namespace

SimpleCells::SimpleCells(const SimplicialCells& cells)
  : Cells(cells)
  , AtPoints(CellsAtPoints(cells))
{
}

bool SimpleCells::IsSimple(const std::vector<unsigned char>& inside, Id cell) const
{
  const Id* const corners = this->Cells.CornersOf(cell).First;
  const unsigned count = static_cast<unsigned>(this->Cells.NumberOfCorners);
  const unsigned all = (1u << count) - 1;
  Faces shared;
  for (unsigned k = 0; k < count; ++k)
  {
    const Id next = this->Cells[cell].First[k];
    if (next != None && inside[next])
    {
      shared.Add(all & ~(1u << k));
    }
  }
  for (unsigned k = 0; k < count; ++k)
  {
    bool isComplete = true; // all edges here are shared already
    for (unsigned other = 0; other < count; ++other)
    {
      isComplete = isComplete && (other == k || shared.HasAll(1u << k | 1u << other));
    }
    if (isComplete)
    {
      continue;
    }
    for (const Id around : this->AtPoints[corners[k]])
    {
      if (around == cell || !inside[around])
      {
        continue;
      }
      unsigned common = 0;
      for (const Id point : this->Cells.CornersOf(around))
      {
        for (unsigned corner = 0; corner < count; ++corner)
        {
          common |= corners[corner] == point ? 1u << corner : 0u;
        }
      }
      shared.Add(common);
    }
  }
  return shared.AreContractible();
}

bool SimpleCells::Allows(const GreedyLabels& labels, Id cell)
{
  return this->IsSimple(labels.Labels(), cell);
}

bool IsBall(const SimplicialCells& cells, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<unsigned char> isOpen = FindOutside(cells, inside, monitor, progress).IsOpen;
  // One component, no cavity; Euler's formula then excludes tunnels. In a plane holes are cavities.
  // If the cells do not fill a convex hull, a gap between them may be a cavity as well: its
  // boundary is separate.
  return FindRegions(cells, inside, monitor, progress).Count == 1 &&
    std::find(isOpen.begin(), isOpen.end(), 0) == isOpen.end() &&
    EulerCharacteristic(cells, inside) == 1 && IsBoundaryConnected(cells, inside);
}

bool SimplyConnect(const SimplicialCells& cells, const CutEnergy& energy, const FixedLabels& fixed,
  std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress)
{
  const auto range = [&](std::size_t step)
  {
    const double at = progress.At(static_cast<double>(step) / (MostMembranes + 2));
    return ProgressRange{ progress.Stage, at, at };
  };
  if (std::find(inside.begin(), inside.end(), 1) == inside.end() ||
    IsBall(cells, inside, monitor, range(0)))
  {
    return true;
  }
  const SimpleCells simple(cells);
  std::vector<unsigned char> best;
  double least = std::numeric_limits<double>::infinity();
  /** Whether the ball has less energy than the best so far. */
  const auto take = [&](const std::vector<unsigned char>& ball, std::size_t step)
  {
    const double cost = energy.Of(ball);
    const bool isBetter =
      cost < least && Obeys(ball, inside, fixed) && IsBall(cells, ball, monitor, range(step));
    if (isBetter)
    {
      best = ball;
      least = cost;
    }
    return isBetter;
  };
  const auto cut = [&](const std::vector<unsigned char>& labels, std::size_t step)
  { return Cut(cells, simple, labels, LoopProgress(monitor, range(step), labels.size())); };

  take(cut(inside, 0), 0);
  const std::vector<unsigned char> filled =
    Fill(cells, simple, inside, LoopProgress(monitor, range(1), inside.size()));
  take(filled, 1);
  std::vector<unsigned char> some = inside;
  const std::vector<std::vector<Id>> membranes = Membranes(cells, energy, inside, filled);
  for (std::size_t m = 0; m < std::min(membranes.size(), MostMembranes); ++m)
  {
    std::vector<unsigned char> more = some;
    for (const Id cell : membranes[m])
    {
      more[cell] = 1;
    }
    if (take(cut(more, m + 2), m + 2))
    {
      some = more;
    }
  }
  if (!best.empty())
  {
    inside = best;
  }
  return !best.empty();
}
} // namespace insideout
