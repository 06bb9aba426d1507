// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/FlippableMesh.h"

#include "Common/Team.h"
#include "Support/AllowedThreads.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace testflips;

namespace
{
/** Points on a sphere and its center, which has an edge to each: stars of all sizes. */
std::vector<Point> BallWithCentre(int size)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<Point> points(1, { { 0, 0, 0 } });
  for (int k = 0; k < size; ++k)
  {
    Point p = { { normal(random), normal(random), normal(random) } };
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p)
    {
      x /= length;
    }
    points.push_back(p);
  }
  return points;
}
} // namespace

TEST(FlippableMesh, FindsAnEdgeWhereAndOnlyWhereACellHasBothEnds)
{
  Monitor monitor;
  WorkBudget work;
  std::vector<Id> same;
  const FlippableMesh mesh(BallWithCentre(150), same, work, monitor);
  std::set<std::array<Id, 2>> edges;
  for (Id id = 0; id < NumberOfCells(mesh); ++id)
  {
    const FlippableCell& cell = CellAt(mesh, id);
    for (int i = 0; !mesh.IsDead(id) && i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        edges.insert({ { cell.Corners[i], cell.Corners[j] } });
      }
    }
  }
  int found = 0;
  for (Id u = 0; u <= mesh.Infinite(); ++u)
  {
    for (Id v = 0; v <= mesh.Infinite(); ++v)
    {
      const Id cell = mesh.FindEdge(u, v);
      ASSERT_EQ(cell != None, edges.count({ { u, v } }) > 0) << u << ' ' << v;
      if (cell != None)
      {
        ++found;
        ASSERT_TRUE(mesh.Has(cell, u) && mesh.Has(cell, v));
      }
    }
  }
  EXPECT_EQ(found, static_cast<int>(edges.size()));
}

TEST(FlippableMesh, FindsManyEdgesAsItFindsEachAloneOnAnyNumberOfThreads)
{
  Monitor monitor;
  WorkBudget work;
  std::vector<Id> same;
  const FlippableMesh mesh(BallWithCentre(600), same, work, monitor);
  std::vector<std::array<Id, 2>> pairs;
  std::vector<char> expected;
  const std::int64_t before = work.Spent();
  for (Id u = 0; u <= mesh.Infinite(); ++u)
  {
    for (Id v = 0; v <= mesh.Infinite(); v += 7)
    {
      pairs.push_back({ { u, v } });
      expected.push_back(mesh.FindEdge(u, v) != None);
    }
  }
  const std::int64_t spent = work.Spent() - before;
  const WholeTeams teams;
  for (const int threads : { 1, 2, 8 })
  {
    const testthreads::Allowed allowed(threads);
    const std::int64_t begin = work.Spent();
    EXPECT_EQ(mesh.HasEdges(pairs), expected);
    EXPECT_EQ(work.Spent() - begin, spent);
  }
}

TEST(FlippableMesh, FindsManyFacesAsItFindsEachAlone)
{
  Monitor monitor;
  WorkBudget work;
  std::vector<Id> same;
  const FlippableMesh mesh(BallWithCentre(40), same, work, monitor);
  std::vector<Triangle> triangles;
  for (Id a = 0; a < mesh.Infinite(); ++a)
  {
    for (Id b = 0; b < a; ++b)
    {
      for (Id c = 0; c < b; ++c)
      {
        triangles.push_back({ { b, a, c } });
        triangles.push_back({ { c, b, a } });
      }
    }
  }
  const std::vector<MeshFace> together = mesh.FindFaces(triangles);
  ASSERT_EQ(together.size(), triangles.size());
  int found = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& t = triangles[i];
    Id cell;
    int face;
    const bool isFace = mesh.FindFace(t[0], t[1], t[2], cell, face);
    for (const MeshFace& one : { together[i], mesh.FindFaces({ t })[0] })
    {
      ASSERT_EQ(one.Cell != None, isFace) << t[0] << ' ' << t[1] << ' ' << t[2];
      for (const Id corner : t)
      {
        ASSERT_TRUE(!isFace || mesh.Has(one.Cell, corner));
        ASSERT_TRUE(!isFace || CellAt(mesh, one.Cell).Corners[one.Face] != corner);
      }
    }
    found += isFace ? 1 : 0;
  }
  // Each cell has four faces, each shared by two cells, so each occurs twice; infinite ones are
  // left out.
  int faces = 0;
  for (Id cell = 0; cell < NumberOfCells(mesh); ++cell)
  {
    faces += mesh.IsDead(cell) ? 0 : mesh.IsInfinite(cell) ? 1 : 4;
  }
  EXPECT_EQ(found, faces);
}

