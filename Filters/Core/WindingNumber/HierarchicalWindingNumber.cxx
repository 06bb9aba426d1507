// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/HierarchicalWindingNumber.h"

#include "Common/Vectors.h"
#include "WindingNumber/SolidAngle.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace insideout
{
namespace
{
constexpr Id LeafSize = 16;

bool IsBefore(const CountedEdge& a, const CountedEdge& b)
{
  return std::tie(a.From, a.To) < std::tie(b.From, b.To);
}

/** Sum the counts of equal edges in a sorted list, and leave out those that cancel. */
std::vector<CountedEdge> Summed(const std::vector<CountedEdge>& sorted)
{
  std::vector<CountedEdge> sum;
  for (const CountedEdge& edge : sorted)
  {
    if (!sum.empty() && sum.back().From == edge.From && sum.back().To == edge.To)
    {
      sum.back().Count += edge.Count;
      continue;
    }
    if (!sum.empty() && sum.back().Count == 0)
    {
      sum.pop_back();
    }
    sum.push_back(edge);
  }
  if (!sum.empty() && sum.back().Count == 0)
  {
    sum.pop_back();
  }
  return sum;
}

std::vector<CountedEdge> BoundaryOf(const CountedTriangle* first, const CountedTriangle* last)
{
  std::vector<CountedEdge> edges;
  for (const CountedTriangle* t = first; t != last; ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id from = t->Corners[k];
      const Id to = t->Corners[(k + 1) % 3];
      edges.push_back({ std::min(from, to), std::max(from, to), from < to ? t->Count : -t->Count });
    }
  }
  std::sort(edges.begin(), edges.end(), IsBefore);
  return Summed(edges);
}
} // namespace

HierarchicalWindingNumber::HierarchicalWindingNumber(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
  : Points(points)
  , Tree(points, triangles, LeafSize)
  , Fans(this->Tree.Nodes.size())
{
  if (!this->Tree.Nodes.empty())
  {
    this->CloseNodes(0);
  }
}

/** Close a node and its descendants with fans; returns the node's boundary. */
std::vector<CountedEdge> HierarchicalWindingNumber::CloseNodes(std::size_t index)
{
  const FacetTree::Node& node = this->Tree.Nodes[index];
  std::vector<CountedEdge> boundary;
  if (node.IsLeaf())
  {
    const CountedTriangle* triangles = this->Tree.Triangles.data();
    boundary = BoundaryOf(triangles + node.Begin, triangles + node.End);
  }
  else
  {
    const std::vector<CountedEdge> left = this->CloseNodes(index + 1);
    const std::vector<CountedEdge> right = this->CloseNodes(node.Right);
    std::merge(
      left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(boundary), IsBefore);
    boundary = Summed(boundary);
  }
  this->CloseNode(index, boundary);
  return boundary;
}

void HierarchicalWindingNumber::CloseNode(
  std::size_t index, const std::vector<CountedEdge>& boundary)
{
  const FacetTree::Node& node = this->Tree.Nodes[index];
  Fan fan;
  const Id apex = boundary.empty() ? None : boundary.front().From;
  for (const CountedEdge& edge : boundary)
  {
    if (edge.From != apex && edge.To != apex)
    {
      fan.Triangles.push_back({ { { apex, edge.From, edge.To } }, static_cast<int>(edge.Count) });
    }
  }
  fan.Replaces = fan.Triangles.size() < static_cast<std::size_t>(node.End - node.Begin);
  if (fan.Replaces)
  {
    this->Fans[index] = std::move(fan);
  }
}

double HierarchicalWindingNumber::SumOf(
  const CountedTriangle* first, const CountedTriangle* last, const Point& p) const
{
  double sum = 0;
  for (const CountedTriangle* t = first; t != last; ++t)
  {
    sum += t->Count * WindingNumberOfTriangle(CornersOf(this->Points, t->Corners), p);
  }
  return sum;
}

double HierarchicalWindingNumber::At(const Point& p) const
{
  double w = 0;
  std::vector<std::size_t> stack;
  if (!this->Tree.Nodes.empty())
  {
    stack.push_back(0);
  }
  while (!stack.empty())
  {
    const std::size_t index = stack.back();
    stack.pop_back();
    const FacetTree::Node& node = this->Tree.Nodes[index];
    const Fan& fan = this->Fans[index];
    if (fan.Replaces && !node.Bounds.Holds(p))
    {
      w += this->SumOf(fan.Triangles.data(), fan.Triangles.data() + fan.Triangles.size(), p);
    }
    else if (node.IsLeaf())
    {
      const CountedTriangle* triangles = this->Tree.Triangles.data();
      w += this->SumOf(triangles + node.Begin, triangles + node.End, p);
    }
    else
    {
      stack.push_back(node.Right);
      stack.push_back(index + 1);
    }
  }
  return w;
}
} // namespace insideout
