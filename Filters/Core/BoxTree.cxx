// SPDX-License-Identifier: GPL-3.0-or-later
#include "BoxTree.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
constexpr Id LeafSize = 4;

int LongestAxis(const Box& box)
{
  int axis = 0;
  for (int k = 1; k < 3; ++k)
  {
    if (box.High[k] - box.Low[k] > box.High[axis] - box.Low[axis])
    {
      axis = k;
    }
  }
  return axis;
}
} // namespace

void Box::Add(const Box& other)
{
  for (int k = 0; k < 3; ++k)
  {
    this->Low[k] = std::min(this->Low[k], other.Low[k]);
    this->High[k] = std::max(this->High[k], other.High[k]);
  }
}

Box BoundingBox(const std::vector<Point>& points, const Triangle& triangle)
{
  Box box{ points[triangle[0]], points[triangle[0]] };
  box.Add({ points[triangle[1]], points[triangle[1]] });
  box.Add({ points[triangle[2]], points[triangle[2]] });
  return box;
}

BoxTree::BoxTree(std::vector<Box> boxes)
  : Boxes(std::move(boxes))
  , Order(this->Boxes.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  if (!this->Boxes.empty())
  {
    this->Build(0, static_cast<Id>(this->Boxes.size()));
  }
}

void BoxTree::Build(Id begin, Id end)
{
  Box bounds = this->Boxes[this->Order[begin]];
  for (Id k = begin + 1; k < end; ++k)
  {
    bounds.Add(this->Boxes[this->Order[k]]);
  }
  const std::size_t node = this->Nodes.size();
  if (end - begin <= LeafSize)
  {
    this->Nodes.push_back({ bounds, begin, end, node + 1 });
    return;
  }
  this->Nodes.push_back({ bounds, begin, begin, 0 });
  const int axis = LongestAxis(bounds);
  const Id middle = begin + (end - begin) / 2;
  const auto first = this->Order.begin();
  std::nth_element(first + begin, first + middle, first + end,
    [&](Id a, Id b)
    {
      const double x = this->Boxes[a].Low[axis] / 2 + this->Boxes[a].High[axis] / 2;
      const double y = this->Boxes[b].Low[axis] / 2 + this->Boxes[b].High[axis] / 2;
      return x != y ? x < y : a < b;
    });
  this->Build(begin, middle);
  this->Build(middle, end);
  this->Nodes[node].Next = this->Nodes.size();
}
} // namespace insideout
