// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ThickenFacets.h"

#include "Common/Box.h"
#include "Common/Vectors.h"
#include "HullMesh.h"
#include "Output/Outliers.h"
#include "Support/TestMeshes.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace insideout;
using namespace testmeshes;

HullMesh Hull(const TriangleSoup& soup, double width, bool all = false)
{
  Monitor monitor;
  HullMeshParameters parameters;
  parameters.Thicken.Width = width;
  parameters.Thicken.All = all;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  return MeshHull(soup, parameters, monitor);
}

/** The volume where w is above 1/2. */
double Solid(const HullMesh& hull)
{
  double solid = 0;
  for (std::size_t cell = 0; cell < hull.W.size(); ++cell)
  {
    const std::array<Point, 4> c = CornersOf(hull.Mesh.Points, hull.Mesh.Cells[cell]);
    const double sixfold =
      Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0]));
    solid += hull.W[cell] > 0.5 ? std::abs(sixfold) / 6 : 0;
  }
  return solid;
}

/** Whether no facet is an outlier where w is above 1/2 inside. */
testing::AssertionResult KeepsAllFacets(const HullMesh& hull)
{
  std::vector<unsigned char> inside;
  for (const double w : hull.W)
  {
    inside.push_back(w > 0.5);
  }
  Monitor monitor;
  const auto outliers =
    OutlierPieces(hull.Surface, hull.Mesh, inside, monitor, { "extracting", 0, 1 });
  return (outliers.empty() ? testing::AssertionSuccess() : testing::AssertionFailure())
    << outliers.size() << " outliers";
}

TriangleSoup Square(Point corner, Point u, Point v)
{
  TriangleSoup soup;
  for (int i = 0; i < 4; ++i)
  {
    const double a = i == 1 || i == 2;
    const double b = i >= 2;
    soup.Points.push_back({ corner[0] + a * u[0] + b * v[0], corner[1] + a * u[1] + b * v[1],
      corner[2] + a * u[2] + b * v[2] });
  }
  soup.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return soup;
}

/** A ball of facets, or the part of it below a height. */
TriangleSoup Ball(int around, double height)
{
  TriangleSoup ball;
  const double pi = std::acos(-1);
  const auto index = [&](int i, int j) { return static_cast<Id>(j * around + i % around); };
  for (int j = 0; j <= around / 2; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double a = 2 * pi * i / around;
      const double b = pi * j / (around / 2);
      const double r = j == 0 || j == around / 2 ? 0 : std::sin(b);
      ball.Points.push_back({ r * std::cos(a), r * std::sin(a), -std::cos(b) });
    }
  }
  for (int j = 0; j < around / 2; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      if (ball.Points[index(i, j + 1)][2] <= height)
      {
        ball.Triangles.push_back({ index(i, j), index(i, j + 1), index(i + 1, j + 1) });
        ball.Triangles.push_back({ index(i, j), index(i + 1, j + 1), index(i + 1, j) });
      }
    }
  }
  return ball;
}

TEST(ThickenFacets, MakesASlabOfAPlaneSheet)
{
  const HullMesh hull = Hull(Square({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 }), 0.25);
  EXPECT_NEAR(Solid(hull), 6 * 0.25, 1e-12);
  EXPECT_TRUE(IsClosed(hull.Surface));
  EXPECT_TRUE(KeepsAllFacets(hull));
  const auto box = BoundingBox(hull.Mesh.Points);
  EXPECT_EQ(box.Low[2], -0.125);
  EXPECT_EQ(box.High[2], 0.125);
}

TEST(ThickenFacets, LeavesWhatEnclosesSomething)
{
  const TriangleSoup cube = testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 });
  EXPECT_NEAR(Solid(Hull(cube, 0.1)), 1, 1e-12);
  EXPECT_NEAR(Solid(Hull(cube, 0)), 1, 1e-12);
  // With all facets thickened its corners reach 1.73 times half the width outward.
  EXPECT_NEAR(Solid(Hull(cube, 0.1, true)), 1.1 * 1.1 * 1.1, 1e-9);
}

TEST(ThickenFacets, JoinsASheetToWhatItTouches)
{
  const TriangleSoup soup = Join(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }),
    Square({ 0.5, 0.25, 0.5 }, { 2, 0, 0 }, { 0, 0.5, 0 }));
  const HullMesh hull = Hull(soup, 0.125);
  EXPECT_NEAR(Solid(hull), 1 + 1.5 * 0.5 * 0.125, 1e-12);
  EXPECT_TRUE(KeepsAllFacets(hull));
}

