// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/IntersectionCurves.h"

#include "Common/Team.h"
#include "Common/TrianglePredicates.h"
#include "Resolve/FindIntersections.h"
#include "Support/RationalVectors.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <omp.h>

using namespace insideout;
using namespace testmeshes;

namespace
{
IntersectionCurves Trace(const TriangleSoup& soup)
{
  Monitor monitor;
  return TraceIntersections(
    soup.Points, soup.Triangles, FindIntersections(soup.Points, soup.Triangles, monitor), monitor);
}

double Distance(const Point& p, const Point& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double Length(const IntersectionCurves& curves)
{
  double length = 0;
  for (const auto& segment : curves.Segments)
  {
    length += Distance(curves.Points[segment[0]], curves.Points[segment[1]]);
  }
  return length;
}

/** The outline of what two triangles have in common, straight from the definition. */
std::vector<Point> CommonOutline(const TriangleSoup& soup, Id a, Id b)
{
  const auto corners = [&](Id t)
  {
    std::vector<Vector> result;
    for (const Id p : soup.Triangles[t])
    {
      result.push_back(Exact(soup.Points[p]));
    }
    return result;
  };
  const std::vector<Vector> other = corners(b);
  const Vector normal = Cross(Minus(other[1], other[0]), Minus(other[2], other[0]));
  std::vector<Vector> polygon = Clip(corners(a), other[0], normal);
  polygon = Clip(polygon, other[0], Minus({ 0, 0, 0 }, normal));
  for (int k = 0; k < 3; ++k)
  {
    polygon = Clip(polygon, other[k], Cross(normal, Minus(other[(k + 1) % 3], other[k])));
  }
  std::vector<Point> outline;
  for (const Vector& p : polygon)
  {
    outline.push_back({ CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]) });
  }
  return outline;
}

double Perimeter(const std::vector<Point>& outline)
{
  double length = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    length += Distance(outline[i], outline[(i + 1) % outline.size()]);
  }
  return length;
}

bool InOnePlane(const TriangleSoup& soup, Id a, Id b)
{
  const Triangle& t = soup.Triangles[a];
  for (const Id p : soup.Triangles[b])
  {
    const auto exact = [&](Id q)
    {
      const Point& x = soup.Points[q];
      return Vector{ Rational(x[0]), Rational(x[1]), Rational(x[2]) };
    };
    const Vector origin = exact(t[0]);
    const Vector normal = Cross(Minus(exact(t[1]), origin), Minus(exact(t[2]), origin));
    if (Dot(Minus(exact(p), origin), normal) != 0)
    {
      return false;
    }
  }
  return true;
}

/** Each pair by itself has the curve that clipping one triangle with the other gives. */
void ExpectTheDefinition(const TriangleSoup& soup)
{
  Monitor monitor;
  for (const auto& pair : FindIntersections(soup.Points, soup.Triangles, monitor))
  {
    const IntersectionCurves curves =
      TraceIntersections(soup.Points, soup.Triangles, { pair }, monitor);
    const std::vector<Point> outline = CommonOutline(soup, pair[0], pair[1]);
    ASSERT_FALSE(outline.empty());
    // Around an area once, along a segment there and back.
    const double perimeter = Perimeter(outline);
    const double length = Length(curves);
    if (!InOnePlane(soup, pair[0], pair[1]))
    {
      ASSERT_NEAR(2 * length, perimeter, 1e-13) << pair[0] << ' ' << pair[1];
      ASSERT_EQ(curves.Points.size(), curves.Segments.size() + 1);
    }
    else
    {
      ASSERT_TRUE(std::abs(length - perimeter) < 1e-13 || std::abs(2 * length - perimeter) < 1e-13)
        << pair[0] << ' ' << pair[1];
    }
    const auto expected = std::minmax_element(outline.begin(), outline.end());
    const auto ends = std::minmax_element(curves.Points.begin(), curves.Points.end());
    ASSERT_LT(Distance(*ends.first, *expected.first), 1e-14);
    ASSERT_LT(Distance(*ends.second, *expected.second), 1e-14);
  }
}
} // namespace

TEST(IntersectionCurves, AreTheSegmentInWhichTwoFacetsCross)
{
  const IntersectionCurves curves =
    Trace({ { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, -1 }, { 1, 1, 1 }, { 9, 1, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } } });
  EXPECT_EQ(curves.Points, (std::vector<Point>{ { 1, 1, 0 }, { 3, 1, 0 } }));
  EXPECT_EQ(curves.Segments, (std::vector<std::array<Id, 2>>{ { 0, 1 } }));
}

