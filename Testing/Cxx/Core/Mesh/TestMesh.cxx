// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/Mesh.h"

#include "Exact/FlippableMesh.h"
#include "Mesh/CellSet.h"
#include "Mesh/IdSet.h"
#include "Mesh/RingTriangulation.h"
#include "Refine/RefinableMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

using namespace insideout;

namespace
{
/** A ball of cells around vertex 0; where it is closed, with a vertex at infinity, the last. */
template <class Policy>
class SomeMesh : public Mesh<Policy>
{
public:
  using Base = Mesh<Policy>;
  using typename Base::CellType;
  using typename Base::Content;

  /** An octahedron: vertices 1 to 6, of which k and k + 3 are across from each other. */
  SomeMesh()
  {
    for (Id vertex = 0; vertex < Vertices; ++vertex)
    {
      this->AppendVertex(0);
    }
    std::vector<Tetrahedron> corners;
    for (int k = 0; k < 8; ++k)
    {
      const Id a = k & 1 ? 4 : 1;
      const Id b = k & 2 ? 5 : 2;
      const Id c = k & 4 ? 6 : 3;
      const bool isTurned = (k & 1) ^ (k >> 1 & 1) ^ (k >> 2);
      corners.push_back(isTurned ? Tetrahedron{ { 0, b, a, c } } : Tetrahedron{ { 0, a, b, c } });
      if (!Policy::HasBoundary)
      {
        corners.push_back(
          isTurned ? Tetrahedron{ { Infinite, a, b, c } } : Tetrahedron{ { Infinite, b, a, c } });
      }
    }
    std::vector<CellType> cells;
    for (const Tetrahedron& t : corners)
    {
      CellType cell = { Content(), t, { { None, None, None, None } },
        { { None, None, None, None } } };
      for (int k = 0; k < 4; ++k)
      {
        for (std::size_t other = 0; other < corners.size(); ++other)
        {
          const auto isShared = [&](Id corner)
          { return corner == t[k] || CornerIndexIn(corners[other], corner) >= 0; };
          if (corners[other] != t && std::all_of(t.begin(), t.end(), isShared))
          {
            cell.Neighbors[k] = static_cast<Id>(other);
          }
        }
      }
      cells.push_back(cell);
    }
    this->SetCells(
      cells.size(), [&cells](Id cell) { return cells[static_cast<std::size_t>(cell)]; });
  }

  void Change(const std::vector<Id>& old, const std::vector<Tetrahedron>& fresh,
    const std::vector<Triangle>& gone = {}, const std::vector<FreshFacet>& facets = {})
  {
    this->Replace(
      { old, fresh, gone, facets }, [](std::size_t, Id) { return Content(); }, this->Own);
  }

  void Start() { this->StartJournal(this->Own); }
  void Back() { this->GoBack(this->Own); }

  std::vector<Id> StarOf(Id vertex)
  {
    std::vector<Id> cells;
    this->Star(vertex, cells, this->Own.Marks);
    return cells;
  }

  void MarkFacet(Id cell, int k, Id facet)
  {
    this->Cells[cell].Facets[k] = facet;
    if (const Id beyond = this->Cells[cell].Neighbors[k]; beyond != None)
    {
      this->Cells[beyond].Facets[this->MirrorIndex(cell, k)] = facet;
    }
  }

  static constexpr Id Vertices = 8;
  static constexpr Id Infinite = 7;
  typename Base::Workspace Own;
};

/** All that can be read of a mesh. */
template <class Policy>
std::vector<std::array<Id, 12>> ReadAll(const SomeMesh<Policy>& mesh)
{
  std::vector<std::array<Id, 12>> all;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    const auto& cell = mesh.Cell(c);
    std::array<Id, 12> row = {};
    for (int k = 0; k < 4 && !mesh.IsDead(c); ++k)
    {
      row[k] = cell.Corners[k];
      row[4 + k] = cell.Neighbors[k];
      row[8 + k] = cell.Facets[k];
    }
    all.push_back(row);
  }
  for (Id v = 0; v < SomeMesh<Policy>::Vertices; ++v)
  {
    all.push_back({ mesh.CellAt(v), static_cast<Id>(mesh.LastChangeAround(v)) });
  }
  all.push_back({ static_cast<Id>(mesh.Own.Changes) });
  return all;
}