namespace
{
/** Two cells on a triangle. */
FlippableMesh Bipyramid()
{
  return MeshOfCells(
    { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } }, { { 2, 2, 9 } }, { { 3, 3, -9 } } },
    Pyramids({ { { 0, 1, 2 } } }, { 3, 4 }));
}

/** Three cells around an edge in the place of the two. */
std::vector<Tetrahedron> ThreeCells()
{
  return { { { 4, 3, 0, 1 } }, { { 4, 3, 1, 2 } }, { { 4, 3, 2, 0 } } };
}

/** The cells of the faces of a cube around its center. */
FlippableMesh Cube()
{
  std::vector<Point> points(1, { { 4, 4, 4 } });
  for (int k = 0; k < 8; ++k)
  {
    points.push_back({ { 8.0 * (k & 1), 8.0 * (k >> 1 & 1), 8.0 * (k >> 2) } });
  }
  return DelaunayMesh(points);
}
} // namespace

TEST(FlippableMesh, BeginsWithCellsWhoseSpheresAreEmpty)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const FlippableMesh mesh = DelaunayMesh(AnyPoints(seed, 20));
    ExpectFlippableMeshLaws(mesh);
    const MeshRecord record(mesh);
    for (const Id cell : FiniteCells(mesh))
    {
      // Squared distances from a point, interpolated there, are at most 0 outside the sphere.
      const Tetrahedron& t = CellAt(mesh, cell).Corners;
      for (Id p = 0; p < mesh.Infinite(); ++p)
      {
        Rational sum = 0;
        for (int k = 0; k < 4; ++k)
        {
          const Vector from = testmeshes::Minus(record.Places[t[k]], record.Places[p]);
          Tetrahedron other = t;
          other[k] = p;
          sum += testmeshes::Dot(from, from) *
            SixfoldVolume(record.Places[other[0]], record.Places[other[1]], record.Places[other[2]],
              record.Places[other[3]]);
        }
        ASSERT_LE(sum, 0) << "seed " << seed << ": " << p << " is in the sphere of cell " << cell;
      }
    }
  }
}

TEST(FlippableMesh, LetsTheFirstOfEqualPointsStandForAll)
{
  std::vector<Point> points = AnyPoints(2, 8);
  points.push_back(points[3]);
  points.push_back(points[5]);
  points.push_back(points[3]);
  Monitor monitor;
  WorkBudget work;
  std::vector<Id> same;
  const FlippableMesh mesh(points, same, work, monitor);
  EXPECT_EQ(same, (std::vector<Id>{ 0, 1, 2, 3, 4, 5, 6, 7, 3, 5, 3 }));
  for (Id p = 0; p < 11; ++p)
  {
    EXPECT_EQ(mesh.HasVertex(p), p < 8);
  }
  ExpectFlippableMeshLaws(mesh);
}

TEST(FlippableMesh, RefusesPointsInOnePlane)
{
  try
  {
    DelaunayMesh({ { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 0, 1, 1 } }, { { 1, 1, 1 } } });
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Planar);
  }
}

TEST(FlippableMesh, ReplacesTwoCellsByThreeAndBack)
{
  FlippableMesh mesh = Bipyramid();
  const MeshRecord before(mesh);
  const std::set<Tetrahedron> two = { { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } } };
  ASSERT_EQ(before.FiniteCells(), two);
  mesh.Replace(FiniteCells(mesh), ThreeCells());
  EXPECT_EQ(MeshRecord(mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 3, 4 } }, { { 1, 2, 3, 4 } }, { { 0, 2, 3, 4 } } }));
  ExpectFlippableMeshLaws(mesh, before);
  mesh.Replace(FiniteCells(mesh), { { { 0, 1, 2, 3 } }, { { 1, 0, 2, 4 } } });
  EXPECT_EQ(MeshRecord(mesh).FiniteCells(), two);
  ExpectFlippableMeshLaws(mesh, before);
}

