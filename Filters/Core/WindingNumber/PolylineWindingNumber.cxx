// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/PolylineWindingNumber.h"

#include "Common/ChunkedLoop.h"
#include "Common/DoubleDouble.h"
#include "Common/Numbers.h"
#include "Common/PointPredicates.h"
#include "Common/Stages.h"
#include "WindingNumber/Pi.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
constexpr std::size_t LeafSize = 8;

/** A query point with double coordinates. */
struct RoundPlace
{
  PlanarPoint Rounded;

  PlanarPoint Low() const { return this->Rounded; }
  PlanarPoint High() const { return this->Rounded; }
  bool IsAtOrAbove(double height) const { return height >= this->Rounded[1]; }
  PlanarPoint Offset(const PlanarPoint& a) const
  {
    return { a[0] - this->Rounded[0], a[1] - this->Rounded[1] };
  }
  int Side(const PlanarPoint& a, const PlanarPoint& b) const
  {
    return Orient2D(a, b, this->Rounded);
  }
  bool IsInBox(const PlanarPoint& a, const PlanarPoint& b) const
  {
    const PlanarPoint& p = this->Rounded;
    return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
      std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
  }
};

/** A query point in double-double precision: nearer to the mean of three points than to any open
 * end. */
struct FinePlace
{
  explicit FinePlace(const std::array<PlanarPoint, 3>& points)
  {
    for (int k = 0; k < 2; ++k)
    {
      const DoubleDouble sum = TwoSum(points[0][k], points[1][k]) + DoubleDouble(points[2][k]);
      const double third = sum.High / 3;
      const DoubleDouble rest = sum - DoubleDouble(third) * DoubleDouble(3);
      const DoubleDouble mean = QuickTwoSum(third, rest.High / 3);
      this->Rounded[k] = mean.High;
      this->Rest[k] = mean.Low;
    }
  }

  PlanarPoint Low() const { return this->Next(-1); }
  PlanarPoint High() const { return this->Next(1); }
  PlanarPoint Next(double sign) const
  {
    const double far = sign * std::numeric_limits<double>::infinity();
    return { std::nextafter(this->Rounded[0], far), std::nextafter(this->Rounded[1], far) };
  }
  PlanarPoint Offset(const PlanarPoint& a) const
  {
    return { this->Beyond(a[0], 0), this->Beyond(a[1], 1) };
  }

  /** A coordinate's offset from this place's: near it the first difference is exact. */
  double Beyond(double a, int k) const { return (a - this->Rounded[k]) - this->Rest[k]; }
  bool IsAtOrAbove(double height) const { return this->Beyond(height, 1) >= 0; }
  int Side(const PlanarPoint& a, const PlanarPoint& b) const
  {
    const double along = (b[0] - a[0]) * this->Beyond(a[1], 1);
    const double across = (b[1] - a[1]) * this->Beyond(a[0], 0);
    // Bound of seven roundings, each half a unit in the last place, and of products that underflow.
    const double bound =
      8 * std::numeric_limits<double>::epsilon() * (std::abs(along) + std::abs(across)) +
      std::numeric_limits<double>::min();
    if (std::abs(across - along) > bound)
    {
      return across > along ? 1 : -1;
    }
    const auto beyond = [&](int k)
    { return DyadicNumber(a[k]) - this->Rounded[k] - DyadicNumber(this->Rest[k]); };
    return CGAL::sign(
      (DyadicNumber(b[1]) - a[1]) * beyond(0) - (DyadicNumber(b[0]) - a[0]) * beyond(1));
  }
  bool IsInBox(const PlanarPoint& a, const PlanarPoint& b) const
  {
    const PlanarPoint u = this->Offset(a);
    const PlanarPoint v = this->Offset(b);
    return std::min(u[0], v[0]) <= 0 && std::max(u[0], v[0]) >= 0 && std::min(u[1], v[1]) <= 0 &&
      std::max(u[1], v[1]) >= 0;
  }

  PlanarPoint Rounded;
  PlanarPoint Rest;
};

/** The mean of three points, exactly: all tests use three times the mean. */
struct MeanPlace
{
  explicit MeanPlace(const std::array<PlanarPoint, 3>& points)
  {
    for (int k = 0; k < 2; ++k)
    {
      this->Rounded[k] = points[0][k] / 3 + points[1][k] / 3 + points[2][k] / 3;
      for (const PlanarPoint& p : points)
      {
        this->Size = std::max(this->Size, std::abs(p[k]));
      }
      this->Sum[k] = DyadicNumber(points[0][k]) + points[1][k] + points[2][k];
    }
  }

