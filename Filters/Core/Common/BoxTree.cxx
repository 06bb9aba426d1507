// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/BoxTree.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insideout
{
namespace
{
/** Leaf size; for speed only: 4 to 32 boxes take equally long. */
constexpr Id LeafSize = 4;

/** Subtrees that are built by one thread each. The levels above them are built one by one. */
constexpr std::size_t ManySubtrees = 64;

/** Cost of building a node, without its descendants. */
constexpr double NanosecondsPerBox = 15;

/** The sizes of nodes of a tree over this many boxes, level by level: each level has only two. */
std::size_t NumberOfNodes(Id count)
{
  Id size = count;         // size of the smaller nodes of a level
  std::size_t smaller = 1; // how many of that size there are
  std::size_t larger = 0;  // number of nodes with one box more
  std::size_t nodes = 1;
  while (size > LeafSize || (size == LeafSize && larger > 0))
  {
    const std::size_t divided = size > LeafSize ? smaller : 0;
    nodes += 2 * (divided + larger);
    const bool isOdd = size % 2 != 0;
    smaller = isOdd ? divided : 2 * divided + larger;
    larger = isOdd ? divided + 2 * larger : larger;
    size /= 2;
  }
  return nodes;
}
} // namespace

/** The center of a box, moved together with its number: access to centers in contiguous memory is
 * much faster. */
struct BoxTree::Centre
{
  Point At;
  Id Number;
};

/**
 * A range of the order, and the position of its node, which follows from the sizes of earlier ones.
 */
struct BoxTree::Part
{
  Id Begin;
  Id End;
  std::size_t Node;

  Id Size() const { return this->End - this->Begin; }
  Id Middle() const { return this->Begin + this->Size() / 2; }

  std::array<Part, 2> Halves() const
  {
    const Id middle = this->Middle();
    return { { { this->Begin, middle, this->Node + 1 },
      { middle, this->End, this->Node + 1 + NumberOfNodes(middle - this->Begin) } } };
  }
};

BoxTree::BoxTree(const Box* given, std::size_t size)
{
  if (size == 0)
  {
    return;
  }
  const Id count = static_cast<Id>(size);
  RawVector<Centre> centres(size);
  ParallelLoop(count, NanosecondsPerBox,
    [&](Id i)
    {
      const auto& [low, high] = given[i];
      centres[i] = {
        { low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2, low[2] / 2 + high[2] / 2 }, i
      };
    });
  this->Nodes.resize(NumberOfNodes(count));
  this->Order.resize(size);
  this->Boxes.resize(size);
  std::vector<Part> above; // the ranges of the levels that are divided one by one
  std::vector<Part> level = { { 0, count, 0 } };
  const auto forEach = [&](double cost, const auto& body)
  { ParallelLoop(level.size(), cost / static_cast<double>(level.size()), body); };
  const double cost = NanosecondsPerBox * count;
  while (level.size() < ManySubtrees && level.front().Size() > LeafSize)
  {
    std::vector<Part> halves(2 * level.size());
    forEach(cost,
      [&](std::size_t i)
      {
        Divide(centres, level[i]);
        const std::array<Part, 2> both = level[i].Halves();
        std::copy(both.begin(), both.end(), &halves[2 * i]);
      });
    above.insert(above.end(), level.begin(), level.end());
    level.swap(halves);
  }
  const double levels = std::log2(static_cast<double>(level.front().Size())) + 1;
  forEach(cost * levels, [&](std::size_t i) { this->Build(centres, given, level[i]); });
  for (auto part = above.rbegin(); part != above.rend(); ++part)
  {
    this->Join(*part);
  }
}

BoxTree BoxTree::OfPoints(const std::vector<Point>& points)
{
  RawVector<Box> boxes(points.size());
  ParallelLoop(points.size(), NanosecondsPerBox,
    [&](std::size_t p) {
      boxes[p] = { points[p], points[p] };
    });
  return BoxTree(boxes);
}

std::vector<Id> BoxTree::SetsOfParts(const std::vector<Id>& setOf) const
{
  std::vector<Id> sets(this->Nodes.size(), None);
  for (std::size_t node = this->Nodes.size(); node-- > 0;)
  {
    const Node& here = this->Nodes[node];
    const auto first = this->Order.begin() + here.Begin;
    const auto last = this->Order.begin() + here.End;
    if (first == last)
    {
      const Id second = sets[this->Nodes[node + 1].Next];
      sets[node] = sets[node + 1] == second ? second : None;
    }
    else
    {
      const Id set = setOf[*first];
      sets[node] = std::all_of(first, last, [&](Id i) { return setOf[i] == set; }) ? set : None;
    }
  }
  return sets;
}

/** Partition the centers of a range into halves along the axis of their largest extent. */
void BoxTree::Divide(RawVector<Centre>& centres, const Part& part)
{
  Box bounds = Box::Empty();
  for (Id k = part.Begin; k < part.End; ++k)
  {
    bounds.Add(centres[k].At);
  }
  const int axis = bounds.LongestAxis();
  const auto first = centres.begin();
  std::nth_element(first + part.Begin, first + part.Middle(), first + part.End,
    [axis](const Centre& a, const Centre& b)
    { return a.At[axis] != b.At[axis] ? a.At[axis] < b.At[axis] : a.Number < b.Number; });
}

/** Builds the subtree over a range. */
void BoxTree::Build(RawVector<Centre>& centres, const Box* given, const Part& part)
{
  if (part.Size() > LeafSize)
  {
    Divide(centres, part);
    for (const Part& half : part.Halves())
    {
      this->Build(centres, given, half);
    }
    this->Join(part);
    return;
  }
  Box bounds = Box::Empty();
  for (Id k = part.Begin; k < part.End; ++k)
  {
    this->Order[k] = centres[k].Number;
    this->Boxes[k] = given[this->Order[k]];
    bounds.Add(this->Boxes[k]);
  }
  this->Nodes[part.Node] = { bounds, part.Begin, part.End, part.Node + 1 };
}

/** Make the node of a range whose halves have theirs. */
void BoxTree::Join(const Part& part)
{
  const auto [first, second] = part.Halves();
  Box bounds = this->Nodes[first.Node].Bounds;
  bounds.Add(this->Nodes[second.Node].Bounds);
  this->Nodes[part.Node] = { bounds, part.Begin, part.Begin,
    part.Node + NumberOfNodes(part.Size()) };
}
} // namespace insideout