TEST(FlippableMesh, ReplacingKeepsFacetsOnTheBoundaryAndDropsInnerOnes)
{
  FlippableMesh mesh = Bipyramid();
  Id number = 0;
  for (const Triangle& t :
    { Triangle{ { 0, 1, 2 } }, Triangle{ { 0, 1, 3 } }, Triangle{ { 1, 2, 4 } } })
  {
    const MeshFace face = mesh.FindFaces({ t })[0];
    mesh.SetFacet(face.Cell, face.Face, number++);
  }
  EXPECT_EQ(FacesOfFacets(MeshRecord(mesh)).size(), 3u);
  mesh.Replace(FiniteCells(mesh), ThreeCells());
  const std::map<Id, std::set<Triangle>> expected = { { 1, { { { 0, 1, 3 } } } },
    { 2, { { { 1, 2, 4 } } } } };
  EXPECT_EQ(FacesOfFacets(MeshRecord(mesh)), expected);
  ExpectFlippableMeshLaws(mesh);
}

TEST(FlippableMesh, RefusesToReplaceCellsByOthersWithAnotherBoundary)
{
  std::vector<Tetrahedron> cells = ThreeCells();
  cells.pop_back();
  FlippableMesh mesh = Bipyramid();
  const MeshRecord before(mesh);
  try
  {
    mesh.Replace(FiniteCells(mesh), cells);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Inconsistent);
  }
  ExpectUnchanged(mesh, before);
}

TEST(FlippableMesh, ReplacingTakesAVertexOutThatNoCellHasAnyMore)
{
  // A tetrahedron with a vertex inside.
  FlippableMesh mesh = DelaunayMesh(
    { { { 0, 0, 0 } }, { { 9, 0, 0 } }, { { 0, 9, 0 } }, { { 0, 0, 9 } }, { { 2, 2, 2 } } });
  const std::int64_t changes = mesh.NumberOfChanges();
  EXPECT_TRUE(mesh.HasVertex(4));
  mesh.Replace(FiniteCells(mesh), { { { 0, 1, 2, 3 } } });
  EXPECT_FALSE(mesh.HasVertex(4));
  EXPECT_EQ(mesh.NumberOfChanges(), changes + 1);
  EXPECT_EQ(mesh.LastChangeAround(3), changes + 1);
  std::vector<Id> star;
  mesh.Star(4, star);
  EXPECT_TRUE(star.empty());
  EXPECT_EQ(mesh.FindEdge(4, 0), None);
  ExpectFlippableMeshLaws(mesh);
}

TEST(FlippableMesh, SplitsACellIntoFour)
{
  FlippableMesh mesh = Bipyramid();
  const MeshRecord before(mesh);
  const Id vertex = mesh.AddVertex({ { 2, 2, 2 } });
  EXPECT_FALSE(mesh.HasVertex(vertex));
  const std::vector<Id> cells = FiniteCells(mesh);
  mesh.SplitCell(mesh.Has(cells[0], 3) ? cells[0] : cells[1], vertex);
  EXPECT_EQ(MeshRecord(mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 2, 4 } }, { { 0, 1, 2, vertex } }, { { 0, 1, 3, vertex } },
      { { 0, 2, 3, vertex } }, { { 1, 2, 3, vertex } } }));
  ExpectFlippableMeshLaws(mesh, before);
}

TEST(FlippableMesh, SplitsAnEdgeWithAllAroundItOnTheHullToo)
{
  for (const bool onHull : { false, true })
  {
    FlippableMesh mesh = Bipyramid();
    mesh.Replace(FiniteCells(mesh), ThreeCells());
    const MeshRecord before(mesh);
    const std::array<Id, 2> edge =
      onHull ? std::array<Id, 2>{ { 0, 3 } } : std::array<Id, 2>{ { 3, 4 } };
    EdgeRing ring;
    mesh.Ring(edge[0], edge[1], mesh.FindEdge(edge[0], edge[1]), ring);
    const std::size_t size = onHull ? 4 : 3;
    ASSERT_EQ(ring.Points.size(), size);
    const Id vertex = mesh.AddVertexBetween(
      edge[0], edge[1], DyadicNumber(2), DyadicNumber(1), { { edge[0], edge[1], edge[1] } });
    mesh.SplitEdge(ring, vertex);
    EXPECT_EQ(mesh.FindEdge(edge[0], edge[1]), None);
    mesh.Ring(vertex, edge[0], mesh.FindEdge(vertex, edge[0]), ring);
    EXPECT_EQ(ring.Points.size(), size);
    EXPECT_EQ(FiniteCells(mesh).size(), onHull ? 5u : 6u);
    ExpectFlippableMeshLaws(mesh, before);
  }
}

