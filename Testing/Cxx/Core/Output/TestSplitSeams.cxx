// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/SplitSeams.h"

#include "HullMesh.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace
{
using namespace insideout;
using namespace testmeshes;

constexpr ProgressRange All = { "extracting", 0, 1 };

/** Every triangle with points of its own. */
TriangleSoup Torn(const TriangleSoup& soup)
{
  TriangleSoup torn;
  for (const Triangle& t : soup.Triangles)
  {
    const Id n = static_cast<Id>(torn.Points.size());
    torn.Triangles.push_back({ n, n + 1, n + 2 });
    for (const Id p : t)
    {
      torn.Points.push_back(soup.Points[p]);
    }
  }
  return torn;
}

struct Solid
{
  HullMesh Hull;
  std::vector<BoundaryTriangle> Boundary;
  std::vector<Triangle> Given;
};

/** The cells with w above 1/2. */
Solid MakeSolid(const TriangleSoup& soup)
{
  Monitor monitor;
  HullMeshParameters parameters;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  Solid solid;
  solid.Hull = MeshHull(soup, parameters, monitor);
  std::vector<unsigned char> inside;
  for (const double w : solid.Hull.W)
  {
    inside.push_back(w > 0.5);
  }
  solid.Boundary = BoundaryTriangles(solid.Hull.Surface, solid.Hull.Mesh,
    BoundaryFaces(solid.Hull.Mesh, inside, monitor, All), monitor, All);
  solid.Given = TrianglesInMesh(soup, solid.Hull.MergedInto, solid.Hull.Mesh.Origins);
  return solid;
}

SeamedSurface SplitSeams(const Solid& solid, const TriangleSoup& soup, const std::vector<Id>& alike)
{
  Monitor monitor;
  return SplitSeams(solid.Boundary, soup, solid.Given, alike, solid.Hull.Mesh, monitor, All);
}

/** A number for each input triangle, or box side, and a place: linear in the place. */
double Value(Id gradient, const Point& p)
{
  return 10.0 * gradient + (1 + gradient % 3) * p[0] + (2 - gradient % 5) * p[1] +
    (gradient % 7) * p[2];
}

/** Two boxes that cross, the second one slanted, a side having two triangles in a row. */
TriangleSoup CrossingBoxes()
{
  TriangleSoup second = Box({ 0.3, 0.4, -0.2 }, { 0.9, 1.7, 0.7 });
  for (Point& p : second.Points)
  {
    p = { { p[0] + 0.2 * p[1] - 0.1 * p[2], p[1] + 0.3 * p[2], p[2] - 0.15 * p[0] } };
  }
  return Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), second);
}

/** Whether corners have their triangle's value, all data being linear over `perGradient`
 * triangles. */
void CheckValues(const TriangleSoup& soup, Id perGradient, const std::vector<Id>& alike)
{
  const Solid solid = MakeSolid(soup);
  ASSERT_GT(solid.Boundary.size(), 24u);
  const SeamedSurface seamed = SplitSeams(solid, soup, alike);
  std::vector<double> data(soup.Points.size());
  for (Id t = 0; t < static_cast<Id>(soup.Triangles.size()); ++t)
  {
    for (const Id p : soup.Triangles[t])
    {
      data[p] = Value(t / perGradient, soup.Points[p]);
    }
  }
  std::set<std::pair<Id, Id>> expected; // places by gradient
  ASSERT_EQ(seamed.Triangles.size(), solid.Boundary.size());
  for (std::size_t t = 0; t < solid.Boundary.size(); ++t)
  {
    const Id gradient = solid.Boundary[t].Source / perGradient;
    for (int k = 0; k < 3; ++k)
    {
      const Id point = seamed.Triangles[t][k];
      const Id place = seamed.Places[point];
      EXPECT_EQ(place, solid.Boundary[t].Corners[k]);
      const PointOrigin& origin = seamed.Origins[point];
      double value = 0;
      for (int i = 0; i < 3; ++i)
      {
        value += origin.Weights[i] * data[origin.Points[i]];
      }
      EXPECT_NEAR(value, Value(gradient, solid.Hull.Mesh.Points[place]), 1e-12);
      expected.insert({ place, gradient });
    }
  }
  EXPECT_EQ(seamed.Places.size(), expected.size());
  EXPECT_TRUE(std::is_sorted(seamed.Places.begin(), seamed.Places.end()));
}

TEST(SplitSeams, GivesEachTriangleTheDataOfItsOwnInputTriangle)
{
  const TriangleSoup soup = Torn(CrossingBoxes());
  std::vector<Id> alike(soup.Points.size());
  std::iota(alike.begin(), alike.end(), 0);
  CheckValues(soup, 1, alike);
}

