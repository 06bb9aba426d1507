// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PullSegments.h"

#include "Common/Team.h"
#include "Exact/RecoverSegments.h"
#include "Exact/VertexBlocks.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/AllowedThreads.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"
#include "Support/TetrahedralizationFamilies.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace testflips;

namespace
{
/** Blocks so small that small surfaces have many. */
constexpr std::size_t FewVertices = 12;

TriangleSoup AnySurface(unsigned seed)
{
  std::mt19937 random(seed);
  TriangleSoup any = { AnyPoints(seed, 60), {} };
  any.Triangles = FacetsThatDoNotMeet(any.Points, random, 100);
  return any;
}

/** Facets at random, and each family of surfaces that are hard to tetrahedralize. */
std::vector<TriangleSoup> Surfaces(unsigned seed)
{
  std::vector<TriangleSoup> surfaces(1, AnySurface(seed));
  Monitor monitor;
  for (const testmeshes::SurfaceFamily& family : testmeshes::TetrahedralizationFamilies(seed))
  {
    for (const TriangleSoup& soup : family.Members)
    {
      const FacetComplex surface =
        ResolveSelfIntersections(CountFacets(soup, {}, monitor).Surface, monitor).Surface;
      surfaces.push_back({ surface.Points,
        { surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints } });
    }
  }
  return surfaces;
}

std::vector<Id> MissingIn(const ExactState& state)
{
  std::vector<Id> all(static_cast<std::size_t>(state.Segments.Size()));
  std::iota(all.begin(), all.end(), 0);
  return FindMissingSegments(state, all);
}

/** All cells in order, dead ones included, with their neighbors and facets. */
std::vector<Id> CellsOf(const FlippableMesh& mesh)
{
  std::vector<Id> numbers;
  for (Id id = 0; id < NumberOfCells(mesh); ++id)
  {
    const FlippableCell& cell = CellAt(mesh, id);
    numbers.push_back(cell.Corners[0]);
    for (int k = 0; k < 4 && !mesh.IsDead(id); ++k)
    {
      numbers.insert(numbers.end(), { cell.Corners[k], cell.Neighbors[k], cell.Facets[k] });
    }
  }
  return numbers;
}

/** A state whose segments have been pulled. */
struct Pulled
{
  Pulled(const TriangleSoup& soup, std::size_t verticesPerBlock)
    : State(soup.Points, soup.Triangles, this->Work, AnyMonitor())
    , Missing(MissingIn(this->State))
    , Left(RecoverSegmentsByPulls(this->State, this->Missing, verticesPerBlock))
  {
  }

  WorkBudget Work;
  ExactState State;
  std::vector<Id> Missing;
  std::vector<Id> Left;
};

/** A state divided into two blocks. */
struct Divided
{
  explicit Divided(unsigned seed, WorkBudget& work = AnyWork(), Monitor& monitor = AnyMonitor())
    : Divided(AnySurface(seed), work, monitor)
  {
  }

  Divided(const TriangleSoup& soup, WorkBudget& work, Monitor& monitor)
    : State(soup.Points, soup.Triangles, work, monitor)
    , Missing(MissingIn(this->State))
    , BlockOf(BlocksOfVertices(this->State.Mesh, 1))
  {
  }

  std::vector<Id> Pull() { return PullInBlocks(this->State, this->Missing, this->BlockOf, 2); }

  bool IsInOneBlock(const Tetrahedron& cell) const
  {
    const Id block = this->BlockOf[cell[0]];
    return block != None &&
      std::all_of(
        cell.begin(), cell.end(), [&](Id corner) { return this->BlockOf[corner] == block; });
  }

  ExactState State;
  std::vector<Id> Missing;
  std::vector<Id> BlockOf;
};
} // namespace

TEST(PullSegments, SameBytesOnAnyNumberOfThreads)
{
  const WholeTeams teams;
  for (unsigned seed = 1; seed <= 2; ++seed)
  {
    for (const TriangleSoup& soup : Surfaces(seed))
    {
      const testthreads::Allowed one(1);
      const Pulled expected(soup, FewVertices);
      for (const int threads : { 2, 8 })
      {
        const testthreads::Allowed several(threads);
        const Pulled result(soup, FewVertices);
        EXPECT_TRUE(CellsOf(result.State.Mesh) == CellsOf(expected.State.Mesh));
        EXPECT_EQ(result.Left, expected.Left);
        EXPECT_EQ(result.Work.Spent(), expected.Work.Spent());
        EXPECT_EQ(result.State.Mesh.NumberOfChanges(), expected.State.Mesh.NumberOfChanges());
      }
    }
  }
}

