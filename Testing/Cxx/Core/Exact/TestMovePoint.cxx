// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/MovePoint.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace testflips;

namespace
{
/** An octahedron around vertex 0, in a larger one. */
MeshWithFacets TwoOctahedra(std::vector<Triangle> facets = {})
{
  std::vector<Point> points(1, { { 0, 0, 0 } });
  for (const double size : { 2.0, 9.0 })
  {
    for (int k = 0; k < 6; ++k)
    {
      points.push_back({ { 0, 0, 0 } });
      points.back()[k / 2] = k % 2 == 0 ? size : -size;
    }
  }
  return MeshWithFacets(DelaunayMesh(points), std::move(facets));
}

bool Move(MeshWithFacets& mesh, Id point, const Point& place)
{
  return MovePoint(mesh, point, place);
}

void ExpectRefused(MeshWithFacets mesh, Id point, const Point& place)
{
  const MeshRecord before(mesh.Mesh);
  EXPECT_FALSE(Move(mesh, point, place));
  ExpectUnchanged(mesh.Mesh, before);
}

/** Expect all laws, that nothing but the place of a point changed, and that this is there. */
void ExpectMoved(const MeshWithFacets& mesh, const MeshRecord& before, Id point, const Point& place)
{
  ExpectFlippableMeshLaws(mesh.Mesh);
  const MeshRecord after(mesh.Mesh);
  EXPECT_EQ(FacesOfFacets(before), FacesOfFacets(after));
  EXPECT_TRUE(mesh.Mesh.Vertices().IsDouble(point));
  EXPECT_EQ(mesh.Mesh.Vertices().Nearest(point), place);
  ASSERT_EQ(before.Places.size(), after.Places.size());
  for (Id vertex = 0; vertex < static_cast<Id>(after.Places.size()); ++vertex)
  {
    EXPECT_EQ(before.CellOf[vertex] == None, after.CellOf[vertex] == None);
    EXPECT_TRUE(vertex == point || before.Places[vertex] == after.Places[vertex]);
  }
}

/** Whether a place is within all cells around an inner point if that moves there. */
bool SeesStar(const FlippableMesh& mesh, Id point, const Point& place)
{
  const MeshRecord record(mesh);
  std::vector<Id> star;
  mesh.Star(point, star);
  return std::all_of(star.begin(), star.end(),
    [&](Id cell)
    {
      std::array<Vector, 4> at;
      for (int k = 0; k < 4; ++k)
      {
        const Id corner = record.Cells[cell].Corners[k];
        at[k] = corner == point ? testmeshes::Exact(place) : record.Places[corner];
      }
      return !record.IsInfinite(cell) && SixfoldVolume(at[0], at[1], at[2], at[3]) > 0;
    });
}
} // namespace

TEST(MovePoint, KeepsTheCellsAroundWhereTheNewPlaceSeesTheSame)
{
  MeshWithFacets mesh = TwoOctahedra({ { { 0, 1, 3 } }, { { 1, 3, 5 } }, { { 1, 7, 3 } } });
  const MeshRecord before(mesh.Mesh);
  const Point place = { { 0.25, 0.5, 0.75 } };
  ASSERT_TRUE(SeesStar(mesh.Mesh, 0, place));
  EXPECT_TRUE(Move(mesh, 0, place));
  EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(), before.FiniteCells());
  ExpectMoved(mesh, before, 0, place);
}

TEST(MovePoint, GoesOverAFaceIntoOtherCells)
{
  MeshWithFacets mesh = TwoOctahedra({ { { 2, 4, 6 } }, { { 7, 9, 11 } } });
  const MeshRecord before(mesh.Mesh);
  const Point place = { { 1, 1, 1 } };
  ASSERT_FALSE(SeesStar(mesh.Mesh, 0, place));
  EXPECT_TRUE(Move(mesh, 0, place));
  ExpectMoved(mesh, before, 0, place);
  EXPECT_FALSE(mesh.Mesh.FindFaces({ { { 1, 3, 5 } } })[0].Cell != None);
}

