// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactTetrahedralization.h"

#include "AssembleMesh.h"
#include "CountedChain.h"
#include "MeshLaws.h"
#include "ResolveSelfIntersections.h"
#include "TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace insideout;

namespace
{
/** Tetrahedralize and prove everything that a mesh must hold, whatever is lost. */
TetrahedralMesh LawfulMesh(const FacetComplex& surface, bool isValid = true)
{
  Monitor monitor;
  const std::vector<Triangle> facets(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  const ExactTetrahedralization exact = TetrahedralizeExactly(surface.Points, facets, monitor);
  const TetrahedralMesh mesh =
    AssembleMesh(surface, { exact.Points, exact.Cells, exact.Faces, exact.FacetOfFaces }, monitor);
  testmeshes::ExpectMeshLaws(surface, mesh);
  if (isValid)
  {
    EXPECT_EQ(mesh.LostFacets, exact.LostFacets);
    EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, exact.NumberOfSurfaceSteinerPoints);
  }
  return mesh;
}

TetrahedralMesh CompleteMesh(const FacetComplex& surface)
{
  const TetrahedralMesh mesh = LawfulMesh(surface);
  EXPECT_TRUE(mesh.LostFacets.empty());
  return mesh;
}

TetrahedralMesh CompleteMesh(const TriangleSoup& soup)
{
  return CompleteMesh(testmeshes::ToComplex(soup));
}

/** The surface that the stages before this one make of a soup. */
FacetComplex Resolved(const TriangleSoup& soup)
{
  Monitor monitor;
  return ResolveSelfIntersections(CountFacets(soup, {}, monitor).Surface, monitor).Surface;
}

/** A prism whose top is turned against its bottom, with the sides bent inward. */
TriangleSoup TwistedPrism(int sides, double turn)
{
  TriangleSoup soup;
  const Id n = sides;
  for (Id k = 0; k < 2 * n; ++k)
  {
    const double angle = 2 * M_PI * (k % n) / n + (k < n ? 0 : turn);
    soup.Points.push_back({ { std::cos(angle), std::sin(angle), k < n ? 0.0 : 1.0 } });
  }
  for (Id k = 0; k < n; ++k)
  {
    const Id next = (k + 1) % n;
    soup.Triangles.push_back({ { k, next, k + n } });
    soup.Triangles.push_back({ { next, next + n, k + n } });
    if (k > 0 && k + 1 < n)
    {
      soup.Triangles.push_back({ { 0, next, k } });
      soup.Triangles.push_back({ { n, k + n, next + n } });
    }
  }
  return soup;
}

/**
 * Chazelle's polyhedron: a box into which notches are cut from below and from above, down to a
 * hyperbolic paraboloid from its two sides. Only the notches' ridges and their sides are here.
 */
TriangleSoup Chazelle(int notches)
{
  TriangleSoup soup;
  const double gap = 1.0 / 64;
  for (int k = 0; k < 2 * notches; ++k)
  {
    const bool below = k < notches;
    const double at = k % notches + 0.5;
    const double end = notches;
    const double surface = (below ? -gap : gap);
    const double far = below ? -1.0 - end * end : 1.0 + end * end;
    const Id first = static_cast<Id>(soup.Points.size());
    // The ridge lies on z = x y: along x below, along y above.
    for (const double along : { 0.0, end })
    {
      const double z = at * along + surface;
      const auto place = [&](double aside, double height) -> Point {
        return below ? Point{ { along, at + aside, height } }
                     : Point{ { at + aside, along, height } };
      };
      soup.Points.push_back(place(0, z));
      soup.Points.push_back(place(-0.25, far));
      soup.Points.push_back(place(0.25, far));
    }
    for (const Id side : { 1, 2 })
    {
      soup.Triangles.push_back({ { first, first + 3, first + 3 + side } });
      soup.Triangles.push_back({ { first, first + 3 + side, first + side } });
    }
  }
  return soup;
}

/** Sheets one above the other, one unit in the last place apart, each triangulated another way. */
TriangleSoup NearSheets(unsigned seed, int sheets, int size)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  double z = 1;
  for (int sheet = 0; sheet < sheets; ++sheet)
  {
    const Id first = static_cast<Id>(soup.Points.size());
    for (int k = 0; k < (size + 1) * (size + 1); ++k)
    {
      soup.Points.push_back(
        { { static_cast<double>(k % (size + 1)), static_cast<double>(k / (size + 1)), z } });
    }
    for (int k = 0; k < size * size; ++k)
    {
      const Id a = first + k % size + (size + 1) * (k / size);
      const Id b = a + 1;
      const Id c = a + size + 1;
      const Id d = c + 1;
      if (random() % 2 == 0)
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, d } }, { { a, d, c } } });
      }
      else
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, c } }, { { b, d, c } } });
      }
    }
    z = std::nextafter(z, 2);
  }
  soup.Points.push_back({ { 0.5, 0.5, 2 } });
  return soup;
}

/** A sphere's points in rings on which many lie on one circle, joined to facets at random. */
TriangleSoup RingedSphere(unsigned seed, int rings)
{
  std::mt19937 random(seed);
  TriangleSoup soup;
  const int around = 12;
  for (int r = 0; r < rings; ++r)
  {
    const double height = -0.9 + 1.8 * r / (rings - 1);
    for (int k = 0; k < around; ++k)
    {
      const double angle = 2 * M_PI * k / around;
      const double radius = std::sqrt(1 - height * height);
      soup.Points.push_back({ { radius * std::cos(angle), radius * std::sin(angle), height } });
    }
  }
  for (int r = 0; r + 1 < rings; ++r)
  {
    for (int k = 0; k < around; ++k)
    {
      const Id a = r * around + k;
      const Id b = r * around + (k + 1) % around;
      const Id c = a + around;
      const Id d = b + around;
      if (random() % 2 == 0)
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, d } }, { { a, d, c } } });
      }
      else
      {
        soup.Triangles.insert(soup.Triangles.end(), { { { a, b, c } }, { { b, d, c } } });
      }
    }
  }
  return soup;
}
} // namespace

