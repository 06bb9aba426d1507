// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/TouchingFacets.h"

#include "Common/BoxTree.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Resolve/FacetsNearOthers.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace insideout
{
namespace
{
/**
 * Facets lie on each other if their overlap is wider than this number of tolerances. This excludes
 * planes at an angle of more than 14 degrees.
 */
constexpr double LeastWidth = 4;

using PlanarPlace = std::array<double, 2>;

/** A triangle seen along an axis: its points in projection, and their heights. */
struct SeenTriangle
{
  SeenTriangle(const std::array<Point, 3>& corners, const Point& origin, int axis)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Point p = Difference(corners[k], origin);
      this->Places[k] = { p[(axis + 1) % 3], p[(axis + 2) % 3] };
      this->Heights[k] = p[axis];
    }
    this->DoubleArea = this->AreaAt(this->Places[0], this->Places[1], this->Places[2]);
  }

  static double AreaAt(const PlanarPlace& p, const PlanarPlace& q, const PlanarPlace& r)
  {
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  }

  /** The height at a place in the triangle; if rounding puts it outside, the height of the edge. */
  double HeightAt(const PlanarPlace& p) const
  {
    double height = 0;
    double sum = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double weight = std::max(0.0,
        this->AreaAt(p, this->Places[(k + 1) % 3], this->Places[(k + 2) % 3]) / this->DoubleArea);
      height += weight * this->Heights[k];
      sum += weight;
    }
    return height / sum;
  }

  std::array<PlanarPlace, 3> Places;
  std::array<double, 3> Heights;
  double DoubleArea;
};

/** The intersection of two triangles: the first, cut along the edges of the second. */
std::vector<PlanarPlace> CommonPolygon(const SeenTriangle& first, const SeenTriangle& second)
{
  std::vector<PlanarPlace> polygon(first.Places.begin(), first.Places.end());
  const double turn = second.DoubleArea > 0 ? 1 : -1;
  for (int k = 0; k < 3; ++k)
  {
    const PlanarPlace& from = second.Places[k];
    const PlanarPlace& to = second.Places[(k + 1) % 3];
    std::vector<PlanarPlace> left;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const PlanarPlace& p = polygon[i];
      const PlanarPlace& q = polygon[(i + 1) % polygon.size()];
      const double a = turn * SeenTriangle::AreaAt(from, to, p);
      const double b = turn * SeenTriangle::AreaAt(from, to, q);
      if (a >= 0)
      {
        left.push_back(p);
      }
      if ((a < 0 && b > 0) || (a > 0 && b < 0))
      {
        const double t = a / (a - b);
        left.push_back({ p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]) });
      }
    }
    polygon = std::move(left);
  }
  return polygon;
}

/** Area over diameter. */
double WidthOf(const std::vector<PlanarPlace>& polygon)
{
  double doubleArea = 0;
  double diameter = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      diameter = std::max(
        diameter, std::hypot(polygon[i][0] - polygon[j][0], polygon[i][1] - polygon[j][1]));
    }
    if (i >= 2)
    {
      doubleArea += SeenTriangle::AreaAt(polygon[0], polygon[i - 1], polygon[i]);
    }
  }
  return diameter > 0 ? std::abs(doubleArea) / 2 / diameter : 0;
}

/** The widest gap between two triangles that lie on each other in an area. */
std::optional<double> GapBetween(
  const std::array<Point, 3>& first, const std::array<Point, 3>& second, double leastWidth)
{
  const Point firstNormal = NormalOf(first[0], first[1], first[2]);
  const Point secondNormal = NormalOf(second[0], second[1], second[2]);
  const Point& normal =
    Length(firstNormal) >= Length(secondNormal) ? firstNormal : secondNormal; // tells the plane
  int axis = 0;
  for (int k = 1; k < 3; ++k)
  {
    axis = std::abs(normal[k]) > std::abs(normal[axis]) ? k : axis;
  }
  const SeenTriangle a(first, first[0], axis);
  const SeenTriangle b(second, first[0], axis);
  if (a.DoubleArea == 0 || b.DoubleArea == 0)
  {
    return std::nullopt;
  }
  const std::vector<PlanarPlace> common = CommonPolygon(a, b);
  if (!(WidthOf(common) > leastWidth))
  {
    return std::nullopt;
  }
  double gap = 0;
  for (const PlanarPlace& p : common)
  {
    gap = std::max(gap, std::abs(a.HeightAt(p) - b.HeightAt(p)));
  }
  return gap * std::abs(normal[axis]) / Length(normal);
}
} // namespace

std::vector<TouchingPair> FindTouchingFacets(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& bodyOf,
  const std::vector<double>& tolerances, Monitor& monitor)
{
  std::vector<Id> candidates(bodyOf);
  double largest = 0;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    candidates[f] = tolerances[f] < 0 ? None : bodyOf[f];
    largest = std::max(largest, tolerances[f]);
  }
  std::vector<Box> boxes;
  std::vector<Id> bodies;
  const std::vector<Id> among = FacetsNearOthers(points, facets, candidates, 2 * largest);
  for (const Id f : among)
  {
    boxes.push_back(BoundingBox(points, facets[f]).Widened(tolerances[f]));
    bodies.push_back(bodyOf[f]);
  }
  const BoxTree tree(boxes);
  const std::vector<Id> bodiesOfParts = tree.SetsOfParts(bodies);
  std::vector<TouchingPair> pairs;
  for (Id part = 0; part < tree.NumberOfParts(); ++part)
  {
    monitor.Check(Stages::Resolving, 0);
    tree.VisitPairsBetween(part, bodies, bodiesOfParts,
      [&](Id i, Id j)
      {
        const auto [f, g] = std::minmax(among[i], among[j]);
        const double tolerance = tolerances[f] + tolerances[g];
        const std::optional<double> gap = GapBetween(
          CornersOf(points, facets[f]), CornersOf(points, facets[g]), LeastWidth * tolerance);
        if (gap && *gap <= tolerance)
        {
          pairs.push_back({ f, g, *gap });
        }
      });
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const TouchingPair& a, const TouchingPair& b) {
      return std::array<Id, 2>{ a.First, a.Second } < std::array<Id, 2>{ b.First, b.Second };
    });
  return pairs;
}
} // namespace insideout
