// SPDX-License-Identifier: GPL-3.0-or-later
#include "Rounding/MoveCorners.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Resolve/MeetBeyondSharedCorners.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
std::vector<Box> WidenedBoxes(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, double reach)
{
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
  {
    boxes.push_back(BoundingBox(points, triangle).Widened(reach));
  }
  return boxes;
}

bool Has(const Triangle& triangle, Id point)
{
  return std::find(triangle.begin(), triangle.end(), point) != triangle.end();
}

/** The float `steps` floats after x: -1, 0 or 1. */
double Neighbor(double x, int steps)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto single = static_cast<float>(x);
  return steps == 0 ? x : double(std::nextafter(single, steps > 0 ? infinity : -infinity));
}
} // namespace

MoveCorners::MoveCorners(std::vector<Point> points, std::vector<Triangle> triangles, double reach)
  : Places(std::move(points))
  , Corners(std::move(triangles))
  , Begin(this->Places)
  , Reach(reach)
  , Alive(this->Corners.size(), 1)
  , Into(this->Places.size())
  , AtPoint(this->Places.size())
  , Taken(this->Places.begin(), this->Places.end())
  , Tree(WidenedBoxes(this->Places, this->Corners, reach))
{
  for (Id p = 0; p < static_cast<Id>(this->Into.size()); ++p)
  {
    this->Into[p] = p;
  }
  for (Id t = 0; t < static_cast<Id>(this->Corners.size()); ++t)
  {
    for (const Id p : this->Corners[t])
    {
      this->AtPoint[p].push_back(t);
    }
  }
}

Id MoveCorners::CornerOf(Id point) const
{
  while (this->Into[point] != point)
  {
    point = this->Into[point];
  }
  return point;
}

std::vector<Id> MoveCorners::StarOf(Id point) const
{
  std::vector<Id> star;
  std::copy_if(this->AtPoint[point].begin(), this->AtPoint[point].end(), std::back_inserter(star),
    [this](Id t) { return this->IsThere(t); });
  return star;
}

std::vector<Id> MoveCorners::Neighbors(Id point) const
{
  std::vector<Id> neighbors;
  for (const Id t : this->StarOf(point))
  {
    std::copy_if(this->Corners[t].begin(), this->Corners[t].end(), std::back_inserter(neighbors),
      [point](Id p) { return p != point; });
  }
  SortUniquely(neighbors);
  return neighbors;
}

bool MoveCorners::CanTake(Id point, const Point& place) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(std::abs(place[axis] - this->Begin[point][axis]) <= this->Reach))
    {
      return false;
    }
  }
  return true;
}

bool MoveCorners::AnyDegenerate(const std::vector<Id>& star) const
{
  return std::any_of(star.begin(), star.end(),
    [this](Id t) { return IsDegenerate(this->Places, this->Corners[t]); });
}

bool MoveCorners::MeetsAnother(Id triangle, Id other) const
{
  const SortedTriangle a(this->Corners[triangle]);
  const SortedTriangle b(this->Corners[other]);
  return a.Points == b.Points ||
    MeetBeyondSharedCorners(this->Places, this->Corners[triangle], this->Corners[other]);
}

/** The pairs of triangles that meet, at least one of them in the star. None is degenerate. */
int MoveCorners::CrossingsAround(const std::vector<Id>& star) const
{
  int crossings = 0;
  for (const Id t : star)
  {
    this->Tree.Visit(BoundingBox(this->Places, this->Corners[t]),
      [&](Id other)
      {
        const bool isCounted = !this->IsThere(other) || other == t ||
          (other < t && std::find(star.begin(), star.end(), other) != star.end());
        crossings += !isCounted && this->MeetsAnother(t, other);
      });
  }
  return crossings;
}

/** Whether the edge's points have no common neighbors except across its triangles. */
bool MoveCorners::IsLinkSound(Id gone, Id kept, std::vector<Id>& between) const
{
  std::vector<Id> across;
  for (const Id t : this->StarOf(gone))
  {
    if (Has(this->Corners[t], kept))
    {
      between.push_back(t);
      for (const Id p : this->Corners[t])
      {
        if (p != gone && p != kept)
        {
          across.push_back(p);
        }
      }
    }
  }
  SortUniquely(across);
  const std::vector<Id> a = this->Neighbors(gone);
  const std::vector<Id> b = this->Neighbors(kept);
  std::vector<Id> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return !between.empty() && across.size() == between.size() && common == across;
}

bool MoveCorners::Contract(Id gone, Id kept)
{
  std::vector<Id> between;
  if (gone == kept || !this->CanTake(gone, this->Places[kept]) ||
    !this->IsLinkSound(gone, kept, between))
  {
    return false;
  }
  const std::vector<Id> star = this->StarOf(gone);
  const int before = this->CrossingsAround(star);
  std::vector<Id> moved;
  for (const Id t : star)
  {
    if (Has(this->Corners[t], kept))
    {
      this->Alive[t] = 0;
    }
    else
    {
      std::replace(this->Corners[t].begin(), this->Corners[t].end(), gone, kept);
      moved.push_back(t);
    }
  }
  if (this->AnyDegenerate(moved) || this->CrossingsAround(moved) > before)
  {
    for (const Id t : moved)
    {
      std::replace(this->Corners[t].begin(), this->Corners[t].end(), kept, gone);
    }
    for (const Id t : between)
    {
      this->Alive[t] = 1;
    }
    return false;
  }
  this->AtPoint[kept].insert(this->AtPoint[kept].end(), moved.begin(), moved.end());
  this->AtPoint[gone].clear();
  this->Into[gone] = kept;
  this->Taken.erase(this->Places[gone]);
  return true;
}

bool MoveCorners::MoveToNeighbor(Id point)
{
  const std::vector<Id> star = this->StarOf(point);
  const Point here = this->Places[point];
  Point best = here;
  int fewest = this->CrossingsAround(star);
  for (int step = 0; step < 27 && fewest > 0; ++step)
  {
    const Point place = { Neighbor(here[0], step % 3 - 1), Neighbor(here[1], step / 3 % 3 - 1),
      Neighbor(here[2], step / 9 - 1) };
    if (this->CanTake(point, place) && this->Taken.count(place) == 0)
    {
      this->Places[point] = place;
      const int crossings = this->AnyDegenerate(star) ? fewest : this->CrossingsAround(star);
      if (crossings < fewest)
      {
        fewest = crossings;
        best = place;
      }
    }
  }
  this->Places[point] = best;
  this->Taken.erase(here);
  this->Taken.insert(best);
  return best != here;
}
} // namespace insideout
