// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/StraightCaps.h"

#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "HullMesh.h"
#include "Support/TestMeshes.h"
#include "Support/WindingNumberInQuads.h"
#include "WindingNumber/WindingNumberOfCells.h"
#include "WindingNumber/WindingNumberSum.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

namespace
{
using namespace insideout;
using testmeshes::WindingNumberInQuads;

HullMesh Meshed(const TriangleSoup& soup)
{
  Monitor monitor;
  return MeshHull(soup, {}, monitor);
}

struct Found
{
  std::vector<Point> Points;
  StraightCaps Caps;
};

Found CapsOf(const HullMesh& hull)
{
  Found found;
  found.Points = ScaledPoints(hull.Mesh.Points, -LargestExponent(hull.Mesh.Points));
  const std::vector<CountedEdge> boundary =
    CountedBoundary(CountedFacets(hull.Surface), static_cast<Id>(hull.Surface.Points.size()));
  const ChainOfFacets chain = FaceCounts(hull.Surface, hull.Mesh).Chain();
  found.Caps = FindStraightCaps(hull.Surface, found.Points, chain, boundary);
  return found;
}

/** The faces that the stage's values are of. */
FacetComplex Faces(const HullMesh& hull)
{
  FacetComplex faces;
  faces.Points = hull.Mesh.Points;
  for (const CountedTriangle& face : FaceCounts(hull.Surface, hull.Mesh).Chain().Triangles)
  {
    faces.Facets.push_back(face.Corners);
    faces.Multiplicity.push_back(static_cast<std::int16_t>(face.Count));
  }
  faces.NumberOfConstraints = faces.NumberOfFacets();
  return faces;
}

/** What all caps have to be, whatever the surface. */
void ExpectLaws(const HullMesh& hull, const Found& found)
{
  const StraightCaps& caps = found.Caps;
  const std::vector<Point>& points = found.Points;
  const ChainOfFacets chain = FaceCounts(hull.Surface, hull.Mesh).Chain();
  EXPECT_EQ(caps.Pieces.size() + caps.Rest.size(), chain.Triangles.size());
  for (const StraightCap& cap : caps.Caps)
  {
    // Pieces less triangle and slivers have no boundary.
    std::vector<CountedTriangle> closed = { { cap.Whole.Corners, -cap.Whole.Count } };
    closed.insert(closed.end(), caps.Pieces.begin() + static_cast<std::ptrdiff_t>(cap.FirstPiece),
      caps.Pieces.begin() + static_cast<std::ptrdiff_t>(cap.LastPiece));
    for (std::size_t i = cap.FirstSliver; i < cap.LastSliver; ++i)
    {
      closed.push_back({ caps.Slivers[i].Corners, -caps.Slivers[i].Count });
    }
    // Degenerate slivers are left out, which may leave edges on one line, but none elsewhere.
    for (const CountedEdge& edge : CountedBoundary(closed, static_cast<Id>(points.size())))
    {
      const auto onSide = [&](Id p)
      {
        double nearest = 1;
        for (int k = 0; k < 3; ++k)
        {
          const Point& a = points[cap.Whole.Corners[k]];
          const Point& b = points[cap.Whole.Corners[(k + 1) % 3]];
          nearest = std::min(nearest, Length(NormalOf(a, b, points[p])) / Length(Difference(a, b)));
        }
        return nearest < ReachOfStraightCap;
      };
      EXPECT_TRUE(onSide(edge.From) && onSide(edge.To));
    }
    // And none of their corners is farther above the triangle than it says.
    const auto [a, b, c] = CornersOf(points, cap.Whole.Corners);
    const Point normal = NormalOf(a, b, c);
    for (const CountedTriangle& triangle : closed)
    {
      for (const Id p : triangle.Corners)
      {
        const double height = std::abs(Dot(Difference(points[p], a), normal)) / Length(normal);
        EXPECT_LE(height, cap.Height + 0x1p-48);
        EXPECT_LT(height, ReachOfStraightCap);
      }
    }
  }
}

TEST(StraightCaps, StandInForAllPiecesOfARandomSoup)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const HullMesh hull = Meshed(testmeshes::RandomSoup(seed, 30));
    const Found found = CapsOf(hull);
    ExpectLaws(hull, found);
    EXPECT_EQ(found.Caps.Caps.size(), 30u);
    EXPECT_TRUE(found.Caps.Rest.empty());
  }
}

