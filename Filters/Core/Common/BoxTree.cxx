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
constexpr Id LeafSize = 4;

/** Subtrees that one thread each builds. The levels above them are built one after the other. */
constexpr std::size_t ManySubtrees = 64;

/** To build its node, without those below. */
constexpr double NanosecondsPerBox = 15;

/** Of the tree over this many boxes. */
std::size_t NumberOfNodes(Id count)
{
  return count <= LeafSize ? 1 : 1 + NumberOfNodes(count / 2) + NumberOfNodes(count - count / 2);
}
} // namespace

/** A box on its way to its place: moved with its number, for boxes that are near in memory are
 * looked at much faster. */
struct BoxTree::NumberedBox
{
  Box Bounds;
  Id Number;
};

/** Of the order, and where its node stands, which follows from the sizes of those before it. */
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

BoxTree::BoxTree(std::vector<Box> given)
{
  if (given.empty())
  {
    return;
  }
  const Id count = static_cast<Id>(given.size());
  std::vector<NumberedBox> boxes;
  boxes.reserve(given.size());
  for (Id i = 0; i < count; ++i)
  {
    boxes.push_back({ given[i], i });
  }
  this->Nodes.resize(NumberOfNodes(count));
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
        this->Divide(boxes, level[i]);
        const std::array<Part, 2> both = level[i].Halves();
        std::copy(both.begin(), both.end(), &halves[2 * i]);
      });
    level.swap(halves);
  }
  const double levels = std::log2(static_cast<double>(level.front().Size())) + 1;
  forEach(cost * levels, [&](std::size_t i) { this->Build(boxes, level[i]); });
  this->Order.reserve(boxes.size());
  this->Boxes = std::move(given);
  for (Id i = 0; i < count; ++i)
  {
    this->Order.push_back(boxes[i].Number);
    this->Boxes[i] = boxes[i].Bounds;
  }
}

/** Makes a part's node, and puts the boxes in order of its halves. @return false for a leaf */
bool BoxTree::Divide(std::vector<NumberedBox>& boxes, const Part& part)
{
  Box bounds = boxes[part.Begin].Bounds;
  for (Id k = part.Begin + 1; k < part.End; ++k)
  {
    bounds.Add(boxes[k].Bounds);
  }
  const std::size_t next = part.Node + NumberOfNodes(part.Size());
  const bool isLeaf = part.Size() <= LeafSize;
  this->Nodes[part.Node] = { bounds, part.Begin, isLeaf ? part.End : part.Begin, next };
  if (isLeaf)
  {
    return false;
  }
  const int axis = bounds.LongestAxis();
  const auto first = boxes.begin();
  std::nth_element(first + part.Begin, first + part.Middle(), first + part.End,
    [&](const NumberedBox& a, const NumberedBox& b)
    {
      const double x = a.Bounds.Low[axis] / 2 + a.Bounds.High[axis] / 2;
      const double y = b.Bounds.Low[axis] / 2 + b.Bounds.High[axis] / 2;
      return x != y ? x < y : a.Number < b.Number;
    });
  return true;
}

/** Builds the subtree over a part. */
void BoxTree::Build(std::vector<NumberedBox>& boxes, const Part& part)
{
  if (this->Divide(boxes, part))
  {
    for (const Part& half : part.Halves())
    {
      this->Build(boxes, half);
    }
  }
}
} // namespace insideout
