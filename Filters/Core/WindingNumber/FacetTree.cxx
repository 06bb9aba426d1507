// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/FacetTree.h"

#include <algorithm>

namespace insideout
{
namespace
{
struct Item
{
  Point Centre;
  CountedTriangle Triangle;
};

class Builder
{
public:
  Builder(const std::vector<Point>& points, std::vector<Item>& items, Id leafSize,
    std::vector<FacetTree::Node>& nodes)
    : Points(points)
    , Items(items)
    , LeafSize(leafSize)
    , Nodes(nodes)
  {
  }

  void Build(Id begin, Id end)
  {
    const std::size_t node = this->Nodes.size();
    this->Nodes.push_back(this->MakeNode(begin, end));
    if (end - begin <= this->LeafSize)
    {
      return;
    }
    const int axis = this->LongestAxis(begin, end);
    const Id middle = begin + (end - begin) / 2;
    const auto first = this->Items.begin();
    std::nth_element(first + begin, first + middle, first + end,
      [axis](const Item& a, const Item& b)
      {
        return a.Centre[axis] != b.Centre[axis] ? a.Centre[axis] < b.Centre[axis]
                                                : a.Triangle.Corners < b.Triangle.Corners;
      });
    this->Build(begin, middle);
    this->Nodes[node].Right = static_cast<Id>(this->Nodes.size());
    this->Build(middle, end);
  }

private:
  FacetTree::Node MakeNode(Id begin, Id end) const
  {
    const Point& first = this->Points[this->Items[begin].Triangle.Corners[0]];
    FacetTree::Node node = { first, first, begin, end, None };
    for (Id i = begin; i < end; ++i)
    {
      for (const Id p : this->Items[i].Triangle.Corners)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          node.Low[axis] = std::min(node.Low[axis], this->Points[p][axis]);
          node.High[axis] = std::max(node.High[axis], this->Points[p][axis]);
        }
      }
    }
    return node;
  }

  int LongestAxis(Id begin, Id end) const
  {
    Point low = this->Items[begin].Centre;
    Point high = low;
    for (Id i = begin; i < end; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], this->Items[i].Centre[axis]);
        high[axis] = std::max(high[axis], this->Items[i].Centre[axis]);
      }
    }
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      longest = high[axis] - low[axis] > high[longest] - low[longest] ? axis : longest;
    }
    return longest;
  }

  const std::vector<Point>& Points;
  std::vector<Item>& Items;
  const Id LeafSize;
  std::vector<FacetTree::Node>& Nodes;
};
} // namespace

FacetTree::FacetTree(
  const std::vector<Point>& points, std::vector<CountedTriangle> triangles, Id leafSize)
{
  std::vector<Item> items;
  for (const CountedTriangle& triangle : triangles)
  {
    Point centre;
    for (int axis = 0; axis < 3; ++axis)
    {
      centre[axis] = points[triangle.Corners[0]][axis] / 3 + points[triangle.Corners[1]][axis] / 3 +
        points[triangle.Corners[2]][axis] / 3;
    }
    items.push_back({ centre, triangle });
  }
  if (!items.empty())
  {
    Builder(points, items, leafSize, this->Nodes).Build(0, static_cast<Id>(items.size()));
  }
  for (const Item& item : items)
  {
    this->Triangles.push_back(item.Triangle);
  }
}
} // namespace insideout
