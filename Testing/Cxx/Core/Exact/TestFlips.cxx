// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/Flips.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

using namespace testflips;

namespace
{
constexpr FlipLimits Freely = { std::numeric_limits<int>::max() / 8, 12 };

const std::vector<Point> BipyramidPoints = { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } },
  { { 2, 2, 9 } }, { { 3, 3, -9 } } };

/** Two cells on the triangle 0 1 2. */
MeshWithFacets TwoCells(std::vector<Triangle> facets = {})
{
  return MeshWithFacets(
    MeshOfCells(BipyramidPoints, Pyramids({ { { 0, 1, 2 } } }, { 3, 4 })), std::move(facets));
}

/** Three cells around the edge 3 4. */
MeshWithFacets ThreeCells(std::vector<Triangle> facets = {})
{
  return MeshWithFacets(
    MeshOfCells(BipyramidPoints, { { { 4, 3, 0, 1 } }, { { 4, 3, 1, 2 } }, { { 4, 3, 2, 0 } } }),
    std::move(facets));
}

/** Four cells around the edge 4 5 of an octahedron with the equator 0 1 2 3. */
MeshWithFacets FourCells(std::vector<Triangle> facets = {})
{
  std::vector<Tetrahedron> cells;
  for (Id k = 0; k < 4; ++k)
  {
    cells.push_back({ { k, (k + 1) % 4, 4, 5 } });
  }
  return MeshWithFacets(MeshOfCells({ { { 3, 0, 0 } }, { { 0, 3, 0 } }, { { -3, 0, 0 } },
                                      { { 0, -3, 0 } }, { { 0, 0, 3 } }, { { 0, 0, -3 } } },
                          cells),
    std::move(facets));
}

/** A pyramid on the square 0 1 2 3, cut along 0 2. */
MeshWithFacets Pyramid(std::vector<Triangle> facets = {})
{
  return MeshWithFacets(MeshOfCells({ { { 0, 0, 0 } }, { { 3, 0, 0 } }, { { 3, 3, 0 } },
                                      { { 0, 3, 0 } }, { { 1, 1, 3 } } },
                          Pyramids({ { { 0, 1, 2 } }, { { 0, 2, 3 } } }, { 4 })),
    std::move(facets));
}

bool RemoveFace(MeshWithFacets& mesh, const Triangle& triangle, const FlipTarget& target,
  const FlipLimits& limits = Freely)
{
  const MeshFace face = mesh.Mesh.FindFaces({ triangle })[0];
  return RemoveFace(mesh, face.Cell, face.Face, target, limits);
}

bool RemoveEdge(
  MeshWithFacets& mesh, Id u, Id v, const FlipTarget& target, const FlipLimits& limits = Freely)
{
  return RemoveEdge(mesh, u, v, mesh.Mesh.FindEdge(u, v), target, limits);
}

/** Expect that a flip is refused and nothing changed. */
template <typename Flip>
void ExpectRefused(MeshWithFacets mesh, const Flip& flip)
{
  const MeshRecord before(mesh.Mesh);
  EXPECT_FALSE(flip(mesh));
  ExpectUnchanged(mesh.Mesh, before);
}

// --- All ways to take an edge away, straight from the definition ---------------------------------

using Triangles = std::vector<std::array<int, 3>>;

/** Append all triangulations of a polygon's corners from i to j. */
std::vector<Triangles> Triangulations(int i, int j)
{
  if (j == i + 1)
  {
    return { {} };
  }
  std::vector<Triangles> all;
  for (int k = i + 1; k < j; ++k)
  {
    for (const Triangles& left : Triangulations(i, k))
    {
      for (const Triangles& right : Triangulations(k, j))
      {
        Triangles both = { { { i, k, j } } };
        both.insert(both.end(), left.begin(), left.end());
        both.insert(both.end(), right.begin(), right.end());
        all.push_back(both);
      }
    }
  }
  return all;
}

