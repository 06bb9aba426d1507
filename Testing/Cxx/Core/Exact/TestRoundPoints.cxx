// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RoundPoints.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace testflips;

namespace
{
/** How far a point may go aside: 64 steps of 2^-52 along each axis, and rounding. */
constexpr double FarthestAside = 128 * 0x1p-52;

/** A mesh with points in sevenths of segments and facets, which are no doubles. */
MeshWithFacets WithExactPoints(unsigned seed)
{
  MeshWithFacets mesh = RandomMeshWithFacets(seed, 14, 6);
  std::mt19937 random(seed);
  for (int k = 0; k < 5; ++k)
  {
    const Id segment = static_cast<Id>(random() % static_cast<unsigned>(mesh.Segments.Size()));
    const std::vector<Id> path = mesh.Segments.Path(segment);
    mesh.SplitEdge(path[0], path[1]);
    const std::vector<Id> cells = FiniteCells(mesh.Mesh);
    mesh.SplitFace({ cells[random() % cells.size()], static_cast<int>(random() % 4) });
  }
  return mesh;
}

std::vector<Id> Unrounded(const FlippableMesh& mesh)
{
  std::vector<Id> points;
  for (Id p = mesh.Infinite() + 1; p < mesh.Vertices().Size(); ++p)
  {
    if (mesh.HasVertex(p) && !mesh.Vertices().IsDouble(p))
    {
      points.push_back(p);
    }
  }
  return points;
}

bool IsOnHull(const FlippableMesh& mesh, Id vertex)
{
  return mesh.FindEdge(vertex, mesh.Infinite()) != None;
}

/** Whether the squared distance of a point from a plane or line is that of rounding at most. */
bool IsBeside(const Rational& squaredDistance, const MeshRecord& record)
{
  Rational largest = 0;
  for (Id p = 0; p < record.Infinite; ++p)
  {
    for (const Rational& x : record.Places[p])
    {
      largest = std::max(largest, Rational(x * x));
    }
  }
  return squaredDistance <= Rational(FarthestAside) * Rational(FarthestAside) * 3 * largest;
}

/** Expect that the points of segments and facets lie on these up to rounding. */
void ExpectNearSurface(const MeshWithFacets& mesh)
{
  const MeshRecord record(mesh.Mesh);
  for (Id segment = 0; segment < mesh.Segments.Size(); ++segment)
  {
    const std::vector<Id> path = mesh.Segments.Path(segment);
    const Vector& a = record.Places[path.front()];
    const Vector along = testmeshes::Minus(record.Places[path.back()], a);
    for (const Id point : path)
    {
      const Vector aside = testmeshes::Cross(testmeshes::Minus(record.Places[point], a), along);
      EXPECT_TRUE(IsBeside(testmeshes::Dot(aside, aside) / testmeshes::Dot(along, along), record));
    }
  }
  for (const auto& [facet, faces] : FacesOfFacets(record))
  {
    const Triangle& t = mesh.Facets[facet];
    const Vector& a = record.Places[t[0]];
    const Vector normal = testmeshes::Cross(
      testmeshes::Minus(record.Places[t[1]], a), testmeshes::Minus(record.Places[t[2]], a));
    for (const Triangle& face : faces)
    {
      for (const Id point : face)
      {
        const Rational height = testmeshes::Dot(testmeshes::Minus(record.Places[point], a), normal);
        EXPECT_TRUE(IsBeside(height * height / testmeshes::Dot(normal, normal), record));
      }
    }
  }
}

/** Expect all laws, and the same faces between the same points. */
void ExpectRounded(
  const MeshWithFacets& mesh, const MeshRecord& before, const std::vector<Id>& left)
{
  ExpectFlippableMeshLaws(mesh.Mesh);
  EXPECT_EQ(Unrounded(mesh.Mesh), left);
  EXPECT_EQ(FacesOfFacets(MeshRecord(mesh.Mesh)), FacesOfFacets(before));
  EXPECT_EQ(
    ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), std::vector<std::string>());
  ExpectNearSurface(mesh);
  const MeshRecord after(mesh.Mesh);
  for (Id p = 0; p < before.Infinite; ++p)
  {
    EXPECT_TRUE(before.Places[p] == after.Places[p]) << "a given point moved";
  }
}

/**
 * A facet with a point within, its last vertex, between two tents of facets on its edges. The
 * tents' tips are the nearest doubles to the facet that are tried for the point, one on either
 * side, so none is between the tents.
 */