TEST(IntersectionCurves, AreTheBoundaryOfAnOverlap)
{
  // A star of David, of which the hexagon is common.
  const IntersectionCurves curves =
    Trace({ { { 0, 0, 0 }, { 6, 0, 0 }, { 0, 6, 0 }, { 4, 4, 0 }, { -2, 4, 0 }, { 4, -2, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } } });
  EXPECT_EQ(curves.Points,
    (std::vector<Point>{
      { 0, 2, 0 }, { 0, 4, 0 }, { 2, 0, 0 }, { 2, 4, 0 }, { 4, 0, 0 }, { 4, 2, 0 } }));
  EXPECT_EQ(curves.Segments.size(), 6u);
}

TEST(IntersectionCurves, AreTheEdgesOfAFacetThatLiesInAnother)
{
  const IntersectionCurves curves =
    Trace({ { { 0, 0, 0 }, { 9, 0, 0 }, { 0, 9, 0 }, { 1, 1, 0 }, { 3, 1, 0 }, { 1, 3, 0 } },
      { { 0, 1, 2 }, { 3, 4, 5 } } });
  EXPECT_EQ(curves.Points, (std::vector<Point>{ { 1, 1, 0 }, { 1, 3, 0 }, { 3, 1, 0 } }));
  EXPECT_EQ(curves.Segments.size(), 3u);
}

TEST(IntersectionCurves, AreAPointWhereFacetsOnlyTouch)
{
  const TriangleSoup comb = Comb(5);
  const IntersectionCurves curves = Trace(comb);
  EXPECT_TRUE(curves.Segments.empty());
  ASSERT_EQ(curves.Points.size(), 5u);
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_EQ(curves.Points[i], comb.Points[3 + 3 * i]) << "the tip of tooth " << i;
  }
}

TEST(IntersectionCurves, AreTheDefinitionOnGridSoups)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    ExpectTheDefinition(GridSoup(seed, 30, 3));
    ExpectTheDefinition(GridSoup(seed, 30, 5));
  }
}

TEST(IntersectionCurves, AreTheDefinitionInOnePlane)
{
  Id pairs = 0;
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    // Raised into a slanted plane by their grid coordinates; what stood upright is left out.
    TriangleSoup flat = GridSoup(seed, 25, 5);
    for (Point& p : flat.Points)
    {
      p = { p[0], p[1] + 0.25 * p[2], 2 * p[0] + p[1] + 0.25 * p[2] };
    }
    flat = Merged(flat);
    std::vector<Triangle> facets;
    for (const Triangle& t : flat.Triangles)
    {
      if (!IsDegenerate(flat.Points[t[0]], flat.Points[t[1]], flat.Points[t[2]]))
      {
        facets.push_back(t);
      }
    }
    flat.Triangles = facets;
    Monitor monitor;
    pairs += static_cast<Id>(FindIntersections(flat.Points, flat.Triangles, monitor).size());
    ExpectTheDefinition(flat);
  }
  EXPECT_GT(pairs, 1000);
}

TEST(IntersectionCurves, AreTheDefinitionOnRandomSoups)
{
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    ExpectTheDefinition(RandomSoup(seed, 25));
  }
}

TEST(IntersectionCurves, CloseAroundSolidsThatOverlap)
{
  // Half-unit edges around the corner that either box has in the other.
  const TriangleSoup boxes =
    Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0.5, 0.5 }, { 1.5, 1.5, 1.5 }));
  const IntersectionCurves curves = Trace(boxes);
  EXPECT_DOUBLE_EQ(Length(curves), 3);
  std::vector<int> degree(curves.Points.size(), 0);
  for (const auto& segment : curves.Segments)
  {
    ++degree[segment[0]];
    ++degree[segment[1]];
  }
  EXPECT_EQ(degree, std::vector<int>(curves.Points.size(), 2));
}

TEST(IntersectionCurves, AreTheSameForAnyThreadCount)
{
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  const TriangleSoup soup = RandomSoup(3, 250);
  omp_set_num_threads(1);
  const IntersectionCurves one = Trace(soup);
  for (const int n : { 2, 8 })
  {
    omp_set_num_threads(n);
    const IntersectionCurves curves = Trace(soup);
    EXPECT_EQ(curves.Points, one.Points);
    EXPECT_EQ(curves.Segments, one.Segments);
  }
  omp_set_num_threads(threads);
  EXPECT_GT(one.Segments.size(), 300u);
}
