// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/OrientedBoxTree.h"

#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace insideout
{
namespace
{
/** Limit of facets in a leaf; for speed only: 2 to 6 take equally long. */
constexpr std::size_t LeafSize = 4;

/** Cost of a level of the tree, per facet. */
constexpr double NanosecondsPerFacet = 80;

/** Limit of the difference between the scalar products of axes and those of orthonormal ones. */
constexpr double AxesError = 16 * std::numeric_limits<double>::epsilon();

/**
 * Bound of all errors in AreApart, relative to the coordinates: far above AxesError and the
 * rounding errors; and the limit of underflow.
 */
constexpr double RelativeError = 256 * AxesError;
constexpr double Underflow = 256 * std::numeric_limits<double>::min();

using Axes = std::array<Point, 3>;

Point Unit(const Point& a)
{
  const double length = Length(a);
  return { a[0] / length, a[1] / length, a[2] / length };
}

/** The component of a vector across a unit vector. */
Point Across(const Point& unit, const Point& a)
{
  const double along = Dot(unit, a);
  return { a[0] - along * unit[0], a[1] - along * unit[1], a[2] - along * unit[2] };
}

/** The first image of a corner that is longest. */
template <class Image>
Point Longest(const std::vector<Point>& corners, const Image& image)
{
  Point longest{};
  for (const Point& corner : corners)
  {
    const Point own = image(corner);
    if (Dot(own, own) > Dot(longest, longest))
    {
      longest = own;
    }
  }
  return longest;
}

/** False for NaN. */
bool AreOrthonormal(const Axes& axes)
{
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k <= i; ++k)
    {
      if (!(std::abs(Dot(axes[i], axes[k]) - (i == k)) <= AxesError))
      {
        return false;
      }
    }
  }
  return true;
}

/**
 * Axes from the origin toward the corner farthest from it, and toward the one farthest from that
 * line; those of the coordinates if rounding prevents this.
 */
Axes AxesFor(const std::vector<Point>& corners)
{
  const Point along = Unit(Longest(corners, [](const Point& x) { return x; }));
  const Point across = Unit(Longest(corners, [&](const Point& x) { return Across(along, x); }));
  const Point second = Unit(Across(along, across)); // repeated, because the first has cancelled
  const Axes axes = { along, second, Cross(along, second) };
  return AreOrthonormal(axes) ? axes : Axes{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
}

Point Along(const Axes& axes, const Point& x)
{
  return { Dot(axes[0], x), Dot(axes[1], x), Dot(axes[2], x) };
}

/** Boxes of triangles along axes. @param[in] corners three per triangle */
std::vector<Box> BoxesAlong(const Axes& axes, const std::vector<Point>& corners)
{
  std::vector<Box> boxes(corners.size() / 3, Box::Empty());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    boxes[i / 3].Add(Along(axes, corners[i]));
  }
  return boxes;
}

/** The box along axes of all corners but one. @param[in] ids of the corners */
Box BaseAlong(
  const Axes& axes, const std::vector<Point>& corners, const std::vector<Id>& ids, Id tip)
{
  Box base = Box::Empty();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (ids[i] != tip)
    {
      base.Add(Along(axes, corners[i]));
    }
  }
  return base;
}

OrientedBox MakeOrientedBox(
  const Point& origin, const Axes& axes, const Box& along, const Box& bounds)
{
  OrientedBox box{ origin, axes, {}, Underflow };
  for (int i = 0; i < 3; ++i)
  {
    box.Half[i] = along.High[i] / 2 - along.Low[i] / 2;
    const double middle = along.High[i] / 2 + along.Low[i] / 2;
    for (int k = 0; k < 3; ++k)
    {
      box.Center[k] += middle * axes[i][k];
    }
    box.Error += RelativeError * (std::abs(bounds.Low[i]) + std::abs(bounds.High[i]));
  }
  return box;
}

/** A corner of all facets, None if there is none. @param[in] ids of the corners, three per facet */
Id CommonCorner(const std::vector<Id>& ids)
{
  const auto isCommon = [&](Id id)
  { return 3 * static_cast<std::size_t>(std::count(ids.begin(), ids.end(), id)) == ids.size(); };
  const auto found = std::find_if(ids.begin(), ids.begin() + 3, isCommon);
  return found == ids.begin() + 3 ? None : *found;
}