TEST(MovePoint, GoesOverNoFacet)
{
  ExpectRefused(TwoOctahedra({ { { 1, 3, 5 } } }), 0, { { 1, 1, 1 } });
  ExpectRefused(TwoOctahedra({ { { 0, 2, 4 } }, { { 1, 3, 5 } } }), 0, { { 1, 1, 1 } });
}

TEST(MovePoint, GoesNowhereBeyondTheHullOrOntoAVertexOrInfinitelyFar)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Point& place : { Point{ { 5, 5, 5 } }, Point{ { 2, 0, 0 } }, Point{ { 9, 0, 0 } },
         Point{ { 3, 3, 3 } }, Point{ { infinity, 0, 0 } }, Point{ { 0, std::nan(""), 0 } } })
  {
    ExpectRefused(TwoOctahedra(), 0, place);
  }
}

TEST(MovePoint, AVertexOfTheHullMovesWhereTheHullStaysConvex)
{
  // Inward as far as the tip is one, outward as long as no face turns into a dent.
  for (const double height : { 3.0, 8.5, 9.5, 40.0 })
  {
    MeshWithFacets mesh = TwoOctahedra();
    const MeshRecord before(mesh.Mesh);
    const Id tip = 11;
    ASSERT_EQ(mesh.Mesh.Vertices().Nearest(tip), (Point{ { 0, 0, 9 } }));
    const Point place = { { 0, 0, height } };
    EXPECT_TRUE(Move(mesh, tip, place)) << height;
    ExpectMoved(mesh, before, tip, place);
  }
  ExpectRefused(TwoOctahedra(), 11, { { 0, 0, -1 } });
  ExpectRefused(TwoOctahedra(), 11, { { 9, 9, 0 } });
}

TEST(MovePoint, APointOnAFaceOfTheHullMovesAlongItAndNotInward)
{
  // The face 0 1 2 3 of a cube, and a point on it.
  const auto cube = []()
  {
    std::vector<Point> points;
    for (int k = 0; k < 8; ++k)
    {
      points.push_back({ { 8.0 * (k & 1), 8.0 * (k >> 1 & 1), 8.0 * (k >> 2) } });
    }
    points.push_back({ { 3, 4, 0 } });
    points.push_back({ { 4, 3, 4 } });
    return MeshWithFacets(DelaunayMesh(points), {});
  };
  for (const Point& place : { Point{ { 5, 2, 0 } }, Point{ { 3, 4, -1 } } })
  {
    MeshWithFacets mesh = cube();
    const MeshRecord before(mesh.Mesh);
    EXPECT_TRUE(Move(mesh, 8, place));
    ExpectMoved(mesh, before, 8, place);
  }
  ExpectRefused(cube(), 8, { { 3, 4, 1 } });
  ExpectRefused(cube(), 8, { { 0, 4, 0 } });
}

TEST(MovePoint, APointWithinAFacetTakesItsFacesAlong)
{
  MeshWithFacets mesh = TwoOctahedra({ { { 0, 1, 3 } }, { { 0, 3, 5 } } });
  const Id point = mesh.SplitFace(mesh.Mesh.FindFaces({ { { 0, 1, 3 } } })[0]);
  EXPECT_FALSE(mesh.Mesh.Vertices().IsDouble(point));
  const MeshRecord before(mesh.Mesh);
  const Point place = { { 0.5, 0.25, 0 } };
  EXPECT_TRUE(Move(mesh, point, place));
  ExpectMoved(mesh, before, point, place);
  ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsAreas);
  // Beyond an edge of the facet, or onto the other facet.
  ExpectRefused(mesh, point, { { 1.5, 1.5, 0 } });
  ExpectRefused(mesh, point, { { 0, 0.25, 0.25 } });
}