/** The edges and faces of finite cells that obstruct the target. */
int CostOf(const std::set<Tetrahedron>& cells, const FlipTarget& target)
{
  std::set<std::array<Id, 2>> edges;
  std::set<Triangle> faces;
  for (const Tetrahedron& t : cells)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        edges.insert({ { t[i], t[j] } });
        for (int k = j + 1; k < 4; ++k)
        {
          faces.insert({ { t[i], t[j], t[k] } });
        }
      }
    }
  }
  int cost = 0;
  for (const std::array<Id, 2>& e : edges)
  {
    cost += target.CostOfEdge(e[0], e[1]);
  }
  for (const Triangle& f : faces)
  {
    cost += target.CostOfFace(f[0], f[1], f[2]);
  }
  return cost;
}

/**
 * The least that is in the way after an inner edge has gone, and before; nothing where it cannot
 * go.
 */
std::optional<int> LeastIncrease(
  const FlippableMesh& mesh, const MeshRecord& record, Id u, Id v, const FlipTarget& target)
{
  EdgeRing ring;
  mesh.Ring(u, v, mesh.FindEdge(u, v), ring);
  std::set<Tetrahedron> old;
  for (const Id cell : ring.Cells)
  {
    Tetrahedron t = CellAt(mesh, cell).Corners;
    std::sort(t.begin(), t.end());
    old.insert(t);
  }
  std::optional<int> least;
  for (const Triangles& triangles : Triangulations(0, static_cast<int>(ring.Points.size()) - 1))
  {
    bool isPositive = true;
    std::set<Tetrahedron> fresh;
    for (const std::array<int, 3>& t : triangles)
    {
      const Triangle p = { { ring.Points[t[0]], ring.Points[t[1]], ring.Points[t[2]] } };
      const auto& at = record.Places;
      isPositive = isPositive && SixfoldVolume(at[p[0]], at[p[1]], at[p[2]], at[v]) > 0 &&
        SixfoldVolume(at[p[1]], at[p[0]], at[p[2]], at[u]) > 0;
      for (const Id end : { u, v })
      {
        Tetrahedron cell = { { p[0], p[1], p[2], end } };
        std::sort(cell.begin(), cell.end());
        fresh.insert(cell);
      }
    }
    if (isPositive)
    {
      const int increase = CostOf(fresh, target) - CostOf(old, target);
      least = std::min(increase, least.value_or(increase));
    }
  }
  return least;
}
} // namespace

// --- Faces ---------------------------------------------------------------------------------------

TEST(Flips, AFaceOfTwoCellsBecomesAnEdgeOfThree)
{
  MeshWithFacets mesh = TwoCells({ { { 0, 1, 3 } }, { { 1, 2, 4 } } });
  const MeshRecord before(mesh.Mesh);
  EXPECT_TRUE(RemoveFace(mesh, { { 0, 1, 2 } }, FlipTarget(mesh.Mesh)));
  EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 3, 4 } }, { { 1, 2, 3, 4 } }, { { 0, 2, 3, 4 } } }));
  ExpectFlippableMeshLaws(mesh.Mesh, before);
}

TEST(Flips, AFaceStaysThatIsAFacetOrOnTheHull)
{
  ExpectRefused(TwoCells({ { { 0, 1, 2 } } }),
    [](MeshWithFacets& mesh) {
      return RemoveFace(mesh, { { 0, 1, 2 } }, FlipTarget(mesh.Mesh));
    });
  for (const Triangle& face : { Triangle{ { 0, 1, 3 } }, Triangle{ { 0, 1, 4 } } })
  {
    ExpectRefused(TwoCells(),
      [&face](MeshWithFacets& mesh) { return RemoveFace(mesh, face, FlipTarget(mesh.Mesh)); });
  }
}

TEST(Flips, AFaceStaysWhereTheNewEdgeWouldPassThroughItsEdgeOrOutside)
{
  // Two cells of the octahedron on the face 0 4 5, whose apexes 1 and 3 see each other along 4 5;
  // and two of the pyramid, where they see each other in the base.
  ExpectRefused(FourCells(),
    [](MeshWithFacets& mesh) {
      return RemoveFace(mesh, { { 0, 4, 5 } }, FlipTarget(mesh.Mesh));
    });
  ExpectRefused(Pyramid(),
    [](MeshWithFacets& mesh) {
      return RemoveFace(mesh, { { 0, 2, 4 } }, FlipTarget(mesh.Mesh));
    });
  ExpectRefused(ThreeCells(),
    [](MeshWithFacets& mesh) {
      return RemoveFace(mesh, { { 0, 3, 4 } }, FlipTarget(mesh.Mesh));
    });
}