  /** Bounds of the mean, far enough apart for the roundings of three numbers. */
  PlanarPoint Low() const { return this->Moved(-1); }
  PlanarPoint High() const { return this->Moved(1); }
  PlanarPoint Moved(double sign) const
  {
    const double few = 8 * std::numeric_limits<double>::epsilon();
    const double least = std::numeric_limits<double>::min();
    return { this->Rounded[0] + sign * (few * this->Size + least),
      this->Rounded[1] + sign * (few * this->Size + least) };
  }
  bool IsAtOrAbove(double height) const { return this->Compare(height, 1) >= 0; }
  PlanarPoint Offset(const PlanarPoint& a) const
  {
    return { CGAL::to_double(this->Beyond(a[0], 0)) / 3,
      CGAL::to_double(this->Beyond(a[1], 1)) / 3 };
  }
  int Side(const PlanarPoint& a, const PlanarPoint& b) const
  {
    const auto along = [&](int k) { return DyadicNumber(b[k]) - a[k]; };
    return CGAL::sign(along(1) * this->Beyond(a[0], 0) - along(0) * this->Beyond(a[1], 1));
  }
  bool IsInBox(const PlanarPoint& a, const PlanarPoint& b) const
  {
    return this->Compare(a[0], 0) * this->Compare(b[0], 0) <= 0 &&
      this->Compare(a[1], 1) * this->Compare(b[1], 1) <= 0;
  }

  int Compare(double a, int k) const { return CGAL::sign(this->Beyond(a, k)); }

  /** Three times the offset of a point's coordinate from the mean's. */
  DyadicNumber Beyond(double a, int k) const { return DyadicNumber(a) * 3 - this->Sum[k]; }

  PlanarPoint Rounded;
  std::array<DyadicNumber, 2> Sum;
  double Size = 0; ///< the largest coordinate of the three points
};
} // namespace

PolylineWindingNumber::PolylineWindingNumber(std::vector<PlanarPoint> points,
  const std::vector<CountedSegment>& segments, const PlanarMetric& metric)
  : Points(std::move(points))
  , Metric(metric)
{
  for (const CountedSegment& segment : segments)
  {
    if (this->Points[segment.From] != this->Points[segment.To] && segment.Count != 0)
    {
      this->Segments.push_back(segment);
    }
  }
  this->LooseEnds = this->LooseEndsOf(0, this->Segments.size());
  std::vector<CountedPlace> ends;
  for (const LooseEnd& end : this->LooseEnds)
  {
    ends.push_back({ this->Points[end.Point], static_cast<double>(end.Count) });
  }
  this->Arguments = ArgumentSum(std::move(ends), metric);
  if (!this->Segments.empty())
  {
    this->Build(0, this->Segments.size());
  }
}

std::vector<PolylineWindingNumber::LooseEnd> PolylineWindingNumber::LooseEndsOf(
  std::size_t begin, std::size_t end) const
{
  std::vector<LooseEnd> ends;
  for (std::size_t s = begin; s < end; ++s)
  {
    ends.push_back({ this->Segments[s].From, -this->Segments[s].Count });
    ends.push_back({ this->Segments[s].To, this->Segments[s].Count });
  }
  // Points with equal coordinates are merged.
  std::sort(ends.begin(), ends.end(),
    [&](const LooseEnd& a, const LooseEnd& b)
    { return this->Points[a.Point] < this->Points[b.Point]; });
  std::vector<LooseEnd> loose;
  for (std::size_t first = 0, next = 0; first < ends.size(); first = next)
  {
    LooseEnd sum = { ends[first].Point, 0 };
    for (; next < ends.size() && this->Points[ends[next].Point] == this->Points[sum.Point]; ++next)
    {
      sum.Count += ends[next].Count;
    }
    if (sum.Count != 0)
    {
      loose.push_back(sum);
    }
  }
  return loose;
}

