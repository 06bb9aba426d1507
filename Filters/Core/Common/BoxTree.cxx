// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/BoxTree.h"

#include "Common/ParallelLoop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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

BoxTree::BoxTree(std::vector<Box> boxes)
  : Order(boxes.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  if (boxes.empty())
  {
    return;
  }
  const Id count = static_cast<Id>(boxes.size());
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
  this->Boxes.reserve(boxes.size());
  for (const Id i : this->Order)
  {
    this->Boxes.push_back(boxes[i]);
  }
}

/** Makes a part's node, and puts the boxes in order of its halves. @return false for a leaf */
bool BoxTree::Divide(const std::vector<Box>& boxes, const Part& part)
{
  Box bounds = boxes[this->Order[part.Begin]];
  for (Id k = part.Begin + 1; k < part.End; ++k)
  {
    bounds.Add(boxes[this->Order[k]]);
  }
  const std::size_t next = part.Node + NumberOfNodes(part.Size());
  const bool isLeaf = part.Size() <= LeafSize;
  this->Nodes[part.Node] = { bounds, part.Begin, isLeaf ? part.End : part.Begin, next };
  if (isLeaf)
  {
    return false;
  }
  const int axis = bounds.LongestAxis();
  const auto first = this->Order.begin();
  std::nth_element(first + part.Begin, first + part.Middle(), first + part.End,
    [&](Id a, Id b)
    {
      const double x = boxes[a].Low[axis] / 2 + boxes[a].High[axis] / 2;
      const double y = boxes[b].Low[axis] / 2 + boxes[b].High[axis] / 2;
      return x != y ? x < y : a < b;
    });
  return true;
}

/** Builds the subtree over a part. */
void BoxTree::Build(const std::vector<Box>& boxes, const Part& part)
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