TEST(Flips, AFaceGoesForASegmentThatItBarsAndStaysWhereTheNewEdgeBarsMore)
{
  MeshWithFacets mesh = TwoCells();
  EXPECT_TRUE(
    RemoveFace(mesh, { { 0, 1, 2 } }, FlipTarget::Segment(mesh.Mesh, 3, 4), FlipLimits{ -1, 3 }));
  const FlipLimits less = { -1, 3 };
  ExpectRefused(TwoCells(),
    [&less](MeshWithFacets& other) {
      return RemoveFace(other, { { 0, 1, 2 } }, FlipTarget(other.Mesh), less);
    });
  // For the facet the edge that would come is in the way, and counts 3.
  for (const int increase : { 0, 1, 2, 3 })
  {
    MeshWithFacets other = TwoCells();
    EXPECT_EQ(RemoveFace(other, { { 0, 1, 2 } }, FlipTarget::Facet(other.Mesh, { { 0, 1, 2 } }),
                FlipLimits{ increase, 3 }),
      increase == 3);
  }
}

// --- Edges ---------------------------------------------------------------------------------------

TEST(Flips, AnEdgeOfThreeCellsBecomesAFaceOfTwo)
{
  MeshWithFacets mesh = ThreeCells({ { { 0, 1, 3 } }, { { 1, 2, 4 } } });
  const MeshRecord before(mesh.Mesh);
  EXPECT_TRUE(RemoveEdge(mesh, 3, 4, FlipTarget(mesh.Mesh)));
  EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } } }));
  ExpectFlippableMeshLaws(mesh.Mesh, before);
}

TEST(Flips, AnEdgeOfFourCellsBecomesTheDiagonalThatIsAskedFor)
{
  for (const Id from : { 0, 1 })
  {
    MeshWithFacets mesh = FourCells();
    const MeshRecord before(mesh.Mesh);
    const FlipTarget target = FlipTarget::Segment(mesh.Mesh, from, from + 2);
    EXPECT_TRUE(RemoveEdge(mesh, 4, 5, target, { -1, 4 }));
    EXPECT_EQ(mesh.Mesh.FindEdge(4, 5), None);
    EXPECT_NE(mesh.Mesh.FindEdge(from, from + 2), None);
    EXPECT_EQ(FiniteCells(mesh.Mesh).size(), 4u);
    ExpectFlippableMeshLaws(mesh.Mesh, before);
  }
}

TEST(Flips, AnEdgeOfTheHullGoesWhereTheHullIsFlat)
{
  MeshWithFacets mesh = Pyramid({ { { 0, 1, 4 } } });
  const MeshRecord before(mesh.Mesh);
  EXPECT_TRUE(RemoveEdge(mesh, 0, 2, FlipTarget(mesh.Mesh)));
  EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 3, 4 } }, { { 1, 2, 3, 4 } } }));
  ExpectFlippableMeshLaws(mesh.Mesh, before);
  for (const std::array<Id, 2>& edge :
    { std::array<Id, 2>{ { 0, 1 } }, std::array<Id, 2>{ { 1, 4 } } })
  {
    ExpectRefused(Pyramid(),
      [&edge](MeshWithFacets& other)
      { return RemoveEdge(other, edge[0], edge[1], FlipTarget(other.Mesh)); });
  }
}

TEST(Flips, AnEdgeStaysThatASegmentOrAFacetHas)
{
  for (const Triangle& facet : { Triangle{ { 3, 4, 0 } }, Triangle{ { 2, 4, 3 } } })
  {
    ExpectRefused(ThreeCells({ facet }),
      [](MeshWithFacets& mesh) { return RemoveEdge(mesh, 3, 4, FlipTarget(mesh.Mesh)); });
    // A segment whose facet is not there.
    MeshWithFacets mesh = ThreeCells({ facet });
    const MeshFace face = mesh.Mesh.FindFaces({ facet })[0];
    mesh.Mesh.SetFacet(face.Cell, face.Face, None);
    ExpectRefused(std::move(mesh),
      [](MeshWithFacets& other) { return RemoveEdge(other, 3, 4, FlipTarget(other.Mesh)); });
  }
  // A face of a facet whose edges are others' segments, which lies across two faces.
  MeshWithFacets mesh = ThreeCells({ { { 0, 1, 2 } } });
  const MeshFace face = mesh.Mesh.FindFaces({ { { 3, 4, 0 } } })[0];
  mesh.Mesh.SetFacet(face.Cell, face.Face, 0);
  ExpectRefused(std::move(mesh),
    [](MeshWithFacets& other) { return RemoveEdge(other, 3, 4, FlipTarget(other.Mesh)); });
}