TEST(StraightCaps, KeepTheirLawsWhereEverythingIsDegenerate)
{
  std::size_t caps = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const HullMesh hull = Meshed(testmeshes::GridSoup(seed, 40, 2 + static_cast<int>(seed % 5)));
    const Found found = CapsOf(hull);
    ExpectLaws(hull, found);
    caps += found.Caps.Caps.size();
  }
  EXPECT_GT(caps, 0u);
}

TEST(StraightCaps, AreNotFoundWhereNothingIsOpen)
{
  const TriangleSoup boxes = testmeshes::Join(
    testmeshes::Box({ 0, 0, 0 }, { 2, 2, 2 }), testmeshes::Box({ 1, 1, 1 }, { 3, 3, 3 }));
  const Found found = CapsOf(Meshed(boxes));
  EXPECT_TRUE(found.Caps.Caps.empty());
  EXPECT_FALSE(found.Caps.Rest.empty());
}

TEST(StraightCaps, AreNotFoundWhereFacetsSayNoSources)
{
  HullMesh hull = Meshed(testmeshes::RandomSoup(1, 10));
  hull.Surface.SourceOffsets = { 0 };
  hull.Surface.Sources.clear();
  EXPECT_TRUE(CapsOf(hull).Caps.Caps.empty());
  Monitor monitor;
  const std::vector<double> w = WindingNumberOfCells(hull.Surface, hull.Mesh, monitor);
  for (std::size_t cell = 0; cell < w.size(); ++cell)
  {
    EXPECT_NEAR(w[cell], hull.W[cell], 1e-13);
  }
}

/** Largest difference to sums with many digits, in cells of which each number-th is taken. */
double ErrorToManyDigits(const HullMesh& hull, std::size_t number)
{
  const FacetComplex faces = Faces(hull);
  const Sites sites = { hull.Mesh.Points, hull.Mesh.Cells };
  double error = 0;
  for (std::size_t cell = 0; cell < hull.Mesh.Cells.size(); cell += number)
  {
    error = std::max(error, std::abs(hull.W[cell] - WindingNumberInQuads(faces, sites[cell])));
  }
  return error;
}

TEST(StraightCaps, GiveCellsTheWindingNumbersOfTheirPieces)
{
  std::vector<TriangleSoup> soups = { testmeshes::RandomSoup(7, 40), testmeshes::GridSoup(3, 60, 4),
    testmeshes::Fan(12), testmeshes::ThroughOnePoint(2, 12), testmeshes::Comb(9),
    testmeshes::Join(
      testmeshes::Box({ 0.2, 0.2, 0.2 }, { 0.8, 0.7, 0.6 }), testmeshes::RandomSoup(9, 20)) };
  for (const TriangleSoup& soup : soups)
  {
    const HullMesh hull = Meshed(soup);
    Monitor monitor;
    const std::vector<double> sum =
      WindingNumberSum(Faces(hull), { hull.Mesh.Points, hull.Mesh.Cells }, monitor);
    double error = 0;
    for (std::size_t cell = 0; cell < sum.size(); ++cell)
    {
      error = std::max(error, std::abs(hull.W[cell] - sum[cell]));
    }
    EXPECT_LT(error, 1e-12);
    EXPECT_LT(ErrorToManyDigits(hull, 1 + sum.size() / 200), 1e-13);
  }
}

TEST(StraightCaps, CountAsOftenAsTheirTriangles)
{
  HullMesh hull = Meshed(testmeshes::RandomSoup(5, 25));
  for (std::int16_t& count : hull.Surface.Multiplicity)
  {
    count = static_cast<std::int16_t>(-3 * count);
  }
  Monitor monitor;
  const std::vector<double> w = WindingNumberOfCells(hull.Surface, hull.Mesh, monitor);
  for (std::size_t cell = 0; cell < w.size(); ++cell)
  {
    EXPECT_NEAR(w[cell], -3 * hull.W[cell], 1e-12);
  }
}

TEST(StraightCaps, GiveTheSameForAnyNumberOfThreads)
{
  const HullMesh hull = Meshed(testmeshes::RandomSoup(11, 50));
  Monitor monitor;
  const int threads = omp_get_max_threads();
  for (const int number : { 1, 2, 5 })
  {
    omp_set_num_threads(number);
    EXPECT_EQ(WindingNumberOfCells(hull.Surface, hull.Mesh, monitor), hull.W);
  }
  omp_set_num_threads(threads);
}
} // namespace
