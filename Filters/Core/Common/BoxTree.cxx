// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
constexpr Id LeafSize = 4;

/** Boxes for which another thread is worth its while. */
constexpr Id TaskSize = 4096;

/** Of the tree over this many boxes. */
std::size_t NumberOfNodes(Id count)
{
  return count <= LeafSize ? 1 : 1 + NumberOfNodes(count / 2) + NumberOfNodes(count - count / 2);
}
} // namespace

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
#pragma omp parallel if (count > TaskSize)
#pragma omp single
  this->Build(boxes, 0, count, 0);
  this->Boxes.reserve(boxes.size());
  for (const Id i : this->Order)
  {
    this->Boxes.push_back(boxes[i]);
  }
}

/** Builds the subtree over a part of the order. Where its nodes stand follows from its size. */
void BoxTree::Build(const std::vector<Box>& boxes, Id begin, Id end, std::size_t node)
{
  Box bounds = boxes[this->Order[begin]];
  for (Id k = begin + 1; k < end; ++k)
  {
    bounds.Add(boxes[this->Order[k]]);
  }
  const std::size_t next = node + NumberOfNodes(end - begin);
  if (end - begin <= LeafSize)
  {
    this->Nodes[node] = { bounds, begin, end, next };
    return;
  }
  this->Nodes[node] = { bounds, begin, begin, next };
  const int axis = bounds.LongestAxis();
  const Id middle = begin + (end - begin) / 2;
  const auto first = this->Order.begin();
  std::nth_element(first + begin, first + middle, first + end,
    [&](Id a, Id b)
    {
      const double x = boxes[a].Low[axis] / 2 + boxes[a].High[axis] / 2;
      const double y = boxes[b].Low[axis] / 2 + boxes[b].High[axis] / 2;
      return x != y ? x < y : a < b;
    });
#pragma omp task shared(boxes) if (end - begin > TaskSize)
  this->Build(boxes, begin, middle, node + 1);
  this->Build(boxes, middle, end, node + 1 + NumberOfNodes(middle - begin));
#pragma omp taskwait
}
} // namespace insideout