/** Live cells and their neighbors name each other across shared faces, which carry one facet; a
 * face has two cells, or one where there is a boundary; each vertex names a cell that has it. */
template <class Policy>
void ExpectLaws(const SomeMesh<Policy>& mesh)
{
  std::map<Triangle, int> faces;
  std::set<Id> vertices;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4 && !mesh.IsDead(c); ++k)
    {
      vertices.insert(mesh.Cell(c).Corners[k]);
      const Triangle face = SortedTriangle(mesh.FaceCorners(c, k)).Points;
      ++faces[face];
      const Id neighbor = mesh.Cell(c).Neighbors[k];
      ASSERT_TRUE(Policy::HasBoundary || neighbor != None);
      if (neighbor != None)
      {
        const int mirror = mesh.MirrorIndex(c, k);
        ASSERT_GE(mirror, 0);
        ASSERT_FALSE(mesh.IsDead(neighbor));
        EXPECT_EQ(mesh.Cell(neighbor).Neighbors[mirror], c);
        EXPECT_EQ(mesh.Cell(neighbor).Facets[mirror], mesh.Cell(c).Facets[k]);
        EXPECT_EQ(SortedTriangle(mesh.FaceCorners(neighbor, mirror)).Points, face);
        EXPECT_NE(SortedTriangle(mesh.FaceCorners(neighbor, mirror)).Turned,
          SortedTriangle(mesh.FaceCorners(c, k)).Turned);
      }
      else
      {
        ++faces[face];
      }
    }
  }
  for (const auto& [face, cells] : faces)
  {
    EXPECT_EQ(cells, 2) << face[0] << ' ' << face[1] << ' ' << face[2];
  }
  for (Id v = 0; v < SomeMesh<Policy>::Vertices; ++v)
  {
    ASSERT_EQ(mesh.HasVertex(v), vertices.count(v) > 0) << v;
    EXPECT_TRUE(
      !mesh.HasVertex(v) || (!mesh.IsDead(mesh.CellAt(v)) && mesh.Has(mesh.CellAt(v), v)));
  }
}

/** The live cells that have both vertices. */
template <class Policy>
std::vector<Id> CellsWith(const SomeMesh<Policy>& mesh, Id u, Id v)
{
  std::vector<Id> cells;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (!mesh.IsDead(c) && mesh.Has(c, u) && mesh.Has(c, v))
    {
      cells.push_back(c);
    }
  }
  return cells;
}

/** Four cells around the axis from 1 to 4 in the place of the eight around the middle. */
std::vector<Tetrahedron> AroundAxis()
{
  return { { { 4, 1, 2, 3 } }, { { 4, 1, 3, 5 } }, { { 4, 1, 5, 6 } }, { { 4, 1, 6, 2 } } };
}

template <class Policy>
class MeshLaws : public testing::Test
{
};
/** Those of the exact engine and of refinement. */
using Policies = testing::Types<HullPolicy, SolidPolicy>;
TYPED_TEST_SUITE(MeshLaws, Policies);
} // namespace

TYPED_TEST(MeshLaws, HoldAfterTheMiddleIsTakenOut)
{
  SomeMesh<TypeParam> mesh;
  ExpectLaws(mesh);
  mesh.Change(mesh.StarOf(0), AroundAxis());
  ExpectLaws(mesh);
  EXPECT_FALSE(mesh.HasVertex(0));
  EXPECT_EQ(mesh.Own.Changes, 1);
  EXPECT_EQ(mesh.LastChangeAround(5), 1);
  EXPECT_EQ(mesh.LastChangeAround(0), 0);
  EXPECT_EQ(mesh.Own.FreshCells.size(), 4u);
  EXPECT_EQ(mesh.Own.FreeCells.size(), 4u);
}

TYPED_TEST(MeshLaws, HoldAfterManyChangesThereAndBack)
{
  SomeMesh<TypeParam> mesh;
  const Id cells = mesh.NumberOfCells();
  const std::vector<Id> star = mesh.StarOf(0);
  std::vector<Tetrahedron> around;
  for (const Id cell : star)
  {
    around.push_back(mesh.Cell(cell).Corners);
  }
  for (int turn = 0; turn < 10; ++turn)
  {
    mesh.Change(mesh.StarOf(0), AroundAxis());
    ExpectLaws(mesh);
    mesh.Change(CellsWith(mesh, 1, 4), around);
    ExpectLaws(mesh);
    EXPECT_EQ(mesh.NumberOfCells(), cells);
  }
}