TEST(FlippableMesh, SetsAFacetOnBothSidesOfAFace)
{
  FlippableMesh mesh = Cube();
  for (const Id cell : FiniteCells(mesh))
  {
    for (int k = 0; k < 4; ++k)
    {
      mesh.SetFacet(cell, k, cell);
      const Id neighbor = CellAt(mesh, cell).Neighbors[k];
      EXPECT_EQ(CellAt(mesh, cell).Facets[k], cell);
      EXPECT_EQ(CellAt(mesh, neighbor).Facets[mesh.MirrorIndex(cell, k)], cell);
      mesh.SetFacet(neighbor, mesh.MirrorIndex(cell, k), None);
      EXPECT_EQ(CellAt(mesh, cell).Facets[k], None);
    }
  }
  EXPECT_TRUE(FacesOfFacets(MeshRecord(mesh)).empty());
}

TEST(FlippableMesh, GoesAroundAnEdgeInOneTurn)
{
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    const FlippableMesh mesh = DelaunayMesh(AnyPoints(seed, 12));
    EdgeRing ring;
    for (const Id first : FiniteCells(mesh))
    {
      const Tetrahedron t = CellAt(mesh, first).Corners;
      mesh.Ring(t[2], t[0], first, ring);
      const std::size_t n = ring.Points.size();
      ASSERT_EQ(ring.Cells.size(), n);
      EXPECT_EQ(ring.Cells[0], first);
      for (std::size_t k = 0; k < n; ++k)
      {
        Tetrahedron expected = { { t[2], t[0], ring.Points[k], ring.Points[(k + 1) % n] } };
        Tetrahedron corners = CellAt(mesh, ring.Cells[k]).Corners;
        if (!mesh.IsInfinite(ring.Cells[k]))
        {
          EXPECT_EQ(mesh.Vertices().Orient(expected[0], expected[1], expected[2], expected[3]), 1);
        }
        std::sort(expected.begin(), expected.end());
        std::sort(corners.begin(), corners.end());
        EXPECT_EQ(corners, expected);
      }
      // All cells with both ends.
      std::size_t count = 0;
      for (Id cell = 0; cell < NumberOfCells(mesh); ++cell)
      {
        count += mesh.Has(cell, t[0]) && mesh.Has(cell, t[2]) ? 1 : 0;
      }
      EXPECT_EQ(n, count);
    }
  }
}

TEST(FlippableMesh, FindsAVertexOffEachPlane)
{
  const FlippableMesh mesh = DelaunayMesh(AnyPoints(1, 16));
  const MeshRecord record(mesh);
  int planes = 0;
  for (Id a = 0; a < mesh.Infinite(); ++a)
  {
    for (Id b = 0; b < a; ++b)
    {
      for (Id c = 0; c < b; ++c)
      {
        const Id off = mesh.VertexOffPlane(a, b, c);
        const Vector normal =
          testmeshes::Cross(testmeshes::Minus(record.Places[b], record.Places[a]),
            testmeshes::Minus(record.Places[c], record.Places[a]));
        const bool isLine = testmeshes::Dot(normal, normal) == 0;
        ASSERT_EQ(off == None, isLine);
        if (!isLine)
        {
          ++planes;
          ASSERT_NE(
            testmeshes::Dot(testmeshes::Minus(record.Places[off], record.Places[a]), normal), 0);
        }
      }
    }
  }
  EXPECT_GT(planes, 500);
  EXPECT_LT(planes, 16 * 15 * 14 / 6);
}

TEST(FlippableMesh, AVertexThatIsAddedAndRemovedLeavesTheMeshAsItWas)
{
  FlippableMesh mesh = Cube();
  const MeshRecord before(mesh);
  EXPECT_EQ(mesh.AddVertex({ { 1, 2, 3 } }), mesh.Infinite() + 1);
  EXPECT_EQ(mesh.AddVertexBetween(1, 2, DyadicNumber(1), DyadicNumber(2), { { 1, 2, 2 } }),
    mesh.Infinite() + 2);
  mesh.RemoveLastVertex();
  mesh.RemoveLastVertex();
  ExpectUnchanged(mesh, before);
}

