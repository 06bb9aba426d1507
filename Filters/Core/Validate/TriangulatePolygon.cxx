// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/TriangulatePolygon.h"

#include "Common/ScaledPoints.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "Validate/BestLoopTriangles.h"
#include "Validate/EnclosedTriangles.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
// Areas that differ by less than this fraction count as equal: far above rounding, and the
// difference for a polygon with corners 1/30,000 of its size off a plane.
constexpr double SameArea = 1e-9;

// Products of four coordinates between these stay in range.
constexpr double SmallestCoordinate = 1e-60;
constexpr double LargestCoordinateToSearch = 1e60;

// A polygon is not projected along an axis from which it appears smaller than this fraction of its
// largest projection: seen edge-on it is noise.
constexpr double LeastWidth = 1e-3;

// Fans that are tried for long outlines, evenly spread.
constexpr std::size_t MostApexes = 16;

/**
 * A canonical order of a polygon's corners, independent of the start and the direction: of all such
 * orders the lexicographically least by coordinates.
 */
class Outline
{
public:
  Outline(const std::vector<Point>& points, const std::vector<Id>& corners)
    : Points(points)
    , Corners(corners)
    , Size(corners.size())
  {
    const std::size_t forward = this->FirstStart(false);
    this->Start = this->FirstStart(true);
    this->Reversed = true;
    for (std::size_t k = 0; k < this->Size; ++k)
    {
      const Point& ahead = this->At(forward, false, k);
      const Point& back = this->At(this->Start, true, k);
      if (ahead != back)
      {
        this->Reversed = back < ahead;
        break;
      }
    }
    this->Start = this->Reversed ? this->Start : forward;
  }

  Id operator[](std::size_t k) const { return this->Corner(this->Start, this->Reversed, k); }
  std::size_t size() const { return this->Size; }

  /** Add a triangle by its corners' positions in the order, with the polygon's orientation. */
  void Add(std::size_t a, std::size_t b, std::size_t c, std::vector<Triangle>& triangles) const
  {
    const Id second = (*this)[b];
    const Id third = (*this)[c];
    triangles.push_back(
      { { (*this)[a], this->Reversed ? third : second, this->Reversed ? second : third } });
  }

private:
  Id Corner(std::size_t start, bool reversed, std::size_t k) const
  {
    const std::size_t at = reversed ? start + this->Size - k : start + k;
    return this->Corners[at < this->Size ? at : at - this->Size];
  }

  const Point& At(std::size_t start, bool reversed, std::size_t k) const
  {
    return this->Points[this->Corner(start, reversed, k)];
  }

  /** The start of the least rotation; ties do not matter. */
  std::size_t FirstStart(bool reversed) const
  {
    const auto place = [&](std::size_t k) { return k < this->Size ? k : k - this->Size; };
    const auto start = [&](std::size_t k) { return reversed ? this->Size - 1 - k : k; };
    std::size_t i = 0;
    std::size_t j = 1;
    for (std::size_t same = 0; i < this->Size && j < this->Size && same < this->Size;)
    {
      const Point& a = this->Points[this->Corners[start(place(i + same))]];
      const Point& b = this->Points[this->Corners[start(place(j + same))]];
      if (a == b)
      {
        ++same;
        continue;
      }
      // No start from the higher one up to this position can be the least.
      (a < b ? j : i) += same + 1;
      j += i == j;
      same = 0;
    }
    return start(std::min(i, j));
  }

  const std::vector<Point>& Points;
  const std::vector<Id>& Corners;
  const std::size_t Size;
  std::size_t Start;
  bool Reversed;
};

/** The size of an outline's projections along each axis. */
struct Extent
{
  Point Vector;      ///< twice the area, by axes
  Point Terms;       ///< sum of the terms' absolute values
  double Length = 0; ///< length of the vector: no triangulation has less area
  double Sum = 0;    ///< of the terms

