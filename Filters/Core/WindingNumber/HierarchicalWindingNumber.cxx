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
bool IsBefore(const CountedEdge& a, const CountedEdge& b)
{
  return std::tie(a.From, a.To) < std::tie(b.From, b.To);
}

/** Sum the counts of equal edges in a sorted list, and leave out those that cancel. */
void SumUp(std::vector<CountedEdge>& sorted)
{
  auto end = sorted.begin();
  for (auto edge = sorted.begin(); edge != sorted.end();)
  {
    CountedEdge sum = *edge++;
    for (; edge != sorted.end() && edge->From == sum.From && edge->To == sum.To; ++edge)
    {
      sum.Count += edge->Count;
    }
    if (sum.Count != 0)
    {
      *end++ = sum;
    }
  }
  sorted.erase(end, sorted.end());
}
} // namespace

HierarchicalWindingNumber::HierarchicalWindingNumber(
  const std::vector<Point>& points, std::vector<CountedTriangle> triangles)
  : Points(points)
  , Triangles(std::move(triangles))
  , Tree(BoxTree::OfPoints(CentresOf(points, this->Triangles)))
  , Fans(static_cast<std::size_t>(this->Tree.NumberOfParts()))
{
  std::vector<Part> open; // those whose parent is still to come; the last one is its first child
  for (Id number = this->Tree.NumberOfParts(); number-- > 0;)
  {
    Part part;
    if (this->Tree.IsLeaf(number))
    {
      part = this->LeafOf(number);
    }
    else
    {
      const Part first = std::move(open.back());
      open.pop_back();
      const Part second = std::move(open.back());
      open.pop_back();
      part.Around = first.Around;
      part.Around.Add(second.Around);
      part.Size = first.Size + second.Size;
      part.Boundary.resize(first.Boundary.size() + second.Boundary.size());
      std::merge(first.Boundary.begin(), first.Boundary.end(), second.Boundary.begin(),
        second.Boundary.end(), part.Boundary.begin(), IsBefore);
      SumUp(part.Boundary);
    }
    this->Fans[number] = Close(part);
    open.push_back(std::move(part));
  }
}

HierarchicalWindingNumber::Part HierarchicalWindingNumber::LeafOf(Id number) const
{
  Part part;
  const auto add = [&](Id i)
  {
    const auto& [corners, count] = this->Triangles[i];
    part.Around.Add(BoundingBox(this->Points, corners));
    ++part.Size;
    for (int k = 0; k < 3; ++k)
    {
      const Id from = corners[k];
      const Id to = corners[(k + 1) % 3];
      part.Boundary.push_back(
        { std::min(from, to), std::max(from, to), from < to ? count : -count });
    }
  };
  this->Tree.VisitPart(number, add);
  std::sort(part.Boundary.begin(), part.Boundary.end(), IsBefore);
  SumUp(part.Boundary);
  return part;
}

HierarchicalWindingNumber::Fan HierarchicalWindingNumber::Close(const Part& part)
{
  std::vector<CountedTriangle> fan;
  const Id apex = part.Boundary.empty() ? None : part.Boundary.front().From;
  for (const CountedEdge& edge : part.Boundary)
  {
    if (edge.From != apex && edge.To != apex)
    {
      fan.push_back({ { { apex, edge.From, edge.To } }, static_cast<int>(edge.Count) });
    }
  }
  if (fan.size() >= part.Size)
  {
    return { part.Around, false, {} };
  }
  return { part.Around, true, std::move(fan) };
}

double HierarchicalWindingNumber::WindingNumberOf(
  const CountedTriangle& triangle, const Point& p) const
{
  return triangle.Count * WindingNumberOfTriangle(CornersOf(this->Points, triangle.Corners), p);
}

double HierarchicalWindingNumber::At(const Point& p) const
{
  double w = 0;
  this->Tree.VisitOpened(
    [&](Id part)
    {
      const Fan& fan = this->Fans[part];
      const bool isReplaced = fan.Replaces && !fan.Around.Holds(p);
      for (std::size_t i = 0; isReplaced && i < fan.Triangles.size(); ++i)
      {
        w += this->WindingNumberOf(fan.Triangles[i], p);
      }
      return !isReplaced;
    },
    [&](Id i) { w += this->WindingNumberOf(this->Triangles[i], p); });
  return w;
}
} // namespace insideout
