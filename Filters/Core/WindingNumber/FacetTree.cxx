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
    const int axis = this->BoxOfCentres(begin, end).LongestAxis();
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
    FacetTree::Node node = { Box::Empty(), begin, end, None };
    for (Id i = begin; i < end; ++i)
    {
      node.Bounds.Add(BoundingBox(this->Points, this->Items[i].Triangle.Corners));
    }
    return node;
  }

  Box BoxOfCentres(Id begin, Id end) const
  {
    Box box = Box::Empty();
    for (Id i = begin; i < end; ++i)
    {
      box.Add(this->Items[i].Centre);
    }
    return box;
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