MeshWithFacets PointBetweenTents()
{
  std::vector<Point> points = { { { 1.1, 0.3, 0.7 } }, { { 0.2, 1.3, 0.9 } }, { { 0.4, 0.1, 1.7 } },
    { { 9, 6, 8 } }, { { -8, -5, -6 } } };
  const auto build = [&points](
                       const std::vector<Tetrahedron>& cells, const std::vector<Triangle>& facets)
  {
    MeshWithFacets mesh(MeshOfCells(points, cells), facets);
    mesh.SplitFace(mesh.Mesh.FindFaces({ { { 0, 1, 2 } } })[0]);
    return mesh;
  };
  const MeshWithFacets plain = build(Pyramids({ { { 0, 1, 2 } } }, { 3, 4 }), {});
  const Point nearest = plain.Mesh.Vertices().Nearest(plain.Mesh.Vertices().Size() - 1);
  constexpr double largest = 1.7;
  std::array<Rational, 2> least;
  std::array<Point, 2> tips;
  for (const double step : { 1.0, 8.0, 64.0 })
  {
    for (int k = 0; k < 27; ++k)
    {
      Point place = nearest;
      for (int axis = 0, rest = k; axis < 3; ++axis, rest /= 3)
      {
        place[axis] += (rest % 3 - 1) * step * std::ldexp(largest, -52);
      }
      const Rational height = SixfoldVolume(testmeshes::Exact(points[0]),
        testmeshes::Exact(points[1]), testmeshes::Exact(points[2]), testmeshes::Exact(place));
      EXPECT_NE(height, 0);
      const int side = height > 0 ? 0 : 1;
      const Rational distance = side == 0 ? height : Rational(-height);
      if (least[side] == 0 || distance < least[side])
      {
        least[side] = distance;
        tips[side] = place;
      }
    }
  }
  points.insert(points.end(), tips.begin(), tips.end());
  const bool isUp = SixfoldVolume(testmeshes::Exact(points[0]), testmeshes::Exact(points[1]),
                      testmeshes::Exact(points[2]), testmeshes::Exact(points[3])) > 0;
  std::vector<Tetrahedron> cells;
  std::vector<Triangle> facets = { { { 0, 1, 2 } } };
  for (const Id tip : { 5, 6 })
  {
    const Id beyond = (tip == 5) == isUp ? 3 : 4;
    const std::vector<Triangle> tent = { { { 0, 1, tip } }, { { 1, 2, tip } }, { { 2, 0, tip } } };
    const std::vector<Tetrahedron> outside = Pyramids(tent, { beyond });
    cells.insert(cells.end(), outside.begin(), outside.end());
    cells.push_back({ { 0, 1, 2, tip } });
    facets.insert(facets.end(), tent.begin(), tent.end());
  }
  return build(cells, facets);
}
} // namespace

TEST(RoundPoints, GivesExactPointsPlacesInDoublesBesideWhatTheyLieOn)
{
  std::size_t rounded = 0;
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    MeshWithFacets mesh = WithExactPoints(seed);
    const MeshRecord before(mesh.Mesh);
    const std::size_t count = Unrounded(mesh.Mesh).size();
    EXPECT_GT(count, 2u);
    const std::vector<Id> left = RoundInOrder(mesh);
    // Several points on one face of the hull may be in each other's way.
    for (const Id point : left)
    {
      EXPECT_TRUE(IsOnHull(mesh.Mesh, point)) << "seed " << seed;
    }
    ExpectRounded(mesh, before, left);
    rounded += count - left.size();
  }
  EXPECT_GT(rounded, 60u);
}

TEST(RoundPoints, PutsAPointOfASegmentWhereADoubleIsExactlyOnIt)
{
  MeshWithFacets mesh(MeshOfCells({ { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } },
                                    { { 2, 2, 9 } }, { { 3, 3, -9 } } },
                        Pyramids({ { { 0, 1, 2 } } }, { 3, 4 })),
    { { { 0, 1, 2 } }, { { 1, 2, 3 } } });
  const MeshRecord before(mesh.Mesh);
  const Id point = mesh.SplitEdge(1, 2);
  ASSERT_FALSE(mesh.Mesh.Vertices().IsDouble(point)) << "it is at three sevenths";
  EXPECT_TRUE(RoundInOrder(mesh).empty());
  EXPECT_EQ(mesh.Mesh.Vertices().Nearest(point), (Point{ { 4, 4, 0 } }));
  ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsAreas);
}

TEST(RoundPoints, APointThatHasNoPlaceIsReturnedAndLeftAsItIs)
{
  MeshWithFacets mesh = PointBetweenTents();
  const Id point = mesh.Mesh.Vertices().Size() - 1;
  ExpectFlippableMeshLaws(mesh.Mesh);
  ASSERT_EQ(Unrounded(mesh.Mesh), (std::vector<Id>{ point }));
  ASSERT_EQ(FacesOfFacets(MeshRecord(mesh.Mesh)).size(), 7u);
  const MeshRecord before(mesh.Mesh);
  EXPECT_EQ(RoundInOrder(mesh), (std::vector<Id>{ point }));
  ExpectUnchanged(mesh.Mesh, before);
}