TYPED_TEST(MeshLaws, FacetsStayBetweenOldCellsAndTheRestAndGoWithin)
{
  SomeMesh<TypeParam> mesh;
  for (const Id cell : mesh.StarOf(0))
  {
    for (int k = 0; k < 4; ++k)
    {
      mesh.MarkFacet(cell, k, mesh.Cell(cell).Corners[k] == 0 ? cell : 99);
    }
  }
  mesh.Change(mesh.StarOf(0), AroundAxis());
  ExpectLaws(mesh);
  int kept = 0;
  for (const Id cell : CellsWith(mesh, 1, 4))
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id corner = mesh.Cell(cell).Corners[k];
      EXPECT_EQ(mesh.Cell(cell).Facets[k] != None, corner == 1 || corner == 4);
      EXPECT_NE(mesh.Cell(cell).Facets[k], 99);
      kept += mesh.Cell(cell).Facets[k] != None ? 1 : 0;
    }
  }
  EXPECT_EQ(kept, 8);
}

TYPED_TEST(MeshLaws, FacetsThatAreGivenAreOnBothSides)
{
  SomeMesh<TypeParam> mesh;
  mesh.Change(mesh.StarOf(0), AroundAxis(), {}, { { { { 4, 2, 1 } }, 5 } });
  ExpectLaws(mesh);
  std::size_t found = 0;
  for (const Id cell : CellsWith(mesh, 1, 4))
  {
    found += static_cast<std::size_t>(
      std::count(mesh.Cell(cell).Facets.begin(), mesh.Cell(cell).Facets.end(), 5));
  }
  EXPECT_EQ(found, 2u);
}

TYPED_TEST(MeshLaws, RefusedChangesLeaveTheMeshAsItWas)
{
  SomeMesh<TypeParam> mesh;
  mesh.Change({ mesh.StarOf(0)[0] }, { mesh.Cell(mesh.StarOf(0)[0]).Corners });
  const std::vector<Id> star = mesh.StarOf(0);
  const auto before = ReadAll(mesh);
  std::vector<Tetrahedron> few = AroundAxis();
  few.pop_back();
  std::vector<Tetrahedron> many = AroundAxis();
  many.push_back(many[0]);
  std::vector<Tetrahedron> twice = AroundAxis();
  twice[3] = twice[0]; // each face is met as often as it has to be, all in all
  std::vector<Id> doubled = star;
  doubled.push_back(star[0]);
  const std::vector<FreshFacet> nowhere = { { { { 2, 3, 5 } }, 1 } };
  EXPECT_THROW(mesh.Change(star, few), Error);
  EXPECT_EQ(ReadAll(mesh), before);
  EXPECT_THROW(mesh.Change(star, many), Error);
  EXPECT_EQ(ReadAll(mesh), before);
  EXPECT_THROW(mesh.Change(star, twice), Error);
  EXPECT_EQ(ReadAll(mesh), before);
  EXPECT_THROW(mesh.Change(doubled, AroundAxis()), Error);
  EXPECT_EQ(ReadAll(mesh), before);
  EXPECT_THROW(mesh.Change(star, AroundAxis(), {}, nowhere), Error);
  EXPECT_EQ(ReadAll(mesh), before);
  mesh.Change(star, AroundAxis());
  ExpectLaws(mesh);
  const auto after = ReadAll(mesh);
  const std::vector<Id> dead = { mesh.Own.FreeCells.back() };
  EXPECT_THROW(mesh.Change(dead, { { { 0, 1, 2, 3 } } }), Error);
  EXPECT_EQ(ReadAll(mesh), after);
}

