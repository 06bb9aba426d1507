// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/TriangulatePolygon.h"

#include "Common/Edge.h"
#include "Common/PointPredicates.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"
#include "Validate/BestLoopTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>

using namespace insideout;

namespace
{
/** The points in the order in which the outline runs. */
using Polygon = std::vector<Point>;

struct Result
{
  std::vector<Triangle> Triangles; ///< of places in the polygon
  bool IsEnclosed;
};

Result Triangulate(const Polygon& polygon)
{
  std::vector<Id> corners(polygon.size());
  std::iota(corners.begin(), corners.end(), 0);
  Result result;
  result.IsEnclosed = TriangulatePolygon(polygon, corners, result.Triangles);
  return result;
}

using Chain = std::map<std::array<Point, 2>, int>;

void AddEdge(const Point& from, const Point& to, Chain& chain)
{
  if (from != to)
  {
    const bool turned = to < from;
    const std::array<Point, 2> key = { turned ? to : from, turned ? from : to };
    if ((chain[key] += turned ? -1 : 1) == 0)
    {
      chain.erase(key);
    }
  }
}

Chain OutlineOf(const Polygon& polygon)
{
  Chain chain;
  for (std::size_t k = 0; k < polygon.size(); ++k)
  {
    AddEdge(polygon[k], polygon[(k + 1) % polygon.size()], chain);
  }
  return chain;
}

Chain BoundaryOf(const Polygon& polygon, const std::vector<Triangle>& triangles)
{
  Chain chain;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      AddEdge(polygon[t[k]], polygon[t[(k + 1) % 3]], chain);
    }
  }
  return chain;
}

/** The triangles by coordinates, wherever each begins, in an order of their own. */
std::vector<std::array<Point, 3>> Places(
  const Polygon& polygon, const std::vector<Triangle>& triangles, bool turned)
{
  std::vector<std::array<Point, 3>> places;
  for (const Triangle& t : triangles)
  {
    std::array<Point, 3> corners = { polygon[t[0]], polygon[t[1]], polygon[t[2]] };
    if (turned)
    {
      std::swap(corners[1], corners[2]);
    }
    const auto& [a, b, c] = corners;
    places.push_back(std::min({ corners, { b, c, a }, { c, a, b } }));
  }
  std::sort(places.begin(), places.end());
  return places;
}

double AreaOf(const Polygon& polygon, const std::vector<Triangle>& triangles)
{
  double area = 0;
  for (const Triangle& t : triangles)
  {
    area += Length(NormalOf(polygon[t[0]], polygon[t[1]], polygon[t[2]])) / 2;
  }
  return area;
}

std::array<double, 2> Seen(const Point& p, int axis)
{
  return { p[(axis + 1) % 3], p[(axis + 2) % 3] };
}

int OrientationOf(const Polygon& polygon, const Triangle& t, int axis)
{
  return Orient2D(Seen(polygon[t[0]], axis), Seen(polygon[t[1]], axis), Seen(polygon[t[2]], axis));
}

/** How often a loop winds around a point that is on none of its edges. */
int WindingNumber(const Polygon& loop, const std::array<double, 2>& p, int axis)
{
  int winding = 0;
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    const auto a = Seen(loop[k], axis);
    const auto b = Seen(loop[(k + 1) % loop.size()], axis);
    if ((a[1] <= p[1]) != (b[1] <= p[1]) && Orient2D(a, b, p) == (a[1] <= p[1] ? 1 : -1))
    {
      winding += a[1] <= p[1] ? 1 : -1;
    }
  }
  return winding;
}

bool CrossProperly(const Polygon& polygon, int axis)
{
  const Chain chain = OutlineOf(polygon);
  for (auto one = chain.begin(); one != chain.end(); ++one)
  {
    for (auto other = chain.begin(); other != one; ++other)
    {
      const auto [a, b] = one->first;
      const auto [c, d] = other->first;
      const auto side = [&](const Point& p, const Point& q, const Point& r)
      { return Orient2D(Seen(p, axis), Seen(q, axis), Seen(r, axis)); };
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0)
      {
        return true;
      }
    }
  }
  return false;
}