TEST(FlippableMesh, ACopyThatIsPutBackUndoesWhatCameAfterIt)
{
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 14, 5);
    std::mt19937 random(seed);
    mesh.FlipAtRandom(random, 20);
    const FlippableMesh copy = mesh.Mesh;
    const MeshRecord before(mesh.Mesh);
    const std::int64_t changes = mesh.Mesh.NumberOfChanges();
    mesh.FlipAtRandom(random, 20);
    mesh.SplitCell(FiniteCells(mesh.Mesh)[0]);
    mesh.SplitFace({ FiniteCells(mesh.Mesh)[1], 2 });
    EXPECT_FALSE(Differences(before, MeshRecord(mesh.Mesh)).empty());
    ExpectUnchanged(copy, before);
    mesh.Mesh = copy;
    ExpectUnchanged(mesh.Mesh, before);
    EXPECT_EQ(mesh.Mesh.NumberOfChanges(), changes);
    mesh.FlipAtRandom(random, 20);
    ExpectFlippableMeshLaws(mesh.Mesh, before);
  }
}

TEST(FlippableMesh, GoesBackToWhatItWasWhenTheJournalBegan)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 14, 5);
    std::mt19937 random(seed);
    mesh.FlipAtRandom(random, 20);
    mesh.SplitCell(FiniteCells(mesh.Mesh)[0]);
    const Id rounded = mesh.SplitFace({ FiniteCells(mesh.Mesh)[1], 2 });
    const MeshWithFacets copy = mesh;
    const MeshRecord before(mesh.Mesh);
    mesh.Mesh.StartJournal();
    mesh.FlipAtRandom(random, 20);
    mesh.SplitCell(FiniteCells(mesh.Mesh)[2]);
    const Id split = mesh.SplitFace({ FiniteCells(mesh.Mesh)[3], 1 });
    for (const Id vertex : { rounded, split })
    {
      mesh.Mesh.MoveVertex(vertex, mesh.Mesh.Vertices().Nearest(vertex));
    }
    mesh.Mesh.SetFacet(FiniteCells(mesh.Mesh)[4], 0, 77);
    mesh.Mesh.Touch(3);
    EXPECT_FALSE(Differences(before, MeshRecord(mesh.Mesh)).empty());
    mesh.Mesh.GoBack();
    ExpectUnchanged(mesh.Mesh, before);
    EXPECT_EQ(mesh.Mesh.NumberOfChanges(), copy.Mesh.NumberOfChanges());
    EXPECT_EQ(mesh.Mesh.NumberOfCells(), copy.Mesh.NumberOfCells());
    EXPECT_EQ(mesh.Mesh.Vertices().Size(), copy.Mesh.Vertices().Size());
    for (Id vertex = 0; vertex < mesh.Mesh.Vertices().Size(); ++vertex)
    {
      EXPECT_EQ(mesh.Mesh.CellAt(vertex), copy.Mesh.CellAt(vertex));
      EXPECT_EQ(mesh.Mesh.LastChangeAround(vertex), copy.Mesh.LastChangeAround(vertex));
      EXPECT_EQ(mesh.Mesh.Vertices().IsDouble(vertex), copy.Mesh.Vertices().IsDouble(vertex));
    }
    // Later changes are the same, too: free ids are reused in the same order.
    MeshWithFacets other = copy;
    mesh.Segments = copy.Segments;
    for (MeshWithFacets* one : { &mesh, &other })
    {
      std::mt19937 again(seed);
      one->FlipAtRandom(again, 40);
      one->SplitCell(FiniteCells(one->Mesh)[2]);
    }
    EXPECT_TRUE(Differences(MeshRecord(other.Mesh), MeshRecord(mesh.Mesh)).empty());
  }
}

TEST(FlippableMesh, StaysAsItIsWhereTheJournalEnds)
{
  FlippableMesh mesh = Bipyramid();
  mesh.StartJournal();
  mesh.Replace(FiniteCells(mesh), ThreeCells());
  const MeshRecord after(mesh);
  mesh.EndJournal();
  ExpectUnchanged(mesh, after);
  mesh.StartJournal();
  mesh.Touch(1);
  mesh.GoBack();
  ExpectUnchanged(mesh, after);
}