TEST(MovePoint, WhereverAPointIsMovedTheMeshHoldsOrIsAsBefore)
{
  int moved = 0;
  int far = 0;
  int refused = 0;
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 18, 8);
    std::mt19937 random(seed);
    for (int k = 0; k < 16; ++k)
    {
      const Id point = static_cast<Id>(random() % 18);
      const std::vector<Id> cells = FiniteCells(mesh.Mesh);
      // In a cell near by, or anywhere.
      std::vector<Id> star;
      mesh.Mesh.Star(point, star);
      const Id cell = k % 2 == 0 ? cells[random() % cells.size()] : star[random() % star.size()];
      Point place = { { 0, 0, 0 } };
      for (const Id corner : CellAt(mesh.Mesh, cell).Corners)
      {
        const Point at =
          mesh.Mesh.Vertices().Nearest(corner == mesh.Mesh.Infinite() ? point : corner);
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += at[axis] / 4;
        }
      }
      const MeshRecord before(mesh.Mesh);
      const bool seesStar = SeesStar(mesh.Mesh, point, place);
      const bool isMoved = Move(mesh, point, place);
      EXPECT_TRUE(isMoved || !seesStar);
      if (!isMoved)
      {
        ++refused;
        ExpectUnchanged(mesh.Mesh, before);
        continue;
      }
      (seesStar ? moved : far) += 1;
      ExpectMoved(mesh, before, point, place);
      EXPECT_EQ(
        ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), std::vector<std::string>());
    }
  }
  EXPECT_GT(moved, 10);
  EXPECT_GT(far, 5);
  EXPECT_GT(refused, 20);
}

TEST(MovePoint, CollapsesAPointIntoANeighborThatSeesAllAround)
{
  for (Id neighbor = 1; neighbor <= 6; ++neighbor)
  {
    MeshWithFacets mesh = TwoOctahedra({ { { 1, 3, 5 } } });
    const MeshRecord before(mesh.Mesh);
    EXPECT_TRUE(CollapsePoint(mesh, 0, { neighbor }));
    EXPECT_FALSE(mesh.Mesh.HasVertex(0));
    EXPECT_NE(mesh.Mesh.FindEdge(neighbor, neighbor % 2 == 1 ? neighbor + 1 : neighbor - 1), None);
    ExpectFlippableMeshLaws(mesh.Mesh, before);
  }
}

TEST(MovePoint, CollapsesNoPointOfAFacetOrOfTheHull)
{
  MeshWithFacets mesh = TwoOctahedra({ { { 0, 1, 3 } } });
  const MeshRecord before(mesh.Mesh);
  for (Id neighbor = 1; neighbor <= 6; ++neighbor)
  {
    EXPECT_FALSE(CollapsePoint(mesh, 0, { neighbor }));
    EXPECT_FALSE(CollapsePoint(mesh, neighbor + 6, { neighbor }));
  }
  ExpectUnchanged(mesh.Mesh, before);
}

TEST(MovePoint, CollapsingAnyPointKeepsTheRest)
{
  int collapsed = 0;
  int refused = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 18, 16);
    std::set<Id> fixed;
    for (const Triangle& facet : mesh.Facets)
    {
      fixed.insert(facet.begin(), facet.end());
    }
    for (Id point = 0; point < mesh.Mesh.Infinite(); ++point)
    {
      if (fixed.count(point) > 0)
      {
        continue;
      }
      for (Id neighbor = 0; neighbor < mesh.Mesh.Infinite() && mesh.Mesh.HasVertex(point);
           ++neighbor)
      {
        if (mesh.Mesh.FindEdge(point, neighbor) == None || neighbor == point)
        {
          continue;
        }
        const MeshRecord before(mesh.Mesh);
        if (CollapsePoint(mesh, point, { neighbor }))
        {
          EXPECT_FALSE(mesh.Mesh.HasVertex(point));
          ExpectFlippableMeshLaws(mesh.Mesh, before);
          EXPECT_EQ(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets),
            std::vector<std::string>());
          ++collapsed;
        }
        else
        {
          ExpectUnchanged(mesh.Mesh, before);
          ++refused;
        }
      }
    }
  }
  EXPECT_GT(collapsed, 5);
  EXPECT_GT(refused, 20);
}
