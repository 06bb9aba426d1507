// SPDX-License-Identifier: GPL-3.0-or-later
#include "SteinerPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace insideout
{
namespace
{
/** Places on a segment are tried with so many binary digits. */
constexpr int MostDigits = 52;

template <typename Container>
void SortUnique(Container& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}
} // namespace

bool SteinerPoints::IsInMesh(Id point) const
{
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  return !star.empty();
}

SteinerPoints::Support SteinerPoints::SupportOf(Id point) const
{
  Support support = { None, {} };
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  for (const Id id : star)
  {
    const FlippableCell& cell = this->Mesh.Cells[id];
    for (int k = 0; k < 4; ++k)
    {
      if (cell.Corners[k] == point)
      {
        continue;
      }
      if (cell.Facets[k] != None)
      {
        support.Facets.push_back(cell.Facets[k]);
      }
      if (support.Segment == None)
      {
        support.Segment = this->Segments.Find(point, cell.Corners[k]);
      }
    }
  }
  SortUnique(support.Facets);
  return support;
}

std::vector<Id> SteinerPoints::FacetsAt(Id point) const
{
  return this->SupportOf(point).Facets;
}

// --- Removing ------------------------------------------------------------------------------------

/** Take away edges at a point that carry no constraint. */
void SteinerPoints::LowerDegree(Id point)
{
  const FlipTarget nothing(this->Mesh);
  const FlipOperator::Limits limits = { 0, 10 };
  bool changed = true;
  while (changed)
  {
    changed = false;
    std::vector<Id> star;
    this->Mesh.Star(point, star);
    std::vector<Id> neighbors;
    for (const Id cell : star)
    {
      for (const Id corner : this->Mesh.Cells[cell].Corners)
      {
        if (corner != point && corner != this->Mesh.Infinite())
        {
          neighbors.push_back(corner);
        }
      }
    }
    SortUnique(neighbors);
    for (const Id neighbor : neighbors)
    {
      const Id cell = this->Mesh.FindEdge(point, neighbor);
      changed =
        (cell != None && this->Flips.RemoveEdge(point, neighbor, cell, nothing, limits)) || changed;
    }
  }
}

bool SteinerPoints::RemoveOne(Id point)
{
  if (this->Dissolver.Dissolve(point, VolumePoints::None))
  {
    return true;
  }
  this->LowerDegree(point);
  return this->Dissolver.Dissolve(point, VolumePoints::None);
}

void SteinerPoints::Remove()
{
  bool changed = true;
  while (changed)
  {
    changed = false;
    for (Id point = this->Mesh.Vertices.Size() - 1; point > this->Mesh.Infinite(); --point)
    {
      this->Progress.Check("removing points", 0);
      changed = (this->IsInMesh(point) && this->RemoveOne(point)) || changed;
    }
  }
}

void SteinerPoints::MoveIntoVolume()
{
  for (Id point = this->Mesh.Vertices.Size() - 1; point > this->Mesh.Infinite(); --point)
  {
    this->Progress.Check("moving points", 0);
    if (this->IsInMesh(point))
    {
      this->Dissolver.Dissolve(point, VolumePoints::AsNeeded);
    }
  }
}

// --- Rounding ------------------------------------------------------------------------------------

/** Move the point to `place` if every cell around it is positive there and the hull convex. */
bool SteinerPoints::IsValidAt(Id point, const std::vector<Id>& star, const Point& place)
{
  ExactVertices& vertices = this->Mesh.Vertices;
  const ExactVertices::Place before = vertices.PlaceOf(point);
  vertices.MoveTo(point, place);
  bool valid = true;
  for (std::size_t k = 0; valid && k < star.size(); ++k)
  {
    const FlippableCell& cell = this->Mesh.Cells[star[k]];
    Tetrahedron t = cell.Corners;
    const int infinite = this->Mesh.CornerIndex(star[k], this->Mesh.Infinite());
    if (infinite < 0)
    {
      valid = vertices.Orient(t[0], t[1], t[2], t[3]) > 0;
      continue;
    }
    // The hull is convex where it is so at each edge.
    for (int j = 0; valid && j < 4; ++j)
    {
      if (j != infinite)
      {
        t[infinite] = this->Mesh.Opposite(star[k], j);
        valid = vertices.Orient(t[0], t[1], t[2], t[3]) <= 0;
      }
    }
  }
  if (!valid)
  {
    vertices.MoveTo(point, before);
  }
  return valid;
}

/** Try places on the segment, those first that fewer binary digits say. */
bool SteinerPoints::RoundOnSegment(Id point, Id segment, const std::vector<Id>& star, bool exactly)
{
  const std::array<Id, 2>& ends = this->Segments.EndsOf(segment);
  const Point a = this->Mesh.Vertices.Nearest(ends[0]);
  const Point b = this->Mesh.Vertices.Nearest(ends[1]);
  const Point now = this->Mesh.Vertices.Nearest(point);
  int axis = 0;
  for (int k = 1; k < 3; ++k)
  {
    axis = std::abs(b[k] - a[k]) > std::abs(b[axis] - a[axis]) ? k : axis;
  }
  const double place = (now[axis] - a[axis]) / (b[axis] - a[axis]);
  double last = -1;
  for (int digits = 1; digits <= MostDigits; ++digits)
  {
    const double t = std::ldexp(std::nearbyint(std::ldexp(place, digits)), -digits);
    if (!(t > 0 && t < 1) || t == last)
    {
      continue;
    }
    last = t;
    Point candidate;
    bool isExact = true;
    for (int k = 0; k < 3; ++k)
    {
      candidate[k] = a[k] + t * (b[k] - a[k]);
      isExact = isExact &&
        DyadicNumber(candidate[k]) ==
          DyadicNumber(a[k]) + DyadicNumber(t) * (DyadicNumber(b[k]) - DyadicNumber(a[k]));
    }
    if ((isExact || !exactly) && this->IsValidAt(point, star, candidate))
    {
      return true;
    }
  }
  return false;
}

bool SteinerPoints::RoundOne(Id point)
{
  std::vector<Id> star;
  this->Mesh.Star(point, star);
  const Id segment = this->SupportOf(point).Segment;
  if (segment != None && this->RoundOnSegment(point, segment, star, true))
  {
    return true;
  }
  const Point nearest = this->Mesh.Vertices.Nearest(point);
  if (this->IsValidAt(point, star, nearest) ||
    (segment != None && this->RoundOnSegment(point, segment, star, false)))
  {
    return true;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 27; ++k)
  {
    const std::array<int, 3> steps = { { k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1 } };
    Point candidate = nearest;
    for (int axis = 0; axis < 3; ++axis)
    {
      if (steps[axis] != 0)
      {
        candidate[axis] = std::nextafter(candidate[axis], steps[axis] * infinity);
      }
    }
    if (this->IsValidAt(point, star, candidate))
    {
      return true;
    }
  }
  return false;
}

std::vector<Id> SteinerPoints::Round()
{
  std::vector<Id> left;
  for (Id point = this->Mesh.Infinite() + 1; point < this->Mesh.Vertices.Size(); ++point)
  {
    this->Progress.Check("rounding points", 0);
    if (this->IsInMesh(point) && !this->Mesh.Vertices.IsDouble(point) && !this->RoundOne(point))
    {
      left.push_back(point);
    }
  }
  return left;
}
} // namespace insideout