TEST(ExactTetrahedralization, FillsABox)
{
  const TetrahedralMesh mesh = CompleteMesh(testmeshes::Box({ 0, 0, 0 }, { 1, 2, 3 }));
  EXPECT_EQ(mesh.NumberOfSteinerPoints, 0);
}

TEST(ExactTetrahedralization, FillsNestedAndTouchingBoxes)
{
  const TriangleSoup nested = testmeshes::Join(testmeshes::Box({ 0, 0, 0 }, { 8, 8, 8 }),
    testmeshes::Join(
      testmeshes::Box({ 1, 1, 1 }, { 7, 7, 7 }), testmeshes::Box({ 2, 2, 2 }, { 6, 6, 6 })));
  CompleteMesh(nested);
  CompleteMesh(Resolved(testmeshes::Join(nested, testmeshes::Box({ 8, 2, 2 }, { 9, 5, 5 }))));
  CompleteMesh(Resolved(testmeshes::Join(nested, testmeshes::Box({ 3, 3, 3 }, { 12, 5, 9 }))));
}

TEST(ExactTetrahedralization, KeepsASingleFacetAndPointsBesideIt)
{
  TriangleSoup soup;
  soup.Points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } }, { { 1, 1, 2 } },
    { { 1, 1, -2 } }, { { 1, 1, 1 } }, { { 1, 1, -1 } } };
  soup.Triangles = { { { 0, 1, 2 } } };
  CompleteMesh(soup);
}

TEST(ExactTetrahedralization, FillsSchoenhardtsPolyhedron)
{
  for (const double turn : { 0.1, M_PI / 6, 1.0, -0.1, -M_PI / 6 })
  {
    CompleteMesh(Resolved(TwistedPrism(3, turn)));
  }
  const TetrahedralMesh mesh = CompleteMesh(TwistedPrism(3, -M_PI / 6));
  EXPECT_GE(mesh.NumberOfSteinerPoints, 1);
  EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 0);
}

TEST(ExactTetrahedralization, FillsTwistedPrisms)
{
  for (int sides = 4; sides < 24; sides += 3)
  {
    CompleteMesh(Resolved(TwistedPrism(sides, M_PI / sides)));
  }
}

TEST(ExactTetrahedralization, FillsChazellesPolyhedron)
{
  CompleteMesh(Resolved(Chazelle(2)));
  CompleteMesh(Resolved(Chazelle(5)));
}

TEST(ExactTetrahedralization, FillsCosphericalPoints)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    CompleteMesh(Resolved(RingedSphere(seed, 6)));
  }
}

TEST(ExactTetrahedralization, KeepsTheLawsOnNearlyCoincidentSheets)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    LawfulMesh(testmeshes::ToComplex(NearSheets(seed, 3, 3)));
  }
}

TEST(ExactTetrahedralization, KeepsEveryFacetOfResolvedSoups)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    CompleteMesh(Resolved(testmeshes::RandomSoup(seed, 20)));
    CompleteMesh(Resolved(testmeshes::GridSoup(seed, 20, 4)));
  }
}

TEST(ExactTetrahedralization, ListsFacetsThatCross)
{
  TriangleSoup soup;
  soup.Points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 4, 0 } }, { { 1, 1, -1 } },
    { { 1, 1, 1 } }, { { 5, 5, 0.5 } } };
  soup.Triangles = { { { 0, 1, 2 } }, { { 3, 4, 5 } } };
  EXPECT_FALSE(LawfulMesh(testmeshes::ToComplex(soup), false).LostFacets.empty());
  EXPECT_FALSE(
    LawfulMesh(testmeshes::ToComplex(testmeshes::RandomSoup(1, 20)), false).LostFacets.empty());
}

TEST(ExactTetrahedralization, RefusesPointsInAPlane)
{
  Monitor monitor;
  try
  {
    TetrahedralizeExactly(
      { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } } }, {}, monitor);
    FAIL() << "a flat mesh";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Planar);
  }
}

TEST(ExactTetrahedralization, GivesTheSameEachTime)
{
  const FacetComplex surface = Resolved(testmeshes::RandomSoup(3, 40));
  Monitor monitor;
  const ExactTetrahedralization first =
    TetrahedralizeExactly(surface.Points, surface.Facets, monitor);
  const ExactTetrahedralization second =
    TetrahedralizeExactly(surface.Points, surface.Facets, monitor);
  EXPECT_EQ(first.Points, second.Points);
  EXPECT_EQ(first.Cells, second.Cells);
  EXPECT_EQ(first.Faces, second.Faces);
}

TEST(ExactTetrahedralization, StopsWhenAsked)
{
  struct Stopper : Monitor
  {
    bool Continue(const char*, double) override { return --this->Left > 0; }
    int Left = 0;
  };
  const FacetComplex surface = Resolved(testmeshes::RandomSoup(5, 40));
  for (int checks = 1; checks < 6; ++checks)
  {
    Stopper stopper;
    stopper.Left = checks;
    EXPECT_THROW(TetrahedralizeExactly(surface.Points, surface.Facets, stopper), Error);
  }
}
