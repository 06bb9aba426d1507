// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SliverTree.h"

#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/SolidAngle.h"
#include "WindingNumber/SpatialOrder.h"
#include "WindingNumber/StraightCaps.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// The slivers of a node are left out if they add less than this to a winding number.
constexpr double LeastSeen = 0x1p-50;

constexpr double NanosecondsPerSliver = 100;

double SquaredDistance(const Box& a, const Box& b)
{
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double gap =
      std::max(std::max(a.Low[axis] - b.High[axis], b.Low[axis] - a.High[axis]), 0.0);
    squared += gap * gap;
  }
  return squared;
}
} // namespace

SliverTree::SliverTree(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& slivers)
{
  // Long slivers apart from short ones, because their boxes are large.
  std::vector<Point> middles(slivers.size());
  std::vector<int> size(slivers.size());
  ParallelLoop(slivers.size(), NanosecondsPerSliver,
    [&](std::size_t i)
    {
      const auto [a, b, c] = CornersOf(points, slivers[i].Corners);
      middles[i] = b;
      size[i] = std::ilogb(Distance(a, c));
    });
  std::vector<Id> order = SpatialOrder(middles);
  std::stable_sort(order.begin(), order.end(), [&](Id i, Id j) { return size[i] > size[j]; });
  this->Slivers.resize(slivers.size());
  this->Counts.resize(slivers.size());
  ParallelLoop(slivers.size(), NanosecondsPerSliver,
    [&](std::size_t i)
    {
      const CountedTriangle& sliver = slivers[order[i]];
      this->Slivers[i] = MakeSliver(CornersOf(points, sliver.Corners), sliver.Count);
      this->Counts[i] = sliver.Count;
    });
  for (std::size_t first = 0, next = 0; first < order.size(); first = next)
  {
    while (next < order.size() && size[order[next]] == size[order[first]])
    {
      ++next;
    }
    this->Build(first, next);
  }
}

void SliverTree::Build(std::size_t first, std::size_t last)
{
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({});
  Node here = { Box::Empty(), 0, first, last, this->Lines.size(), 0 };
  if (last - first <= Lanes)
  {
    SliverLines lines = {};
    for (std::size_t i = first; i < last; ++i)
    {
      const int lane = static_cast<int>(i - first);
      SetLine(lines, lane, this->Slivers[i]);
      here.Area += lines.Area[lane];
      for (const Point& corner : this->Slivers[i].Corners)
      {
        here.Bounds.Add(corner);
      }
    }
    this->Lines.push_back(lines);
  }
  else
  {
    here.First = here.Last;
    const std::size_t middle = first + (last - first) / 2;
    const std::size_t left = this->Nodes.size();
    this->Build(first, middle);
    const std::size_t right = this->Nodes.size();
    this->Build(middle, last);
    for (const std::size_t child : { left, right })
    {
      here.Bounds.Add(this->Nodes[child].Bounds);
      here.Area += this->Nodes[child].Area;
    }
  }
  here.Next = this->Nodes.size();
  this->Nodes[node] = here;
}

Box BoxOfSites(const SiteBlock& sites)
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [low, high] = std::minmax_element(sites.High[axis], sites.High[axis] + Lanes);
    box.Low[axis] = *low;
    box.High[axis] = *high;
  }
  return box;
}

namespace
{
/** Calls visit(i) for each line i that may be seen from a place in the box. */
template <typename Visitor>
void VisitSeen(const SliverLines* lines, std::size_t count, const Box& box, const Visitor& visit)
{
  Point centre;
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis] = box.Low[axis] / 2 + box.High[axis] / 2;
  }
  // A sliver's corners are nearly on one line.
  const double radius = Distance(centre, box.High) * (1 + 0x1p-40) + 2 * ReachOfStraightCap;
  for (std::size_t first = 0; first < count; first += Lanes, ++lines)
  {
    double seen[Lanes];
    SeeSlivers(*lines, centre, radius, LeastSeen, seen);
    for (std::size_t i = first; i < std::min(count, first + Lanes); ++i)
    {
      if (seen[i - first] > 0)
      {
        visit(i);
      }
    }
  }
}

void CopyLine(const SliverLines& lines, std::size_t from, SliverLines& others, std::size_t to)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    others.From[axis][to] = lines.From[axis][from];
    others.Along[axis][to] = lines.Along[axis][from];
  }
  others.InverseSquare[to] = lines.InverseSquare[from];
  others.Area[to] = lines.Area[from];
  others.Width[to] = lines.Width[from];
}
} // namespace

SliverTree::Selection SliverTree::Select(const Box& box) const
{
  Selection selection;
  const auto take = [&](const Node& node, std::size_t from)
  {
    const std::size_t to = selection.Slivers.size() % Lanes;
    if (to == 0)
    {
      selection.Lines.push_back({});
    }
    CopyLine(this->Lines[node.Lines], from, selection.Lines.back(), to);
    selection.Slivers.push_back(static_cast<Id>(node.First + from));
  };
  for (std::size_t i = 0; i < this->Nodes.size();)
  {
    const Node& node = this->Nodes[i];
    if (node.Area <= LeastSeen * SquaredDistance(node.Bounds, box))
    {
      i = node.Next;
      continue;
    }
    if (node.First < node.Last)
    {
      VisitSeen(&this->Lines[node.Lines], node.Last - node.First, box,
        [&](std::size_t k) { take(node, k); });
    }
    ++i;
  }
  return selection;
}

void SliverTree::AddOne(
  std::size_t sliver, const Sites& sites, const SiteProducts& block, double (&sums)[Lanes]) const
{
  double undecided[Lanes];
  if (!AddSliver(this->Slivers[sliver], block.Rounded, sums, undecided))
  {
    return;
  }
  for (int lane = 0; lane < Lanes; ++lane)
  {
    if (undecided[lane] > 0)
    {
      sums[lane] += this->Counts[sliver] *
        std::arg(HalfSolidAngle(this->Slivers[sliver].Corners, sites[block.Index[lane]]));
    }
  }
}

void SliverTree::Add(const Selection& selection, const Sites& sites, const SiteProducts& block,
  double (&sums)[Lanes]) const
{
  VisitSeen(selection.Lines.data(), selection.Slivers.size(), BoxOfSites(block.Rounded),
    [&](std::size_t i)
    { this->AddOne(static_cast<std::size_t>(selection.Slivers[i]), sites, block, sums); });
}
} // namespace insideout