TYPED_TEST(MeshLaws, TheJournalLeadsBackOverAnyNumberOfChanges)
{
  SomeMesh<TypeParam> mesh;
  std::vector<Tetrahedron> around;
  for (const Id cell : mesh.StarOf(0))
  {
    around.push_back(mesh.Cell(cell).Corners);
  }
  mesh.Change(mesh.StarOf(0), AroundAxis());
  const auto before = ReadAll(mesh);
  const std::vector<Id> free = mesh.Own.FreeCells;
  for (int changes = 1; changes < 6; ++changes)
  {
    mesh.Start();
    for (int k = 0; k < changes; ++k)
    {
      const bool isAxis = k % 2 == 0;
      mesh.Change(isAxis ? CellsWith(mesh, 1, 4) : mesh.StarOf(0), isAxis ? around : AroundAxis());
    }
    EXPECT_NE(ReadAll(mesh), before);
    mesh.Back();
    EXPECT_EQ(ReadAll(mesh), before);
    EXPECT_EQ(mesh.Own.FreeCells, free);
    ExpectLaws(mesh);
  }
}

TYPED_TEST(MeshLaws, RingsGoAroundAnEdgeInOneTurn)
{
  SomeMesh<TypeParam> mesh;
  for (const Id first : mesh.StarOf(0))
  {
    const Tetrahedron t = mesh.Cell(first).Corners;
    for (int i = 0; i < 4; ++i)
    {
      for (int j = 0; j < 4; ++j)
      {
        if (i == j)
        {
          continue;
        }
        EdgeRing ring;
        mesh.Ring(t[i], t[j], first, ring);
        const bool isInner = t[i] == 0 || t[j] == 0;
        EXPECT_EQ(ring.IsClosed, isInner || !TypeParam::HasBoundary);
        EXPECT_FALSE(ring.IsLocked);
        const std::vector<Id> all = CellsWith(mesh, t[i], t[j]);
        std::vector<Id> cells = ring.Cells;
        std::sort(cells.begin(), cells.end());
        EXPECT_EQ(cells, all);
        EXPECT_EQ(ring.Points.size(), ring.Cells.size() + (ring.IsClosed ? 0 : 1));
        for (std::size_t k = 0; k < ring.Cells.size(); ++k)
        {
          EXPECT_TRUE(mesh.Has(ring.Cells[k], ring.Points[k]));
          EXPECT_TRUE(mesh.Has(ring.Cells[k], ring.Points[(k + 1) % ring.Points.size()]));
        }
      }
    }
  }
}

TYPED_TEST(MeshLaws, AFaceAtAnEdgeThatIsAPieceOfAFacetLocksItsRing)
{
  SomeMesh<TypeParam> mesh;
  const Id cell = mesh.StarOf(0)[0];
  const int k = mesh.CornerIndex(cell, 0) == 0 ? 1 : 0;
  mesh.MarkFacet(cell, k, 3);
  for (int j = 1; j < 4; ++j)
  {
    EdgeRing ring;
    mesh.Ring(0, mesh.Cell(cell).Corners[j], cell, ring);
    EXPECT_EQ(ring.IsLocked, j != k);
    EXPECT_EQ(ring.IsOnFacet(), j != k);
  }
}

TEST(MeshWithBoundary, ACellMayGoFromItWithItsPieces)
{
  SomeMesh<SolidPolicy> mesh;
  const Id cell = mesh.StarOf(0)[0];
  const Tetrahedron t = mesh.Cell(cell).Corners;
  const Triangle outer = SortedTriangle(mesh.FaceCorners(cell, 0)).Points;
  std::vector<FreshFacet> facets;
  for (int k = 1; k < 4; ++k)
  {
    facets.push_back({ mesh.FaceCorners(cell, k), k });
  }
  mesh.Change({ cell }, {}, { outer }, facets);
  ExpectLaws(mesh);
  EXPECT_EQ(CellsWith(mesh, t[0], t[1]).size(), 3u);
  EdgeRing ring;
  mesh.Ring(t[0], t[1], CellsWith(mesh, t[0], t[1])[0], ring);
  EXPECT_FALSE(ring.IsClosed);
  EXPECT_TRUE(std::set<Id>(ring.EndFacets.begin(), ring.EndFacets.end()) == (std::set<Id>{ 2, 3 }));
}

namespace
{
/** As many cells as the ball of a mesh with a boundary. */
struct SmallPolicy : SolidPolicy
{
  static constexpr std::size_t MostCells = 8;
};
} // namespace