TEST(Flips, AnEdgeStaysThatHasTooManyCellsOrThatEndsAtInfinity)
{
  ExpectRefused(FourCells(),
    [](MeshWithFacets& mesh) {
      return RemoveEdge(mesh, 4, 5, FlipTarget(mesh.Mesh), { 9, 3 });
    });
  ExpectRefused(FourCells(),
    [](MeshWithFacets& mesh)
    { return RemoveEdge(mesh, 0, mesh.Mesh.Infinite(), FlipTarget(mesh.Mesh)); });
}

TEST(Flips, AnEdgeThatIsTheOnlyWayToAVertexStays)
{
  // A cell cut into four by a vertex within.
  const auto cells = []()
  {
    return MeshWithFacets(DelaunayMesh({ { { 0, 0, 0 } }, { { 9, 0, 0 } }, { { 0, 9, 0 } },
                            { { 0, 0, 9 } }, { { 2, 2, 2 } } }),
      {});
  };
  for (Id corner = 0; corner < 4; ++corner)
  {
    ExpectRefused(cells(),
      [corner](MeshWithFacets& mesh)
      { return RemoveEdge(mesh, 4, corner, FlipTarget(mesh.Mesh)); });
    int budget = 100;
    ExpectRefused(cells(),
      [&](MeshWithFacets& mesh)
      {
        return RemoveEdgeDeeply(
          mesh, 4, corner, FlipTarget(mesh.Mesh), { Freely, 3, budget }, budget);
      });
  }
}

TEST(Flips, OfAllWaysTakesOneThatLeavesLeastInTheWay)
{
  int removed = 0;
  int tooDear = 0;
  int impossible = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    MeshWithFacets mesh(DelaunayMesh(AnyPoints(seed, 14)), {});
    std::mt19937 random(seed);
    mesh.FlipAtRandom(random, 20);
    const auto any = [&]() { return static_cast<Id>(random() % 14); };
    for (int k = 0; k < 12; ++k)
    {
      const std::vector<Id> cells = FiniteCells(mesh.Mesh);
      const Tetrahedron t = CellAt(mesh.Mesh, cells[random() % cells.size()]).Corners;
      const Id u = t[0];
      const Id v = t[1 + random() % 3];
      EdgeRing ring;
      mesh.Mesh.Ring(u, v, mesh.Mesh.FindEdge(u, v), ring);
      const bool onHull = std::find(ring.Points.begin(), ring.Points.end(), mesh.Mesh.Infinite()) !=
        ring.Points.end();
      if (onHull || ring.Points.size() > 7)
      {
        continue;
      }
      const FlipTarget target = k % 2 == 0
        ? FlipTarget::Segment(mesh.Mesh, any(), any())
        : FlipTarget::Facet(mesh.Mesh, { { any(), any(), any() } });
      const MeshRecord before(mesh.Mesh);
      const std::optional<int> least = LeastIncrease(mesh.Mesh, before, u, v, target);
      const int increase = static_cast<int>(random() % 4) - 1;
      const bool isRemoved = RemoveEdge(mesh, u, v, target, { increase, 7 });
      ASSERT_EQ(isRemoved, least && *least <= increase) << seed << ": " << u << ' ' << v;
      if (isRemoved)
      {
        const MeshRecord after(mesh.Mesh);
        EXPECT_EQ(
          CostOf(after.FiniteCells(), target) - CostOf(before.FiniteCells(), target), *least);
        EXPECT_EQ(mesh.Mesh.FindEdge(u, v), None);
        ExpectFlippableMeshLaws(mesh.Mesh, before);
      }
      else
      {
        ExpectUnchanged(mesh.Mesh, before);
      }
      removed += isRemoved ? 1 : 0;
      tooDear += !isRemoved && least ? 1 : 0;
      impossible += least ? 0 : 1;
    }
  }
  EXPECT_GT(removed, 10);
  EXPECT_GT(tooDear, 3);
  EXPECT_GT(impossible, 10);
}