/** A torn surface with two triangles a side: points of one side at one place are alike. */
std::vector<Id> AlikeBySides(const TriangleSoup& soup)
{
  std::vector<Id> alike(soup.Points.size());
  for (Id p = 0; p < static_cast<Id>(alike.size()); ++p)
  {
    alike[p] = p;
    for (Id q = p / 6 * 6; q < p; ++q)
    {
      alike[p] = alike[p] == p && soup.Points[q] == soup.Points[p] ? q : alike[p];
    }
  }
  return alike;
}

TEST(SplitSeams, SharesPointsWhereTheDataAreAlike)
{
  const TriangleSoup soup = Torn(CrossingBoxes());
  CheckValues(soup, 2, AlikeBySides(soup));
}

TEST(SplitSeams, SplitsAnEdgeWhoseDataAreAlikeAtOneEndOnly)
{
  const TriangleSoup soup = Torn(CrossingBoxes());
  std::vector<Id> alike = AlikeBySides(soup);
  for (std::size_t side = 0; side < alike.size(); side += 6)
  {
    for (std::size_t p = side, ends = 0; p < side + 6; ++p)
    {
      const bool isSecondEnd = alike[p] != static_cast<Id>(p) && ends++ == 1;
      alike[p] = isSecondEnd ? static_cast<Id>(p) : alike[p];
    }
  }
  const Solid solid = MakeSolid(soup);
  const SeamedSurface seamed = SplitSeams(solid, soup, alike);
  std::map<std::pair<Id, Id>, Id> points; // by place and input triangle
  for (std::size_t t = 0; t < solid.Boundary.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      points[{ solid.Boundary[t].Corners[k], solid.Boundary[t].Source }] = seamed.Triangles[t][k];
    }
  }
  int onDiagonals = 0;
  int shared = 0;
  for (const auto& [key, point] : points)
  {
    const auto other = points.find({ key.first, key.second ^ 1 }); // of the same side
    if (other != points.end())
    {
      const bool isNew = !solid.Hull.Mesh.Origins[key.first].IsInput();
      onDiagonals += isNew;
      shared += other->second == point;
      EXPECT_FALSE(isNew && other->second == point);
    }
  }
  EXPECT_GT(onDiagonals, 0);
  EXPECT_GT(shared, 0);
}

TEST(SplitSeams, ChangesNothingWhereAllIsAlike)
{
  const TriangleSoup soup = Torn(Box({ 0, 0, 0 }, { 1, 1, 1 }));
  const Solid solid = MakeSolid(soup);
  const SeamedSurface seamed = SplitSeams(solid, soup, solid.Hull.MergedInto);
  EXPECT_EQ(seamed.Places, std::vector<Id>({ 0, 1, 2, 3, 4, 5, 6, 7 }));
  for (std::size_t t = 0; t < solid.Boundary.size(); ++t)
  {
    EXPECT_EQ(seamed.Triangles[t], solid.Boundary[t].Corners);
  }
}

TEST(SplitSeams, TakesTheLowestTrianglesPointsWhereAHoleIsClosed)
{
  TriangleSoup soup = Torn(Box({ 0, 0, 0 }, { 1, 1, 1 }));
  soup.Triangles.erase(soup.Triangles.begin() + 2, soup.Triangles.begin() + 4); // the lid
  const Solid solid = MakeSolid(soup);
  std::vector<Id> alike(soup.Points.size());
  std::iota(alike.begin(), alike.end(), 0);
  const SeamedSurface seamed = SplitSeams(solid, soup, alike);
  ASSERT_EQ(solid.Boundary.size(), 12u);
  EXPECT_EQ(seamed.Places.size(), 30u) << "the lid adds no point";
  int closing = 0;
  for (std::size_t t = 0; t < solid.Boundary.size(); ++t)
  {
    closing += solid.Boundary[t].Source == None;
    for (const Id p : seamed.Triangles[t])
    {
      EXPECT_TRUE(seamed.Origins[p].IsInput());
    }
  }
  EXPECT_EQ(closing, 2);
}

TEST(SplitSeams, CanBeStopped)
{
  const TriangleSoup soup = Torn(CrossingBoxes());
  const Solid solid = MakeSolid(soup);
  const std::vector<Id> alike = AlikeBySides(soup);
  const int reports = StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
    { SplitSeams(solid.Boundary, soup, solid.Given, alike, solid.Hull.Mesh, monitor, range); });
  EXPECT_EQ(reports, 2) << "before sorting, and in the loop";
}
} // namespace