  Extent(const Point* corners, std::size_t size)
    : Vector{ { 0, 0, 0 } }
    , Terms{ { 0, 0, 0 } }
  {
    for (std::size_t k = 1; k + 1 < size; ++k)
    {
      const Point normal = NormalOf(corners[0], corners[k], corners[k + 1]);
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Vector[axis] += normal[axis];
        this->Terms[axis] += std::abs(normal[axis]);
      }
    }
    this->Length = insideout::Length(this->Vector);
    this->Sum = this->Terms[0] + this->Terms[1] + this->Terms[2];
  }

  /** Whether the area is only noise, because two halves cancel, as in a figure eight. */
  bool Vanishes() const { return !(this->Length > SameArea * this->Sum); }

  /** The axis with the largest projection; on ties the first. */
  int Axis() const
  {
    const Point& v = this->Vector;
    const double sizes[3] = { std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) };
    return static_cast<int>(std::max_element(sizes, sizes + 3) - sizes);
  }

  /** The axes worth trying, best first. */
  std::vector<int> Axes() const
  {
    const Point& by = this->Vanishes() ? this->Terms : this->Vector;
    const auto seen = [&](int axis) { return std::abs(by[axis]); };
    std::vector<int> axes = { 0, 1, 2 };
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return seen(a) > seen(b); });
    const double least = LeastWidth * seen(axes[0]);
    axes.erase(
      std::remove_if(axes.begin(), axes.end(), [&](int axis) { return seen(axis) < least; }),
      axes.end());
    return axes;
  }

  /** Whether triangles of this area have the least possible area. */
  bool IsLeast(double area) const { return area <= this->Length * (1 + SameArea); }
};

bool IsInRange(double largest)
{
  return largest == 0 || (largest > SmallestCoordinate && largest < LargestCoordinateToSearch);
}

/** Append the found triangles, without those that have two corners at one place. */
bool AddLoop(const Outline& outline, const SmallLoop& loop, const LoopTriangles& found,
  std::vector<Triangle>& triangles)
{
  const Point* at = loop.Corners;
  for (std::size_t k = 0; k + 2 < outline.size(); ++k)
  {
    const auto [a, b, c] = found.Corners[k];
    if (at[a] != at[b] && at[b] != at[c] && at[c] != at[a])
    {
      outline.Add(a, b, c, triangles);
    }
  }
  return true;
}

/**
 * For few corners: triangles that all have the polygon's orientation, seen along the best axis. If
 * they exist, they cover the enclosed region as often as the outline winds around it.
 */
bool AddWithoutOverlap(
  const Outline& outline, const SmallLoop& loop, std::vector<Triangle>& triangles)
{
  const Extent extent(loop.Scaled, outline.size());
  if (extent.Vanishes())
  {
    return false;
  }
  const int axis = extent.Axis();
  const int sign = extent.Vector[axis] > 0 ? 1 : -1;
  const double margin = SameArea * extent.Sum;
  const auto found = FindBestLoopTriangles(loop, axis, sign, margin);
  if (!found)
  {
    return false;
  }
  if (!extent.IsLeast(found->Area))
  {
    const auto least = FindBestLoopTriangles(loop, axis, 0, margin);
    if (least && least->Area < found->Area - margin)
    {
      return AddLoop(outline, loop, *least, triangles);
    }
  }
  return AddLoop(outline, loop, *found, triangles);
}

/** The same without dynamic memory; returns false also if coordinates have to be scaled. */
bool AddSmall(
  const std::vector<Point>& points, const Outline& outline, std::vector<Triangle>& triangles)
{
  std::array<Point, MostCornersToSearch> corners;
  double largest = 0;
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    corners[k] = points[outline[k]];
    largest = std::max(
      { largest, std::abs(corners[k][0]), std::abs(corners[k][1]), std::abs(corners[k][2]) });
  }
  const SmallLoop loop{ corners.data(), corners.data(), static_cast<int>(outline.size()) };
  return IsInRange(largest) && AddWithoutOverlap(outline, loop, triangles);
}

/** Triangles by ids of the input, and twice their area. */
struct Candidate
{
  std::vector<Triangle> Triangles;
  double Area = std::numeric_limits<double>::infinity();
};