// --- Both, at random -----------------------------------------------------------------------------

TEST(Flips, KeepsFacetsAndSegmentsWhateverIsTried)
{
  int faces = 0;
  int edges = 0;
  for (unsigned seed = 1; seed <= 32; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 16, 6);
    const FlipTarget nothing(mesh.Mesh);
    std::mt19937 random(seed);
    for (int k = 0; k < 16; ++k)
    {
      const MeshRecord before(mesh.Mesh);
      Id cell = static_cast<Id>(random() % static_cast<unsigned>(NumberOfCells(mesh.Mesh)));
      while (mesh.Mesh.IsDead(cell))
      {
        cell = (cell + 1) % NumberOfCells(mesh.Mesh);
      }
      const int i = static_cast<int>(random() % 4);
      const Tetrahedron t = CellAt(mesh.Mesh, cell).Corners;
      const bool isFace = k % 2 == 0;
      const bool isDone = isFace ? RemoveFace(mesh, cell, i, nothing, Freely)
                                 : RemoveEdge(mesh, t[i], t[(i + 1) % 4], cell, nothing, Freely);
      if (!isDone)
      {
        ExpectUnchanged(mesh.Mesh, before);
        continue;
      }
      (isFace ? faces : edges) += 1;
      ExpectFlippableMeshLaws(mesh.Mesh, before);
      EXPECT_EQ(
        ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), std::vector<std::string>());
    }
  }
  EXPECT_GT(faces, 12);
  EXPECT_GT(edges, 5);
}

TEST(Flips, RemovesDeeplyWhatIsToBeRemovedAndSaysSo)
{
  int atOnce = 0;
  int deeply = 0;
  int never = 0;
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 18, 20);
    std::mt19937 random(seed);
    const FlipTarget nothing(mesh.Mesh);
    for (int k = 0; k < 6; ++k)
    {
      const std::vector<Id> cells = FiniteCells(mesh.Mesh);
      const Tetrahedron t = CellAt(mesh.Mesh, cells[random() % cells.size()]).Corners;
      const MeshRecord before(mesh.Mesh);
      const std::int64_t changes = mesh.Mesh.NumberOfChanges();
      int budget = 60;
      const bool isRemoved =
        RemoveEdgeDeeply(mesh, t[0], t[1], nothing, { { 0, 12 }, 2, budget }, budget);
      EXPECT_EQ(isRemoved, mesh.Mesh.FindEdge(t[0], t[1]) == None);
      EXPECT_LE(budget, 60);
      ExpectFlippableMeshLaws(mesh.Mesh, before);
      const std::int64_t flipsDone = mesh.Mesh.NumberOfChanges() - changes;
      (!isRemoved ? never : flipsDone == 1 ? atOnce : deeply) += 1;
    }
  }
  EXPECT_GT(atOnce, 10);
  EXPECT_GT(deeply, 10);
  EXPECT_GT(never, 10);
}

TEST(Flips, WithoutABudgetOrDepthRemovesNothingElse)
{
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    for (const bool hasDepth : { false, true })
    {
      MeshWithFacets mesh = RandomMeshWithFacets(seed, 14, 10);
      const FlipTarget nothing(mesh.Mesh);
      for (const Id cell : FiniteCells(mesh.Mesh))
      {
        if (mesh.Mesh.IsDead(cell))
        {
          continue;
        }
        const Tetrahedron t = CellAt(mesh.Mesh, cell).Corners;
        const std::int64_t changes = mesh.Mesh.NumberOfChanges();
        int budget = hasDepth ? 0 : 60;
        const bool isRemoved = RemoveEdgeDeeply(
          mesh, t[0], t[1], nothing, { { 0, 12 }, hasDepth ? 2 : 0, budget }, budget);
        EXPECT_EQ(mesh.Mesh.NumberOfChanges() - changes, isRemoved ? 1 : 0);
      }
    }
  }
}