void PolylineWindingNumber::Build(std::size_t begin, std::size_t end)
{
  const std::size_t index = this->Nodes.size();
  Node node;
  node.Low = node.High = this->Points[this->Segments[begin].From];
  for (std::size_t s = begin; s < end; ++s)
  {
    for (const Id p : { this->Segments[s].From, this->Segments[s].To })
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        node.Low[axis] = std::min(node.Low[axis], this->Points[p][axis]);
        node.High[axis] = std::max(node.High[axis], this->Points[p][axis]);
      }
    }
  }
  node.Begin = begin;
  node.End = end;
  node.Right = 0;
  std::vector<std::pair<double, double>> heights;
  for (const LooseEnd& loose : this->LooseEndsOf(begin, end))
  {
    heights.emplace_back(this->Points[loose.Point][1], static_cast<double>(loose.Count));
  }
  node.LooseEnds = CountsAbove(std::move(heights));
  this->Nodes.push_back(std::move(node));
  if (end - begin <= LeafSize)
  {
    return;
  }
  const int axis = node.High[0] - node.Low[0] > node.High[1] - node.Low[1] ? 0 : 1;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto first = this->Segments.begin();
  const auto twiceCentre = [&](const CountedSegment& s)
  { return this->Points[s.From][axis] + this->Points[s.To][axis]; };
  std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
    first + static_cast<std::ptrdiff_t>(middle), first + static_cast<std::ptrdiff_t>(end),
    [&](const CountedSegment& a, const CountedSegment& b)
    { return twiceCentre(a) < twiceCentre(b); });
  this->Build(begin, middle);
  this->Nodes[index].Right = this->Nodes.size();
  this->Build(middle, end);
}

/** The argument of the direction from a place to a point, over 2 pi: in (-1/2, 1/2], and 0 if they
 * coincide. */
template <typename Place>
double PolylineWindingNumber::Argument(Id point, const Place& place) const
{
  const PlanarPoint direction = this->Metric.Map(place.Offset(this->Points[point]));
  return std::atan2(direction[1] + 0.0, direction[0] + 0.0) / (2 * Pi); // adding 0: no -0
}

/**
 * The segment's correction to the difference of arguments; if p lies on the segment, the two
 * cancel.
 */
template <typename Place>
double PolylineWindingNumber::Crossing(const CountedSegment& segment, const Place& place) const
{
  const PlanarPoint& a = this->Points[segment.From];
  const PlanarPoint& b = this->Points[segment.To];
  const bool fromAbove = place.IsAtOrAbove(a[1]);
  const bool toAbove = place.IsAtOrAbove(b[1]);
  const bool inBox = place.IsInBox(a, b);
  if (fromAbove == toAbove && !inBox)
  {
    return 0;
  }
  const int side = place.Side(a, b);
  if (side == 0 && inBox)
  {
    return -segment.Count *
      (this->Argument(segment.To, place) - this->Argument(segment.From, place));
  }
  if (fromAbove && !toAbove && side > 0)
  {
    return segment.Count;
  }
  return !fromAbove && toAbove && side < 0 ? -segment.Count : 0;
}

template <typename Place>
double PolylineWindingNumber::AtPlace(const Place& place) const
{
  const PlanarPoint low = place.Low();
  const PlanarPoint high = place.High();
  double w = this->Arguments.At(place);
  std::vector<std::size_t> stack;
  if (!this->Nodes.empty())
  {
    stack.push_back(0);
  }
  while (!stack.empty())
  {
    const std::size_t index = stack.back();
    stack.pop_back();
    const Node& node = this->Nodes[index];
    if (node.Low[0] > high[0] || node.Low[1] > high[1] || node.High[1] < low[1])
    {
      continue;
    }
    if (node.High[0] < low[0] && node.Right != 0)
    {
      w -= node.LooseEnds.At(place); // all to the left: the loose ends determine the crossings
    }
    else if (node.Right == 0)
    {
      for (std::size_t s = node.Begin; s < node.End; ++s)
      {
        w += this->Crossing(this->Segments[s], place);
      }
    }
    else
    {
      stack.push_back(node.Right);
      stack.push_back(index + 1);
    }
  }
  return w;
}

double PolylineWindingNumber::At(const PlanarPoint& p) const
{
  return this->AtPlace(RoundPlace{ p });
}

double PolylineWindingNumber::AtMean(
  const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c) const
{
  const std::array<PlanarPoint, 3> corners{ { a, b, c } };
  const FinePlace place(corners);
  const bool isWithin = place.Side(a, b) > 0 && place.Side(b, c) > 0 && place.Side(c, a) > 0;
  return isWithin ? this->AtPlace(place) : this->AtPlace(MeanPlace(corners));
}

std::vector<double> PolylineWindingNumber::At(
  const std::vector<PlanarPoint>& points, Monitor& monitor) const
{
  std::vector<double> w(points.size(), 0.0);
  const double nanosecondsPerPoint = 1000;
  ChunkedLoop(static_cast<Id>(points.size()), nanosecondsPerPoint, monitor,
    { Stages::WindingNumbers, 0, 1 }, [&](Id i) { w[i] = this->At(points[i]); });
  monitor.Check(Stages::WindingNumbers, 1);
  return w;
}
} // namespace insideout