/** Any polygon. */
class GeneralPolygon
{
public:
  GeneralPolygon(const std::vector<Point>& points, const Outline& outline);
  bool Triangulate(std::vector<Triangle>& triangles);

private:
  void FindPlaces();
  void FindEdges();
  bool LookAlong(int axis);
  void TryFans();
  void TryAllTriangulations();
  void Consider(Candidate&& candidate);
  void AddScaled(Id a, Id b, Id c, Candidate& candidate) const;

  const Outline& Order;
  std::vector<Point> Corners; ///< in that order
  std::vector<Point> Scaled;
  const Extent Size;

  std::vector<Point> Places;     ///< the corners, each once, ascending
  std::vector<Id> PlaceOfCorner; ///< in the order
  std::vector<Id> CornerAt;      ///< one corner per place, in the order
  std::vector<OutlineEdge> Edges;
  Candidate Best;
  bool IsCrossed = false;  ///< two edges cross in some projection
  bool IsEnclosed = false; ///< no two edges cross in some projection
};

std::vector<Point> CornersInOrder(const std::vector<Point>& points, const Outline& outline)
{
  std::vector<Point> corners(outline.size());
  for (std::size_t k = 0; k < outline.size(); ++k)
  {
    corners[k] = points[outline[k]];
  }
  return corners;
}

/** Relative to the first corner, and scaled so that products neither overflow nor underflow. */
std::vector<Point> InRange(const std::vector<Point>& corners)
{
  std::vector<Point> moved = ScaledPoints(corners, -LargestExponent(corners));
  const Point origin = moved[0];
  for (Point& corner : moved)
  {
    corner = Difference(corner, origin);
  }
  return ScaledPoints(moved, -LargestExponent(moved));
}

GeneralPolygon::GeneralPolygon(const std::vector<Point>& points, const Outline& outline)
  : Order(outline)
  , Corners(CornersInOrder(points, outline))
  , Scaled(InRange(Corners))
  , Size(Scaled.data(), Scaled.size())
{
  this->FindPlaces();
  this->FindEdges();
}

void GeneralPolygon::FindPlaces()
{
  this->Places = this->Corners;
  SortUniquely(this->Places);
  this->CornerAt.assign(this->Places.size(), None);
  for (std::size_t k = 0; k < this->Corners.size(); ++k)
  {
    const Id place = IndexIn(this->Places, this->Corners[k]);
    this->PlaceOfCorner.push_back(place);
    this->CornerAt[place] =
      this->CornerAt[place] == None ? static_cast<Id>(k) : this->CornerAt[place];
  }
}

/** Edges along which the outline runs equally often in both directions cancel. */
void GeneralPolygon::FindEdges()
{
  std::vector<OutlineEdge> all;
  for (std::size_t k = 0; k < this->Corners.size(); ++k)
  {
    const Id from = this->PlaceOfCorner[k];
    const Id to = this->PlaceOfCorner[k + 1 < this->Corners.size() ? k + 1 : 0];
    if (from != to)
    {
      all.push_back({ EdgeBetween(from, to), from < to ? 1 : -1 });
    }
  }
  std::sort(all.begin(), all.end(),
    [](const OutlineEdge& a, const OutlineEdge& b) { return a.Ends < b.Ends; });
  for (std::size_t first = 0, next = 0; first < all.size(); first = next)
  {
    OutlineEdge edge{ all[first].Ends, 0 };
    for (; next < all.size() && all[next].Ends == edge.Ends; ++next)
    {
      edge.Count += all[next].Count;
    }
    if (edge.Count != 0)
    {
      this->Edges.push_back(edge);
    }
  }
}

/** Add a triangle by its corners in the order, unless two are at one place. */
void GeneralPolygon::AddScaled(Id a, Id b, Id c, Candidate& candidate) const
{
  const std::vector<Id>& place = this->PlaceOfCorner;
  if (place[a] != place[b] && place[b] != place[c] && place[c] != place[a])
  {
    this->Order.Add(a, b, c, candidate.Triangles);
    candidate.Area += Length(NormalOf(this->Scaled[a], this->Scaled[b], this->Scaled[c]));
  }
}