TEST(ThickenFacets, KeepsTheWidthWhereASheetBends)
{
  // A half sphere, as thick as a tenth of its radius.
  const TriangleSoup bowl = Ball(48, -0.3);
  const HullMesh hull = Hull(bowl, 0.1);
  double area = 0;
  for (const Triangle& t : bowl.Triangles)
  {
    const Point n = Cross(Difference(bowl.Points[t[1]], bowl.Points[t[0]]),
      Difference(bowl.Points[t[2]], bowl.Points[t[0]]));
    area += Length(n) / 2;
  }
  EXPECT_NEAR(Solid(hull) / (area * 0.1), 1, 0.01);
  EXPECT_TRUE(KeepsAllFacets(hull));
}

TEST(ThickenFacets, TakesSheetsThatBranchFoldAndCross)
{
  // Three squares at one edge, two of them in one plane, which share corners of their slabs; a
  // fold; and a square through all of it.
  TriangleSoup soup = Join(
    Square({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), Square({ 0, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }));
  soup = Join(soup, Square({ 0, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 }));
  soup = Join(soup, Square({ 1, 0, 0 }, { -0.5, 0, 0.8 }, { 0, 1, 0 }));
  soup = Join(soup, Square({ -2, 0.5, -2 }, { 4, 0, 0 }, { 0, 0.1, 4 }));
  const HullMesh hull = Hull(soup, 0.05);
  EXPECT_TRUE(IsClosed(hull.Surface));
  EXPECT_TRUE(KeepsAllFacets(hull));
  const double whole = (1 + 1 + 1 + std::hypot(0.5, 0.8) + 4 * std::hypot(0.1, 4)) * 0.05;
  EXPECT_GT(Solid(hull), 0.9 * whole);
  EXPECT_LT(Solid(hull), 1.02 * whole);
}

TEST(ThickenFacets, ThickensWhatIsGivenFromBothSides)
{
  const TriangleSoup square = Square({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 });
  const TriangleSoup other = Reversed(square);
  TriangleSoup both = square;
  both.Triangles.insert(both.Triangles.end(), other.Triangles.begin(), other.Triangles.end());
  EXPECT_NEAR(Solid(Hull(both, 0.25)), 1.5, 1e-12);
}

TEST(ThickenFacets, ComesFromTheFacetsAndPointsThatItThickens)
{
  const TriangleSoup square = Square({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 });
  Monitor monitor;
  FacetComplex surface = CountFacets(square, {}, monitor).Surface;
  EXPECT_EQ(ThickenFacets(surface, { 1, 1 }, { 0.5, false }, monitor), 2);
  EXPECT_EQ(surface.Points.size(), 12u);
  EXPECT_EQ(surface.NumberOfFacets(), 2 + 4 + 16);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    ASSERT_EQ(surface.SourceOffsets[f + 1] - surface.SourceOffsets[f], 1);
    EXPECT_LT(surface.Sources[f].Triangle, 2);
    EXPECT_EQ(surface.Multiplicity[f] == 0, f < 2);
  }
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    EXPECT_EQ(surface.Origins[p].IsInput(), p < 4);
    const Point& from = square.Points[surface.Origins[p].Points[0]];
    EXPECT_EQ(surface.Points[p][0], from[0]);
    EXPECT_EQ(surface.Points[p][1], from[1]);
  }
}

TEST(ThickenFacets, DoesNotDependOnSize)
{
  const TriangleSoup bowl = Ball(12, -0.3);
  Monitor monitor;
  FacetComplex expected = CountFacets(bowl, {}, monitor).Surface;
  const std::vector<char> isSheet(expected.Facets.size(), 1);
  ThickenFacets(expected, isSheet, { 0.125, false }, monitor);
  for (const double scale : { 0x1p-600, 0x1p+900 })
  {
    TriangleSoup scaled = bowl;
    for (Point& p : scaled.Points)
    {
      p = { p[0] * scale, p[1] * scale, p[2] * scale };
    }
    FacetComplex surface = CountFacets(scaled, {}, monitor).Surface;
    ThickenFacets(surface, isSheet, { 0.125 * scale, false }, monitor);
    ASSERT_EQ(surface.Facets, expected.Facets);
    for (std::size_t p = 0; p < surface.Points.size(); ++p)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(surface.Points[p][axis] / scale, expected.Points[p][axis], 1e-14);
      }
    }
  }
}

TEST(ThickenFacets, RefusesWidthsThatMakeNoSense)
{
  Monitor monitor;
  FacetComplex surface =
    CountFacets(Square({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 3, 0 }), {}, monitor).Surface;
  for (const double width : { -1.0, 1e-12, std::nan(""), HUGE_VAL })
  {
    EXPECT_THROW(ThickenFacets(surface, { 1, 1 }, { width, false }, monitor), Error) << width;
  }
  EXPECT_EQ(ThickenFacets(surface, { 1, 1 }, { 0, true }, monitor), 0);
}
} // namespace