TEST(MeshOfManyCells, RefusesMoreThanItCanNumberAndStaysAsItWas)
{
  SomeMesh<SmallPolicy> mesh;
  const std::vector<Id> star = mesh.StarOf(0);
  std::vector<Tetrahedron> around;
  for (const Id cell : star)
  {
    around.push_back(mesh.Cell(cell).Corners);
  }
  mesh.Change(star, around);
  ExpectLaws(mesh);
  const auto addPoint = [](auto& some)
  {
    const Id cell = some.StarOf(0)[0];
    std::vector<Tetrahedron> four(4, some.Cell(cell).Corners);
    for (int k = 0; k < 4; ++k)
    {
      four[k][k] = 7;
    }
    some.Change({ cell }, four);
  };
  const auto before = ReadAll(mesh);
  try
  {
    addPoint(mesh);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::TooLarge);
    EXPECT_STREQ(error.what(), "a mesh of 11 cells is larger than the 8 that ids of 32 bits allow");
  }
  EXPECT_EQ(ReadAll(mesh), before);
  SomeMesh<SolidPolicy> larger;
  addPoint(larger);
  ExpectLaws(larger);
}

TEST(CellMarks, AreForOneSearchOnly)
{
  CellMarks marks;
  marks.Start(4);
  marks.Add(3);
  EXPECT_TRUE(marks.Has(3));
  EXPECT_FALSE(marks.Has(2));
  marks.Remove(3);
  EXPECT_FALSE(marks.Has(3));
  marks.Add(1);
  marks.Start(9);
  EXPECT_FALSE(marks.Has(1));
  EXPECT_FALSE(marks.Has(8));
}

TEST(CellSet, ListsEachCellOnceAndWhatWasUnmarkedUntilItStartsAgain)
{
  CellSet cells;
  cells.Start(9);
  for (const Id cell : { 7, 2, 7, 4, 2 })
  {
    cells.Add(cell);
  }
  EXPECT_EQ(cells.Cells(), (std::vector<Id>{ 7, 2, 4 }));
  cells.Unmark(2);
  EXPECT_FALSE(cells.Has(2));
  EXPECT_EQ(cells.Cells().size(), 3u);
  cells.Start(9);
  EXPECT_TRUE(cells.Cells().empty());
  EXPECT_FALSE(cells.Has(7));
}

TEST(IdSet, ListsEachIdOnceUntilItIsCleared)
{
  IdSet ids;
  for (const bool isFirst : { true, false })
  {
    std::vector<Id> added;
    for (Id k = 0; k < 1000; ++k) // more than there is room for at first
    {
      const Id id = isFirst ? 7919 * k : k * k;
      EXPECT_FALSE(ids.Has(id));
      ids.Add(id);
      ids.Add(id);
      added.push_back(id);
    }
    EXPECT_EQ(ids.Members(), added);
    EXPECT_TRUE(std::all_of(added.begin(), added.end(), [&](Id id) { return ids.Has(id); }));
    EXPECT_FALSE(ids.Has(isFirst ? 1 : 7919));
    ids.Clear();
    EXPECT_FALSE(ids.Has(0));
    EXPECT_TRUE(ids.Members().empty());
  }
}

TEST(PendingFaces, AreFoundByTheirCornersAndForgottenAtOnce)
{
  PendingFaces faces;
  faces.Start(1000);
  std::set<Triangle> entered;
  std::mt19937 random(1);
  for (int k = 0; k < 2000; ++k)
  {
    const Id low = static_cast<Id>(random() % 50);
    const Triangle t = { { low, low + 1 + static_cast<Id>(random() % 9), low + 20 } };
    PendingFace& face = faces.At(t);
    ASSERT_EQ(faces.IsTaken(face), entered.count(t) > 0);
    if (entered.insert(t).second)
    {
      faces.Enter(face, t, { low, 2 }, None, k);
    }
    ASSERT_EQ(faces.At(t).Corners, t);
  }
  faces.Start(2);
  for (const Triangle& t : entered)
  {
    ASSERT_FALSE(faces.IsTaken(faces.At(t)));
  }
}

namespace
{
/** The number of triangles of one kind, to be as few as can be; diagonals are counted, too. */
struct CountOfTriangles
{
  static constexpr int Edge = 0;
  static constexpr int Impossible = 1000;
  bool IsBetter(int a, int b) const { return a < b; }
  bool IsEnough(int a) const { return a <= this->Most; }
  int Join(int a, int b) const { return a + b; }
  int OfTriangle(int i, int j, int k) const { return this->Costs[i][j] * 3 + this->Costs[j][k]; }
  int OfDiagonal(int i, int j) const { return i == 0 && j == 5 ? 0 : this->Costs[j][i]; }

