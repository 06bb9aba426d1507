// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/ConstrainedDelaunay.h"

#include "Support/MeshLaws.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

using namespace insideout;

namespace
{
TetrahedralMesh Mesh(const FacetComplex& surface)
{
  Monitor monitor;
  return ConstrainedDelaunay(surface, monitor);
}

/** Tetrahedralize and prove everything that a mesh must hold, no facet lost. */
TetrahedralMesh CheckedMesh(const TriangleSoup& soup)
{
  const FacetComplex surface = testmeshes::ToComplex(soup);
  const TetrahedralMesh mesh = Mesh(surface);
  testmeshes::ExpectMeshLaws(surface, mesh);
  EXPECT_TRUE(mesh.LostFacets.empty());
  return mesh;
}

TriangleSoup UnitBox()
{
  return testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 });
}

void ExpectError(const FacetComplex& surface, ErrorCode code, const std::string& message)
{
  try
  {
    Mesh(surface);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code);
    EXPECT_EQ(std::string(error.what()), message);
  }
}

/** Small random triangles, one in each cell of a grid, so that none meet. */
TriangleSoup ScatteredTriangles(unsigned seed, int perAxis)
{
  std::mt19937 random(seed);
  const auto next = [&](int cell) { return cell + 0.1 + 0.8 * (random() / 4294967296.0); };
  TriangleSoup soup;
  for (int i = 0; i < perAxis * perAxis * perAxis; ++i)
  {
    const Id first = static_cast<Id>(soup.Points.size());
    for (int k = 0; k < 3; ++k)
    {
      const double x = next(i % perAxis);
      const double y = next(i / perAxis % perAxis);
      const double z = next(i / perAxis / perAxis);
      soup.Points.push_back({ { x, y, z } });
    }
    soup.Triangles.push_back({ { first, first + 1, first + 2 } });
  }
  return soup;
}

/** A box whose sides are grids of n by n squares: many coplanar facets, cospherical points. */
TriangleSoup GridBox(int n)
{
  TriangleSoup box;
  std::map<Point, Id> ids;
  const auto id = [&](Point p)
  {
    const auto inserted = ids.insert({ p, static_cast<Id>(box.Points.size()) });
    if (inserted.second)
    {
      box.Points.push_back(p);
    }
    return inserted.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, n })
    {
      for (int u = 0; u < n; ++u)
      {
        for (int v = 0; v < n; ++v)
        {
          const auto at = [&](int a, int b)
          {
            Point p;
            p[axis] = side;
            p[(axis + 1) % 3] = a;
            p[(axis + 2) % 3] = b;
            return id(p);
          };
          Triangle first = { { at(u, v), at(u + 1, v), at(u + 1, v + 1) } };
          Triangle second = { { at(u, v), at(u + 1, v + 1), at(u, v + 1) } };
          if (side == 0)
          {
            std::swap(first[1], first[2]);
            std::swap(second[1], second[2]);
          }
          box.Triangles.push_back(first);
          box.Triangles.push_back(second);
        }
      }
    }
  }
  return box;
}

/** Schoenhardt's polyhedron: no tetrahedra without a Steiner point. */
TriangleSoup Schoenhardt()
{
  TriangleSoup soup;
  for (int k = 0; k < 6; ++k)
  {
    const double angle = 2 * M_PI * (k % 3) / 3 + (k < 3 ? 0 : M_PI / 6);
    soup.Points.push_back({ { std::cos(angle), std::sin(angle), k < 3 ? 0.0 : 1.0 } });
  }
  soup.Triangles = { { { 0, 2, 1 } }, { { 3, 4, 5 } } };
  for (Id k = 0; k < 3; ++k)
  {
    // The reflex diagonal of each side.
    const Id next = (k + 1) % 3;
    soup.Triangles.push_back({ { k, next, k + 3 } });
    soup.Triangles.push_back({ { next, next + 3, k + 3 } });
  }
  return soup;
}