/** What holds for every polygon. */
Result ExpectLaws(const Polygon& polygon)
{
  const Result result = Triangulate(polygon);
  EXPECT_FALSE(result.Triangles.empty());
  EXPECT_EQ(BoundaryOf(polygon, result.Triangles), OutlineOf(polygon));
  const auto expected = Places(polygon, result.Triangles, false);
  const std::size_t step = 1 + polygon.size() / 3;
  for (std::size_t begin = 0; begin < polygon.size(); begin += step)
  {
    Polygon other = polygon;
    std::rotate(other.begin(), other.begin() + begin, other.end());
    for (const bool turned : { false, true })
    {
      if (turned)
      {
        std::reverse(other.begin(), other.end());
      }
      const Result again = Triangulate(other);
      EXPECT_EQ(again.IsEnclosed, result.IsEnclosed);
      EXPECT_EQ(Places(other, again.Triangles, turned), expected)
        << "begun at " << begin << (turned ? ", turned" : "");
    }
  }
  return result;
}

/** What holds where an outline in a plane does not cross itself: each place is covered as often as
 * the outline winds around it, and by triangles that are turned alike. */
void ExpectCover(const Polygon& polygon, const Result& result, int axis, std::mt19937& random)
{
  double low = 0;
  double high = 0;
  for (const Point& p : polygon)
  {
    for (const double x : Seen(p, axis))
    {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  std::uniform_real_distribution<double> within(low, high);
  for (int sample = 0; sample < 20; ++sample)
  {
    const std::array<double, 2> p = { within(random), within(random) };
    int sum = 0;
    int layers = 0;
    for (const Triangle& t : result.Triangles)
    {
      const int winding = WindingNumber({ polygon[t[0]], polygon[t[1]], polygon[t[2]] }, p, axis);
      sum += winding;
      layers += std::abs(winding);
    }
    EXPECT_EQ(sum, WindingNumber(polygon, p, axis));
    EXPECT_EQ(layers, std::abs(sum));
  }
}

/** From a plane into space, exactly for small whole numbers; the plane is seen along all axes. */
Point Tilted(double x, double y)
{
  return { 2 * x - y, x + 3 * y, 4 * x + y };
}

Polygon OnGrid(std::mt19937& random, int size, int width, bool isFlat)
{
  std::uniform_int_distribution<int> place(0, width - 1);
  Polygon polygon;
  for (int k = 0; k < size; ++k)
  {
    const double x = place(random);
    const double y = place(random);
    polygon.push_back(isFlat ? Tilted(x, y) : Point{ x, y, double(place(random)) });
  }
  return polygon;
}

/** Around the origin, with whole coordinates, counter-clockwise; it does not touch itself. */
std::vector<std::array<double, 2>> Star(std::mt19937& random, int size)
{
  const double pi = std::acos(-1.0);
  std::uniform_real_distribution<double> radius(1e5, 1e6);
  std::vector<std::array<double, 2>> star;
  for (int k = 0; k < size; ++k)
  {
    const double r = radius(random);
    star.push_back(
      { std::round(r * std::cos(2 * pi * k / size)), std::round(r * std::sin(2 * pi * k / size)) });
  }
  return star;
}

/** A sheet with rows of square holes. The outline runs along each row on one side of the holes, by
 * bridges between them, and back on their other side. */
Polygon SheetWithHoles(int rows, int columns)
{
  Polygon sheet;
  const auto add = [&](double x, double y) { sheet.push_back(Tilted(x, y)); };
  add(0, 0);
  add(3 * columns + 1, 0);
  add(3 * columns + 1, 3 * rows + 1);
  add(0, 3 * rows + 1);
  for (int row = rows - 1; row >= 0; --row)
  {
    const double y = 3 * row + 1;
    add(0, y);
    for (int column = 0; column < columns; ++column)
    {
      add(3 * column + 1, y);
      add(3 * column + 1, y + 2);
      add(3 * column + 3, y + 2);
      add(3 * column + 3, y);
    }
    for (int column = columns - 1; column >= 0; --column)
    {
      add(3 * column + 3, y);
      add(3 * column + 1, y);
    }
    add(0, y);
  }
  return sheet;
}

double AreaByOutline(const Polygon& polygon)
{
  Point sum = { 0, 0, 0 };
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
  {
    const Point normal = NormalOf(polygon[0], polygon[k], polygon[k + 1]);
    sum = { sum[0] + normal[0], sum[1] + normal[1], sum[2] + normal[2] };
  }
  return Length(sum) / 2;
}

std::size_t CountDegenerate(const Polygon& polygon, const std::vector<Triangle>& triangles)
{
  return std::count_if(triangles.begin(), triangles.end(),
    [&](const Triangle& t) { return IsDegenerate(polygon, t); });
}
} // namespace

TEST(TriangulatePolygon, KeepsTheOutlineAndCoversWhatItEnclosesOnRandomPolygonsOfAPlane)
{
  std::mt19937 random(1);
  int enclosed = 0;
  int crossed = 0;
  for (int turn = 0; turn < 360; ++turn)
  {
    const int size = 3 + turn % 18;
    const Polygon polygon = OnGrid(random, size, 2 + turn / 18 % 5, true);
    SCOPED_TRACE(turn);
    const Result result = ExpectLaws(polygon);
    for (int axis = 0; axis < 3 && result.IsEnclosed; ++axis)
    {
      ExpectCover(polygon, result, axis, random);
    }
    EXPECT_TRUE(result.IsEnclosed || CrossProperly(polygon, 2));
    ++(result.IsEnclosed ? enclosed : crossed);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(enclosed, 50);
  EXPECT_GT(crossed, 50);
}

TEST(TriangulatePolygon, KeepsTheOutlineOfRandomPolygonsInSpace)
{
  std::mt19937 random(2);
  for (int turn = 0; turn < 220; ++turn)
  {
    SCOPED_TRACE(turn);
    ExpectLaws(OnGrid(random, 3 + turn % 22, 2 + turn / 22 % 10, false));
    ASSERT_FALSE(HasFailure());
  }
}

TEST(TriangulatePolygon, KeepsTheOutlineOfLoopsThatAreNearlyInAPlaneOrFarFromIt)
{
  std::mt19937 random(3);
  for (const double shake : { 1e-16, 1e-9, 1e-3, 1.0, 1e3 })
  {
    std::uniform_real_distribution<double> off(-shake, shake);
    for (const int size : { 4, 5, 16, 17, 100 })
    {
      Polygon polygon;
      for (const auto& [x, y] : Star(random, size))
      {
        const Point p = Tilted(x * 1e-6, y * 1e-6);
        polygon.push_back({ p[0] + off(random), p[1] + off(random), p[2] + off(random) });
      }
      SCOPED_TRACE(testing::Message() << size << " corners, " << shake);
      const Result result = ExpectLaws(polygon);
      EXPECT_TRUE(result.IsEnclosed || shake > 1e-4);
    }
  }
}

TEST(TriangulatePolygon, GivesTwoTrianglesLessThanCornersWhereNothingTouches)
{
  std::mt19937 random(4);
  for (int size = 3; size < 60; size += size < 20 ? 1 : 10)
  {
    Polygon polygon;
    for (const auto& [x, y] : Star(random, size))
    {
      polygon.push_back(Tilted(x, y));
    }
    const Result result = ExpectLaws(polygon);
    EXPECT_TRUE(result.IsEnclosed);
    EXPECT_EQ(result.Triangles.size(), polygon.size() - 2);
    EXPECT_EQ(CountDegenerate(polygon, result.Triangles), 0u);
    EXPECT_NEAR(AreaOf(polygon, result.Triangles) / AreaByOutline(polygon), 1, 1e-12);
  }
}

TEST(TriangulatePolygon, LeavesNoDegenerateTriangleWhereCornersOnALineAllowIt)
{
  for (const int onEachSide : { 1, 2, 3, 4, 10 })
  {
    const std::array<double, 2> corners[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
    for (const int sides : { 3, 4 })
    {
      Polygon polygon;
      for (int side = 0; side < sides; ++side)
      {
        const auto& from = corners[side];
        const auto& to = corners[(side + 1) % sides];
        for (int k = 0; k < onEachSide; ++k)
        {
          polygon.push_back(Tilted(from[0] * onEachSide + k * (to[0] - from[0]),
            from[1] * onEachSide + k * (to[1] - from[1])));
        }
      }
      const Result result = ExpectLaws(polygon);
      EXPECT_TRUE(result.IsEnclosed);
      EXPECT_EQ(result.Triangles.size(), polygon.size() - 2);
      EXPECT_EQ(CountDegenerate(polygon, result.Triangles), 0u);
    }
  }
}

TEST(TriangulatePolygon, TakesTheDelaunayTriangulationOfConvexPolygons)
{
  // On an ellipse, which has no two circles through four points but by symmetry: shift it.
  const double pi = std::acos(-1.0);
  for (const int size : { 5, 8, MostCornersToSearch, MostCornersToSearch + 1, 40 })
  {
    Polygon polygon;
    for (int k = 0; k < size; ++k)
    {
      const double angle = 2 * pi * (k + 0.1 * std::sin(k)) / size;
      polygon.push_back({ 3 * std::cos(angle), std::sin(angle), 5 });
    }
    const Result result = ExpectLaws(polygon);
    ASSERT_EQ(result.Triangles.size(), polygon.size() - 2);
    for (const Triangle& t : result.Triangles)
    {
      for (const Point& p : polygon)
      {
        double rows[3][3];
        for (int i = 0; i < 3; ++i)
        {
          rows[i][0] = polygon[t[i]][0] - p[0];
          rows[i][1] = polygon[t[i]][1] - p[1];
          rows[i][2] = rows[i][0] * rows[i][0] + rows[i][1] * rows[i][1];
        }
        EXPECT_LT(Determinant<double>({ rows[0][0], rows[0][1], rows[0][2] },
                    { rows[1][0], rows[1][1], rows[1][2] }, { rows[2][0], rows[2][1], rows[2][2] }),
          1e-9);
      }
    }
  }
}

TEST(TriangulatePolygon, CutsHolesThatABridgeLeadsTo)
{
  for (const auto& [rows, columns] :
    { std::array{ 1, 1 }, { 2, 1 }, { 3, 3 }, { 20, 25 } }) // the last has 3,044 corners
  {
    const Polygon sheet = SheetWithHoles(rows, columns);
    SCOPED_TRACE(sheet.size());
    const Result result = ExpectLaws(sheet);
    EXPECT_TRUE(result.IsEnclosed);
    const double unit = AreaByOutline({ Tilted(0, 0), Tilted(1, 0), Tilted(1, 1), Tilted(0, 1) });
    const double area = (3 * columns + 1) * (3 * rows + 1) - 4 * rows * columns;
    EXPECT_NEAR(AreaOf(sheet, result.Triangles) / unit, area, 1e-9 * area);
  }
}

TEST(TriangulatePolygon, CutsAHoleWhoseBridgeEndsWithinAnEdgeAndOneThatTouchesAnEdge)
{
  const auto flat = [](const std::vector<std::array<double, 2>>& outline)
  {
    Polygon polygon;
    for (const auto& [x, y] : outline)
    {
      polygon.push_back({ x, y, 0 });
    }
    return polygon;
  };
  // The bridge begins at (2, 0), which is no corner of the square.
  const Polygon bridged = flat({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 3 }, { 3, 3 },
    { 3, 1 }, { 2, 1 }, { 2, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } });
  Result result = ExpectLaws(bridged);
  EXPECT_TRUE(result.IsEnclosed);
  EXPECT_DOUBLE_EQ(AreaOf(bridged, result.Triangles), 12);
  EXPECT_EQ(CountDegenerate(bridged, result.Triangles), 0u);

  // The outline comes to (2, 0), which is in the middle of its first edge.
  const Polygon touching = flat({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, 0 }, { 0, 4 } });
  result = ExpectLaws(touching);
  EXPECT_TRUE(result.IsEnclosed);
  EXPECT_DOUBLE_EQ(AreaOf(touching, result.Triangles), 8);
  EXPECT_EQ(CountDegenerate(touching, result.Triangles), 1u) << "between the edge and its halves";

  // Two triangles that share a corner, one turned over.
  const Polygon eight = flat({ { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 0 }, { -2, 2 }, { -2, 0 } });
  result = ExpectLaws(eight);
  EXPECT_TRUE(result.IsEnclosed);
  EXPECT_DOUBLE_EQ(AreaOf(eight, result.Triangles), 4);

  // Along an edge and half of the way back.
  const Polygon spike = flat({ { 0, 0 }, { 4, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } });
  result = ExpectLaws(spike);
  EXPECT_TRUE(result.IsEnclosed);
  EXPECT_DOUBLE_EQ(AreaOf(spike, result.Triangles), 4);
}

TEST(TriangulatePolygon, SaysWhereAnOutlineCrossesItselfAndKeepsItStill)
{
  const Polygon bow = { { 0, 0, 1 }, { 3, 2, 1 }, { 3, 0, 1 }, { 0, 2, 1 } };
  EXPECT_FALSE(ExpectLaws(bow).IsEnclosed);

  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  for (const int size : { 17, 60, 200 })
  {
    Polygon polygon;
    for (int k = 0; k < size; ++k)
    {
      polygon.push_back({ anywhere(random), anywhere(random), 0 });
    }
    EXPECT_FALSE(ExpectLaws(polygon).IsEnclosed);
  }
}

TEST(TriangulatePolygon, GoesAroundWhatRoundingPutsAcrossAnEdge)
{
  // As the touching outline, but it comes to a point beyond the edge, by the least that there is.
  Polygon polygon;
  for (const auto& [x, y] : { std::array{ 0.0, 1.0 }, { 4, 1 }, { 4, 5 }, { 2, 1 }, { 0, 5 } })
  {
    polygon.push_back({ x, y, 0 });
  }
  polygon[3][1] = std::nextafter(1.0, 0.0);
  for (int k = 1; k < MostCornersToSearch; ++k)
  {
    polygon.push_back(
      { -0.1 * k * (MostCornersToSearch - k), 5 - 4.0 * k / MostCornersToSearch, 0 });
  }
  const Result result = ExpectLaws(polygon);
  EXPECT_FALSE(result.IsEnclosed);
  EXPECT_NEAR(AreaOf(polygon, result.Triangles), AreaByOutline(polygon), 1e-14);
}

TEST(TriangulatePolygon, CutsAPolygonThatIsNotFlatToTheLeastArea)
{
  // Over a square, two opposite corners lifted: the two ways enclose a tetrahedron.
  for (const double lift : { 0.5, -0.5 })
  {
    const Polygon quad = { { 0, 0, 0 }, { 2, 0, lift }, { 2, 1, 0 }, { -1, 1, lift } };
    const Result result = ExpectLaws(quad);
    const double areas[2] = { AreaOf(quad, { { { 0, 1, 2 } }, { { 0, 2, 3 } } }),
      AreaOf(quad, { { { 0, 1, 3 } }, { { 1, 2, 3 } } }) };
    EXPECT_NEAR(AreaOf(quad, result.Triangles), std::min(areas[0], areas[1]), 1e-14);
  }
  // Seven corners: all 42 ways, as fans of fans.
  std::mt19937 random(6);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  for (int turn = 0; turn < 20; ++turn)
  {
    Polygon loop(7);
    for (Point& p : loop)
    {
      p = { anywhere(random), anywhere(random), anywhere(random) };
    }
    const std::function<double(int, int)> least = [&](int i, int j)
    {
      double best = j - i > 1 ? 1e300 : 0;
      for (int k = i + 1; k < j; ++k)
      {
        best = std::min(best, least(i, k) + least(k, j) + AreaOf(loop, { { { i, k, j } } }));
      }
      return best;
    };
    EXPECT_LE(AreaOf(loop, ExpectLaws(loop).Triangles), least(0, 6) * (1 + 1e-6));
  }
}

TEST(TriangulatePolygon, TakesCoordinatesOfAnySize)
{
  std::mt19937 random(7);
  for (const double size : { 1e300, 1e150, 1e-150, 1e-300, 5e-324 })
  {
    for (int turn = 0; turn < 18; ++turn)
    {
      Polygon polygon = OnGrid(random, 3 + turn % 18, 6, turn % 4 != 0);
      for (Point& p : polygon)
      {
        p = { p[0] * size, p[1] * size, p[2] * size };
      }
      SCOPED_TRACE(testing::Message() << size << ", " << turn);
      ExpectLaws(polygon);
    }
    Polygon sheet = SheetWithHoles(2, 3);
    const double unit = AreaByOutline({ Tilted(0, 0), Tilted(1, 0), Tilted(1, 1), Tilted(0, 1) });
    const Polygon unscaled = sheet;
    for (Point& p : sheet)
    {
      p = { p[0] * size, p[1] * size, p[2] * size };
    }
    const Result result = ExpectLaws(sheet);
    EXPECT_TRUE(result.IsEnclosed);
    EXPECT_NEAR(AreaOf(unscaled, result.Triangles) / unit, 10 * 7 - 24, 1e-9);
  }
}

TEST(TriangulatePolygon, GivesDegenerateTrianglesForWhatHasNoArea)
{
  const Point a = { 0, 0, 0 };
  const Point b = { 1, 2, 3 };
  const Point c = { 2, 4, 6 };
  const Point d = { 5, 0, 0 };
  for (const Polygon& polygon : { Polygon{ a, a, a, a }, { a, b, a, b }, { a, b, c, b },
         { b, c, a, c, a }, { d, a, b, a, d, c }, { a, c, b, Point{ 1.5, 3, 4.5 } } })
  {
    const Result result = ExpectLaws(polygon);
    EXPECT_TRUE(result.IsEnclosed);
    EXPECT_GE(CountDegenerate(polygon, result.Triangles), 1u);
  }
  std::mt19937 random(8);
  Polygon line;
  for (int k = 0; k < 400; ++k)
  {
    const double x = random() % 1000;
    line.push_back({ x, 2 * x, 3 * x });
  }
  const Result result = ExpectLaws(line);
  EXPECT_TRUE(result.IsEnclosed);
  EXPECT_EQ(CountDegenerate(line, result.Triangles), result.Triangles.size());
}

TEST(TriangulatePolygon, KeepsIdsWithinThePolygonAndAddsToWhatIsThere)
{
  const std::vector<Point> points = { { 9, 9, 9 }, { 0, 0, 0 }, { 1, 0, 0 }, { -0.0, 0, 0 },
    { 1, 1, 0 }, { 0, 1, 0 } };
  std::vector<Triangle> triangles = { { { 0, 1, 2 } } };
  EXPECT_TRUE(TriangulatePolygon(points, { 5, 3, 2, 4 }, triangles));
  ASSERT_EQ(triangles.size(), 3u);
  EXPECT_EQ(triangles[0], (Triangle{ { 0, 1, 2 } }));
  for (std::size_t t = 1; t < triangles.size(); ++t)
  {
    for (const Id p : triangles[t])
    {
      EXPECT_GE(p, 2);
    }
    EXPECT_EQ(OrientationOf(points, triangles[t], 2), 1);
  }
}

TEST(TriangulatePolygon, GivesUpCrossingsThatTakeTooManyTrianglesForAFan)
{
  // Two combs across each other, with too many crossings for detours.
  Polygon polygon;
  for (int k = 0; k < 60; ++k)
  {
    polygon.push_back({ double(k), k % 2 ? 59.0 : 0.0, 0 });
  }
  for (int k = 0; k < 60; ++k)
  {
    polygon.push_back({ k % 2 ? 59.5 : -0.5, double(k) + 0.25, 0 });
  }
  const Result result = Triangulate(polygon);
  EXPECT_FALSE(result.IsEnclosed);
  EXPECT_EQ(BoundaryOf(polygon, result.Triangles), OutlineOf(polygon));
}