TEST(PullSegments, RecoversAboutAsManyInManyBlocksAsInOne)
{
  std::size_t missing = 0;
  std::size_t inOne = 0;
  std::size_t inMany = 0;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    for (const TriangleSoup& soup : Surfaces(seed))
    {
      const Pulled one(soup, VerticesPerBlock);
      missing += one.Missing.size();
      inOne += one.Left.size();
      inMany += Pulled(soup, FewVertices).Left.size();
    }
  }
  EXPECT_GT(missing - inOne, 1000u);
  EXPECT_LT(inMany, inOne + (missing - inOne) / 20);
}

TEST(PullSegments, ChangesOnlyCellsWithAllCornersInOneBlockAndPutsOffTheRest)
{
  std::size_t pulled = 0;
  std::size_t putOff = 0;
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    Divided divided(seed);
    const MeshRecord before(divided.State.Mesh);
    const std::vector<Id> left = divided.Pull();
    ExpectFlippableMeshLaws(divided.State.Mesh, before);
    const std::set<Tetrahedron> cellsBefore = before.FiniteCells();
    const std::set<Tetrahedron> cells = MeshRecord(divided.State.Mesh).FiniteCells();
    std::vector<Tetrahedron> changed;
    std::set_symmetric_difference(cellsBefore.begin(), cellsBefore.end(), cells.begin(),
      cells.end(), std::back_inserter(changed));
    for (const Tetrahedron& cell : changed)
    {
      EXPECT_TRUE(divided.IsInOneBlock(cell));
    }
    for (const Id segment : divided.Missing)
    {
      const std::array<Id, 2>& ends = divided.State.Segments.EndsOf(segment);
      const bool isLeft = std::find(left.begin(), left.end(), segment) != left.end();
      EXPECT_TRUE(isLeft || divided.BlockOf[ends[0]] == divided.BlockOf[ends[1]]);
    }
    putOff += left.size();
    pulled += divided.Missing.size() - MissingIn(divided.State).size();
  }
  EXPECT_GT(pulled, 50u);
  EXPECT_GT(putOff, 100u);
}

TEST(PullSegments, PutsAllOffWithoutWorkLeft)
{
  WorkBudget work(0);
  work.Spend(1);
  Divided divided(1, work);
  const MeshRecord before(divided.State.Mesh);
  EXPECT_EQ(divided.Pull(), divided.Missing);
  EXPECT_EQ(MeshRecord(divided.State.Mesh).FiniteCells(), before.FiniteCells());
}

TEST(PullSegments, StopsBetweenBlocks)
{
  class Stop : public Monitor
  {
  public:
    bool Continue(const char* /*stage*/, double /*fraction*/) override { return !this->IsOn; }
    bool IsOn = false;
  };
  Stop stop;
  Divided divided(1, AnyWork(), stop);
  stop.IsOn = true;
  try
  {
    divided.Pull();
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Stopped);
  }
  ExpectFlippableMeshLaws(divided.State.Mesh);
}

TEST(PullSegments, AreOneBlockWhileAJournalIsKept)
{
  const TriangleSoup soup = AnySurface(3);
  WorkBudget work;
  ExactState state(soup.Points, soup.Triangles, work, AnyMonitor());
  const MeshRecord before(state.Mesh);
  const std::vector<Id> missing = MissingIn(state);
  state.Mesh.StartJournal();
  EXPECT_LT(RecoverSegmentsByPulls(state, missing, FewVertices).size(), missing.size());
  state.Mesh.GoBack();
  ExpectUnchanged(state.Mesh, before);
}

TEST(VertexBlocks, HaveAboutAsManyVerticesEachAndTheInfiniteOneIsInNone)
{
  std::mt19937 random(1);
  const FlippableMesh mesh = DelaunayMesh(RandomPoints(random, 4000));
  const std::vector<Id> blocks = BlocksOfVertices(mesh, 4);
  ASSERT_EQ(blocks.size(), 4001u);
  EXPECT_EQ(blocks[static_cast<std::size_t>(mesh.Infinite())], None);
  for (Id block = 0; block < 16; ++block)
  {
    const std::ptrdiff_t vertices = std::count(blocks.begin(), blocks.end(), block);
    EXPECT_GT(vertices, 150);
    EXPECT_LT(vertices, 350);
  }
}