/** Triangles around one edge. */
TriangleSoup Fan(int leaves)
{
  TriangleSoup soup;
  soup.Points = { { { 0, 0, 0 } }, { { 0, 0, 1 } } };
  for (int k = 0; k < leaves; ++k)
  {
    const double angle = 2 * M_PI * k / leaves;
    soup.Points.push_back({ { std::cos(angle), std::sin(angle), 0.5 } });
    soup.Triangles.push_back({ { 0, 1, k + 2 } });
  }
  return soup;
}

TriangleSoup Scaled(TriangleSoup soup, int exponent)
{
  for (Point& p : soup.Points)
  {
    for (double& x : p)
    {
      x = std::ldexp(x, exponent);
    }
  }
  return soup;
}
} // namespace

TEST(ConstrainedDelaunay, FillsABox)
{
  const TetrahedralMesh mesh = CheckedMesh(UnitBox());
  EXPECT_EQ(mesh.NumberOfSteinerPoints, 0);
  EXPECT_EQ(mesh.Points.size(), 8u);
}

TEST(ConstrainedDelaunay, KeepsNestedBoxes)
{
  CheckedMesh(testmeshes::Join(UnitBox(),
    testmeshes::Join(testmeshes::Box({ 0.25, 0.25, 0.25 }, { 0.75, 0.75, 0.75 }),
      testmeshes::Reversed(testmeshes::Box({ 0.375, 0.375, 0.375 }, { 0.5, 0.5, 0.5 })))));
}

TEST(ConstrainedDelaunay, KeepsBoxesApart)
{
  CheckedMesh(testmeshes::Join(UnitBox(), testmeshes::Box({ 3, 0.25, 0.25 }, { 3.5, 7, 0.75 })));
}

TEST(ConstrainedDelaunay, FillsTheHullOfAnOpenBox)
{
  for (std::size_t face = 0; face < 12; ++face)
  {
    TriangleSoup box = UnitBox();
    box.Triangles.erase(box.Triangles.begin() + static_cast<std::ptrdiff_t>(face));
    CheckedMesh(box);
    box.Triangles.resize(5);
    CheckedMesh(box);
  }
}

TEST(ConstrainedDelaunay, KeepsScatteredTriangles)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    CheckedMesh(ScatteredTriangles(seed, 6));
  }
}

TEST(ConstrainedDelaunay, KeepsASingleTriangleAmongPoints)
{
  TriangleSoup soup = testmeshes::RandomSoup(3, 20);
  soup.Triangles.resize(1);
  CheckedMesh(soup);
}

TEST(ConstrainedDelaunay, PutsASteinerPointIntoSchoenhardtsPolyhedron)
{
  for (const bool turned : { false, true })
  {
    TriangleSoup soup = Schoenhardt();
    if (turned)
    {
      for (Point& p : soup.Points)
      {
        p[1] = -p[1];
      }
    }
    const TetrahedralMesh mesh = CheckedMesh(soup);
    EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 0);
  }
}

TEST(ConstrainedDelaunay, KeepsFansAroundAnEdge)
{
  for (const int leaves : { 3, 4, 5, 8, 17 })
  {
    CheckedMesh(Fan(leaves));
  }
}

TEST(ConstrainedDelaunay, KeepsADanglingTriangle)
{
  TriangleSoup soup = UnitBox();
  soup.Points.push_back({ { 0.5, -2, 0.5 } });
  soup.Points.push_back({ { 0.25, 0.5, 0.5 } });
  soup.Triangles.push_back({ { 0, 1, 8 } });
  soup.Triangles.push_back({ { 0, 4, 9 } });
  CheckedMesh(soup);
}

TEST(ConstrainedDelaunay, KeepsCoplanarFacetsApart)
{
  for (const int n : { 2, 3, 6 })
  {
    CheckedMesh(GridBox(n));
  }
}