Point CenterOf(const Box& box)
{
  return Midpoint(box.Low, box.High);
}

/**
 * The axis on which the centers of boxes extend farthest, as a multiple of the mean extent of the
 * boxes: halves along it have the least in common.
 */
int AxisOfLeastOverlap(const std::vector<Box>& boxes)
{
  Box centers = Box::Empty();
  Point sum{};
  for (const Box& box : boxes)
  {
    centers.Add(CenterOf(box));
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += box.Extent(axis);
    }
  }
  int best = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    best = centers.Extent(axis) * sum[best] > centers.Extent(best) * sum[axis] ? axis : best;
  }
  return best;
}

/** Reorder facets: the lower half first, by the centers of their boxes. */
void Halve(Id* facets, const std::vector<Box>& boxes)
{
  const int axis = AxisOfLeastOverlap(boxes);
  std::vector<std::pair<double, Id>> places;
  places.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const double place = CenterOf(boxes[i])[axis];
    places.emplace_back(std::isnan(place) ? 0 : place, facets[i]); // after overflow
  }
  std::nth_element(places.begin(), places.begin() + places.size() / 2, places.end());
  std::transform(
    places.begin(), places.end(), facets, [](const auto& place) { return place.second; });
}
} // namespace

bool AreApart(const OrientedBox& a, const OrientedBox& b)
{
  const double error = a.Error + b.Error;
  const Point between = Difference(b.Center, a.Center);
  Point along; // the axes of a
  Axes cosines;
  Axes sizes; // of the cosines
  for (int i = 0; i < 3; ++i)
  {
    along[i] = Dot(a.Axes[i], between);
    for (int k = 0; k < 3; ++k)
    {
      cosines[i][k] = Dot(a.Axes[i], b.Axes[k]);
      sizes[i][k] = std::abs(cosines[i][k]);
    }
    if (std::abs(along[i]) > a.Half[i] + Dot(b.Half, sizes[i]) + error)
    {
      return true;
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    const Point toA = { cosines[0][k], cosines[1][k], cosines[2][k] };
    const Point size = { sizes[0][k], sizes[1][k], sizes[2][k] };
    if (std::abs(Dot(along, toA)) > b.Half[k] + Dot(a.Half, size) + error)
    {
      return true;
    }
  }
  return std::abs(along[2] * cosines[1][0] - along[1] * cosines[2][0]) > a.Half[1] * sizes[2][0] +
    a.Half[2] * sizes[1][0] + b.Half[1] * sizes[0][2] + b.Half[2] * sizes[0][1] + error;
}

bool AreApartSeenFrom(const Point& tip, const OrientedBox& a, const OrientedBox& b)
{
  const Point toA = Difference(a.Center, tip);
  const Point toB = Difference(b.Center, tip);
  const Point across = Unit(Difference(Unit(toA), Unit(toB))); // the plane halves the angle
  double heightOfA = Dot(across, toA);
  double heightOfB = -Dot(across, toB);
  for (int i = 0; i < 3; ++i)
  {
    heightOfA -= a.Half[i] * std::abs(Dot(across, a.Axes[i]));
    heightOfB -= b.Half[i] * std::abs(Dot(across, b.Axes[i]));
  }
  return std::min(heightOfA, heightOfB) > a.Error + b.Error;
}

OrientedBoxTree::OrientedBoxTree(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf)
  : Points(points)
  , Order(facets.size())
  , Boxes(facets.size())
  , Sets(facets.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::size_t leaves = 1;
  while (leaves * LeafSize < facets.size())
  {
    leaves *= 2;
  }
  this->FirstLeaf = leaves - 1;
  this->Nodes.resize(2 * leaves - 1);
  this->Nodes[0].Begin = 0;
  this->Nodes[0].End = static_cast<Id>(facets.size());
  for (std::size_t level = 1; level <= leaves; level *= 2)
  {
    ParallelLoop(level, NanosecondsPerFacet * static_cast<double>(facets.size() / level),
      [&](std::size_t i) { this->Build(facets, setOf, level - 1 + i); });
  }
}

/** Make a node whose facets are known, and pass these on to its children. */
void OrientedBoxTree::Build(
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf, std::size_t number)
{
  Node& node = this->Nodes[number];
  const Point origin = this->Points[facets[this->Order[node.Begin]][0]]; // for exact differences
  std::vector<Point> corners;
  std::vector<Id> ids;
  node.Bounds = Box::Empty();
  node.Set = setOf[this->Order[node.Begin]];
  for (Id i = node.Begin; i < node.End; ++i)
  {
    const Id facet = this->Order[i];
    node.Set = setOf[facet] == node.Set ? node.Set : None;
    for (const Id p : facets[facet])
    {
      node.Bounds.Add(this->Points[p]);
      corners.push_back(Difference(this->Points[p], origin));
      ids.push_back(p);
    }
  }
  const Axes axes = AxesFor(corners);
  const std::vector<Box> along = BoxesAlong(axes, corners);
  Box whole = Box::Empty();
  for (const Box& box : along)
  {
    whole.Add(box);
  }
  node.Own = MakeOrientedBox(origin, axes, whole, node.Bounds);
  node.Tip = CommonCorner(ids);
  if (node.Tip != None)
  {
    const Box base = BaseAlong(axes, corners, ids, node.Tip);
    node.Base = MakeOrientedBox(origin, axes, base, node.Bounds);
  }
  node.Size = *std::max_element(node.Own.Half.begin(), node.Own.Half.end());
  if (this->IsLeaf(number))
  {
    for (Id i = node.Begin; i < node.End; ++i)
    {
      this->Boxes[i] = BoundingBox(this->Points, facets[this->Order[i]]);
      this->Sets[i] = setOf[this->Order[i]];
    }
    return;
  }
  Halve(&this->Order[node.Begin], along);
  const Id middle = node.Begin + (node.End - node.Begin) / 2;
  Node* const halves = &this->Nodes[2 * number + 1];
  halves[0].Begin = node.Begin;
  halves[0].End = halves[1].Begin = middle;
  halves[1].End = node.End;
}

bool OrientedBoxTree::MayMeet(const Task& task) const
{
  const Node& a = this->Nodes[task[0]];
  const Node& b = this->Nodes[task[1]];
  if (a.Set != None && a.Set == b.Set)
  {
    return false;
  }
  if (task[0] == task[1])
  {
    return true;
  }
  const bool haveOneTip = a.Tip != None && a.Tip == b.Tip;
  return a.Bounds.Meets(b.Bounds) && !AreApart(a.Own, b.Own) &&
    !(haveOneTip && AreApartSeenFrom(this->Points[a.Tip], a.Base, b.Base));
}

/** Divide a task that is not one of leaves: the larger node first. */
void OrientedBoxTree::Divide(const Task& task, std::vector<Task>& parts) const
{
  const auto [a, b] = task;
  if (a == b)
  {
    parts.insert(parts.end(),
      { { 2 * a + 1, 2 * a + 1 }, { 2 * a + 2, 2 * a + 2 }, { 2 * a + 1, 2 * a + 2 } });
    return;
  }
  const bool first =
    this->IsLeaf(b) || (!this->IsLeaf(a) && this->Nodes[a].Size >= this->Nodes[b].Size);
  const std::size_t half = 2 * (first ? a : b) + 1;
  const std::size_t other = first ? b : a;
  parts.insert(parts.end(), { { half, other }, { half + 1, other } });
}

std::vector<OrientedBoxTree::Task> OrientedBoxTree::Tasks(std::size_t number) const
{
  std::vector<Task> tasks = { { 0, 0 } };
  for (bool divides = true; divides && tasks.size() < number;)
  {
    divides = false;
    std::vector<Task> parts;
    for (const Task& task : tasks)
    {
      if (this->IsLeaf(task[0]) && this->IsLeaf(task[1]))
      {
        parts.push_back(task);
      }
      else if (this->MayMeet(task))
      {
        this->Divide(task, parts);
        divides = true;
      }
    }
    tasks.swap(parts);
  }
  return tasks;
}
} // namespace insideout