void GeneralPolygon::Consider(Candidate&& candidate)
{
  if (candidate.Area < this->Best.Area * (1 - SameArea))
  {
    this->Best = std::move(candidate);
  }
}

/** @return whether the result cannot be improved */
bool GeneralPolygon::LookAlong(int axis)
{
  const auto found = TriangulateEnclosed(this->Places, this->Edges, axis);
  if (!found)
  {
    return false;
  }
  (found->IsCrossed ? this->IsCrossed : this->IsEnclosed) = true;
  if (found->Triangles.empty())
  {
    return false;
  }
  Candidate candidate;
  candidate.Area = 0;
  for (const Triangle& t : found->Triangles)
  {
    this->AddScaled(this->CornerAt[t[0]], this->CornerAt[t[1]], this->CornerAt[t[2]], candidate);
  }
  const bool isBest = !found->IsCrossed && this->Size.IsLeast(candidate.Area);
  if (isBest)
  {
    this->Best = std::move(candidate);
  }
  else
  {
    this->Consider(std::move(candidate));
  }
  return isBest;
}

void GeneralPolygon::TryFans()
{
  const std::size_t size = this->Corners.size();
  const std::size_t step = 1 + (size - 1) / MostApexes;
  for (std::size_t apex = 0; apex < size; apex += step)
  {
    Candidate fan;
    fan.Area = 0;
    for (std::size_t k = 1; k + 1 < size; ++k)
    {
      const std::size_t at = apex + k;
      this->AddScaled(
        static_cast<Id>(apex), static_cast<Id>(at % size), static_cast<Id>((at + 1) % size), fan);
    }
    this->Consider(std::move(fan));
  }
}

void GeneralPolygon::TryAllTriangulations()
{
  const SmallLoop loop{ this->Corners.data(), this->Scaled.data(),
    static_cast<int>(this->Corners.size()) };
  const auto found = FindBestLoopTriangles(loop, this->Size.Axis(), 0, SameArea * this->Size.Sum);
  if (found)
  {
    Candidate candidate;
    candidate.Area = 0;
    for (std::size_t k = 0; k + 2 < this->Corners.size(); ++k)
    {
      const std::array<int, 3>& t = found->Corners[k];
      this->AddScaled(t[0], t[1], t[2], candidate);
    }
    this->Consider(std::move(candidate));
  }
}

bool GeneralPolygon::Triangulate(std::vector<Triangle>& triangles)
{
  if (this->Edges.empty())
  {
    this->Order.Add(0, 1, 0, triangles); // encloses nothing, but has to be counted
    return true;
  }
  const bool isSmall = this->Corners.size() <= MostCornersToSearch;
  const SmallLoop loop{ this->Corners.data(), this->Scaled.data(),
    static_cast<int>(this->Corners.size()) };
  if (isSmall && AddWithoutOverlap(this->Order, loop, triangles))
  {
    return true;
  }
  const std::vector<int> axes = this->Size.Axes();
  const bool isDone =
    std::any_of(axes.begin(), axes.end(), [&](int axis) { return this->LookAlong(axis); });
  if (!isDone && isSmall)
  {
    this->TryAllTriangulations();
  }
  else if (!isDone)
  {
    this->TryFans();
  }
  triangles.insert(triangles.end(), this->Best.Triangles.begin(), this->Best.Triangles.end());
  return this->IsEnclosed || !this->IsCrossed;
}
} // namespace

bool TriangulatePolygon(const std::vector<Point>& points, const std::vector<Id>& corners,
  std::vector<Triangle>& triangles)
{
  if (corners.size() == 3)
  {
    triangles.push_back({ { corners[0], corners[1], corners[2] } });
    return true;
  }
  const Outline outline(points, corners);
  if (outline.size() <= MostCornersToSearch && AddSmall(points, outline, triangles))
  {
    return true;
  }
  return GeneralPolygon(points, outline).Triangulate(triangles);
}
} // namespace insideout