TEST(ConstrainedDelaunay, TakesACubeWhoseFirstPointsAreCoplanar)
{
  // On eight points in every order of two axes; without a tolerance TetGen starts with a flat cell.
  std::mt19937 random(5);
  for (int run = 0; run < 30; ++run)
  {
    TriangleSoup box = UnitBox();
    std::array<Id, 8> order = { { 0, 1, 2, 3, 4, 5, 6, 7 } };
    std::shuffle(order.begin(), order.end(), random);
    const std::vector<Point> points = box.Points;
    for (std::size_t p = 0; p < 8; ++p)
    {
      box.Points[static_cast<std::size_t>(order[p])] = points[p];
    }
    for (Triangle& t : box.Triangles)
    {
      t = { { order[t[0]], order[t[1]], order[t[2]] } };
    }
    CheckedMesh(box);
  }
}

TEST(ConstrainedDelaunay, KeepsPointsThatNoFacetUses)
{
  TriangleSoup soup = UnitBox();
  soup.Points.insert(soup.Points.begin() + 3, { { { 0.5, 0.25, 0.75 } } });
  for (Triangle& t : soup.Triangles)
  {
    for (Id& p : t)
    {
      p += p >= 3;
    }
  }
  soup.Points.push_back({ { 4, 4, 4 } });
  CheckedMesh(soup);
}

TEST(ConstrainedDelaunay, KeepsTheIdsWhereAnUnusedPointRepeatsAnother)
{
  TriangleSoup soup = UnitBox();
  soup.Points.push_back(soup.Points[2]);
  soup.Points.push_back({ { -0.0, 0.0, -0.0 } });
  const TetrahedralMesh mesh = CheckedMesh(soup);
  EXPECT_TRUE(std::signbit(mesh.Points[9][0]));
}

TEST(ConstrainedDelaunay, KeepsPointsHoweverNear)
{
  TriangleSoup soup = UnitBox();
  const double step = std::numeric_limits<double>::epsilon();
  for (const double x : { 0.5, 0.5 + step, 0.5 + 2 * step, 0.5 + 1e-12, 0.5 + 1e-9 })
  {
    soup.Points.push_back({ { x, 0.5, 0.5 } });
  }
  soup.Triangles.push_back({ { 8, 0, 4 } });
  CheckedMesh(soup);
}

TEST(ConstrainedDelaunay, LeavesFacetsBehindTheConstraintsOut)
{
  TriangleSoup soup = UnitBox();
  soup.Points.push_back({ { 0.5, 0.5, 2 } });
  soup.Points.push_back({ { 0.5, 0.25, -1 } });
  soup.Points.push_back({ { 0.75, 0.25, 2 } });
  soup.Triangles.push_back({ { 8, 9, 10 } });
  FacetComplex surface = testmeshes::ToComplex(soup);
  surface.NumberOfConstraints = 12;
  const TetrahedralMesh mesh = Mesh(surface);
  testmeshes::ExpectMeshLaws(surface, mesh);
  EXPECT_TRUE(mesh.LostFacets.empty());
}

TEST(ConstrainedDelaunay, NeedsNoConstraint)
{
  FacetComplex surface = testmeshes::ToComplex(testmeshes::RandomSoup(4, 50));
  surface.NumberOfConstraints = 0;
  const TetrahedralMesh mesh = Mesh(surface);
  testmeshes::ExpectMeshLaws(surface, mesh);
  EXPECT_EQ(mesh.NumberOfSteinerPoints, 0);
}

TEST(ConstrainedDelaunay, WorksAtEverySizeAndPlace)
{
  const TetrahedralMesh unit = CheckedMesh(ScatteredTriangles(9, 3));
  for (const int exponent : { -900, -100, -20, 20, 100, 900 })
  {
    const TetrahedralMesh mesh = CheckedMesh(Scaled(ScatteredTriangles(9, 3), exponent));
    EXPECT_EQ(mesh.Cells, unit.Cells) << exponent;
  }
  const double far = 1e12;
  CheckedMesh(testmeshes::Box({ far, far, far }, { far + 1, far + 1, far + 1 }));
  CheckedMesh(testmeshes::Box({ 0, 0, 0 }, { 1e6, 1, 1e-3 }));
}