  std::array<std::array<int, 6>, 6> Costs;
  int Most;
};

/** The least of all ways, tried one by one. */
int LeastByTrying(const CountOfTriangles& measure, int i, int j)
{
  int best = j == i + 1 ? 0 : CountOfTriangles::Impossible;
  for (int k = i + 1; k < j; ++k)
  {
    best = std::min(best,
      LeastByTrying(measure, i, k) + LeastByTrying(measure, k, j) + measure.OfTriangle(i, k, j) +
        measure.OfDiagonal(i, j));
  }
  return best;
}
} // namespace

TEST(RingTriangulation, IsTheBestOfAllAndOneAnEdgeLess)
{
  std::mt19937 random(1);
  EdgeRing ring = { 10, 11, true, false, { 0, 1, 2, 3, 4, 5 }, {}, {} };
  RingTriangulation<int> triangulation;
  for (int turn = 0; turn < 200; ++turn)
  {
    CountOfTriangles measure;
    for (auto& row : measure.Costs)
    {
      for (int& cost : row)
      {
        cost = static_cast<int>(random() % 7);
      }
    }
    measure.Most = LeastByTrying(measure, 0, 5);
    ASSERT_TRUE(triangulation.Find(measure, 0, 6));
    std::vector<Tetrahedron> fresh;
    triangulation.AppendCells(ring, 0, 5, fresh);
    ASSERT_EQ(fresh.size(), 8u);
    int cost = 0;
    for (std::size_t t = 0; t < fresh.size(); t += 2)
    {
      const auto [i, j, k, end] = fresh[t];
      EXPECT_EQ(end, 11);
      EXPECT_EQ(fresh[t + 1], (Tetrahedron{ { j, i, k, 10 } }));
      cost += measure.OfTriangle(i, j, k) + measure.OfDiagonal(i, k);
    }
    EXPECT_EQ(cost, measure.Most);
    --measure.Most;
    EXPECT_FALSE(triangulation.Find(measure, 0, 6));
  }
}

TYPED_TEST(MeshLaws, HoldAfterAnEdgeGoesForTheTriangulationOfItsRing)
{
  for (Id end = 1; end <= 6; ++end)
  {
    SomeMesh<TypeParam> mesh;
    EdgeRing ring;
    mesh.Ring(0, end, CellsWith(mesh, 0, end).front(), ring);
    ASSERT_EQ(ring.Points.size(), 4u);
    RingTriangulation<int> triangulation;
    ASSERT_TRUE(triangulation.Find(CountOfTriangles{ {}, 0 }, 0, 4));
    std::vector<Tetrahedron> fresh;
    triangulation.AppendCells(ring, 0, 3, fresh);
    mesh.Change(ring.Cells, fresh);
    ExpectLaws(mesh);
    EXPECT_TRUE(CellsWith(mesh, 0, end).empty());
  }
}

TYPED_TEST(MeshLaws, AnEdgeIsFoundWhereAndOnlyWhereACellHasBothEnds)
{
  SomeMesh<TypeParam> mesh;
  EdgeSearch search;
  for (Id u = 0; u <= 6; ++u)
  {
    for (Id v = 0; v <= 6; ++v)
    {
      const Id found = u == v ? None : search.Find(mesh, u, v);
      ASSERT_EQ(found != None, u != v && !CellsWith(mesh, u, v).empty()) << u << ' ' << v;
      EXPECT_TRUE(found == None || (mesh.Has(found, u) && mesh.Has(found, v)));
    }
  }
}

TYPED_TEST(MeshLaws, FacetsAreVisitedFromEachCell)
{
  SomeMesh<TypeParam> mesh;
  const Id cell = mesh.StarOf(0)[0];
  for (int k = 0; k < 4; ++k)
  {
    mesh.MarkFacet(cell, k, k);
  }
  std::array<int, 4> visits = {};
  mesh.VisitFacets([&](Id c, int k) { ++visits[mesh.Cell(c).Facets[k]]; });
  for (int k = 0; k < 4; ++k)
  {
    EXPECT_EQ(visits[k], mesh.Cell(cell).Neighbors[k] == None ? 1 : 2);
  }
}