TEST(ConstrainedDelaunay, GivesTheSameTwice)
{
  const FacetComplex surface = testmeshes::ToComplex(ScatteredTriangles(11, 6));
  const TetrahedralMesh first = Mesh(surface);
  const TetrahedralMesh second = Mesh(surface);
  EXPECT_EQ(first.Points, second.Points);
  EXPECT_EQ(first.Cells, second.Cells);
  EXPECT_EQ(first.Neighbors, second.Neighbors);
  EXPECT_EQ(first.Facets, second.Facets);
  EXPECT_EQ(first.FacetSides, second.FacetSides);
}

TEST(ConstrainedDelaunay, NeverTakesTheCallerDownWhereFacetsCross)
{
  for (unsigned seed = 1; seed <= 25; ++seed)
  {
    const FacetComplex surface = testmeshes::ToComplex(testmeshes::GridSoup(seed, 12, 4));
    // Crossing facets may make TetGen loop: a second is as good as for ever.
    class Patience : public Monitor
    {
      bool Continue(const char*, double fraction) override { return fraction < 0.999; }
    } monitor;
    try
    {
      const TetrahedralMesh mesh = ConstrainedDelaunay(surface, monitor);
      testmeshes::ExpectMeshLaws(surface, mesh);
    }
    catch (const Error& error)
    {
      EXPECT_TRUE(error.Code == ErrorCode::TetrahedralizerDied ||
        error.Code == ErrorCode::TetrahedralizerFailed || error.Code == ErrorCode::Inconsistent ||
        error.Code == ErrorCode::Stopped)
        << error.what();
    }
  }
}

TEST(ConstrainedDelaunay, RefusesASurfaceWithoutFacets)
{
  TriangleSoup soup = UnitBox();
  soup.Triangles.clear();
  ExpectError(testmeshes::ToComplex(soup), ErrorCode::EmptySurface, "the surface has no facet");
}

TEST(ConstrainedDelaunay, NamesAPointThatIsNotFinite)
{
  for (const double bad : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    TriangleSoup soup = UnitBox();
    soup.Points[5][1] = bad;
    ExpectError(testmeshes::ToComplex(soup), ErrorCode::PointNotFinite, "point 5 is not finite");
  }
}

TEST(ConstrainedDelaunay, NamesAFacetWithAPointOutOfRange)
{
  for (const Id bad : { -1, 8, INT32_MAX })
  {
    TriangleSoup soup = UnitBox();
    soup.Triangles[7][2] = bad;
    ExpectError(testmeshes::ToComplex(soup), ErrorCode::PointOutOfRange,
      "facet 7 refers to point " + std::to_string(bad) + " of 8");
  }
}

TEST(ConstrainedDelaunay, SaysThatAllFacetsLieInOnePlane)
{
  TriangleSoup soup;
  soup.Points = { { { 0, 0, 0 } }, { { 0, 0, 0 } }, { { 1, 0, 1 } }, { { 2, 0, 2 } },
    { { 0, 1, 0 } }, { { 3, 7, 3 } }, { { 1e-9, -4, 1e-9 } } };
  soup.Triangles = { { { 0, 2, 4 } }, { { 3, 5, 6 } } };
  ExpectError(testmeshes::ToComplex(soup), ErrorCode::Planar,
    "all facets lie in one plane, so there is no volume to fill");
  // One bit makes it a volume: an exact decision.
  soup.Points[6][0] = std::nextafter(1e-9, 1);
  try
  {
    Mesh(testmeshes::ToComplex(soup));
  }
  catch (const Error& error)
  {
    EXPECT_NE(error.Code, ErrorCode::Planar);
  }
  soup.Points.resize(4);
  soup.Triangles = { { { 0, 2, 3 } } };
  ExpectError(testmeshes::ToComplex(soup), ErrorCode::Planar,
    "all facets lie on one line, so there is no volume to fill");
  soup.Points.resize(2);
  soup.Triangles = { { { 0, 1, 1 } } };
  ExpectError(testmeshes::ToComplex(soup), ErrorCode::Planar,
    "all facets lie at one point, so there is no volume to fill");
}
