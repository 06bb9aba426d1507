// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/SteinerPoints.h"

#include "Exact/RecoverFacets.h"
#include "Exact/RecoverSegments.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace testflips;

namespace
{
/** A mesh with Steiner points in cells, on faces and on edges, flipped at random. */
MeshWithFacets WithSteinerPoints(unsigned seed, bool onConstraints, WorkBudget& work = AnyWork())
{
  MeshWithFacets mesh = RandomMeshWithFacets(seed, 14, 8, work);
  std::mt19937 random(seed);
  for (int k = 0; k < 4; ++k)
  {
    std::vector<Id> cells = FiniteCells(mesh.Mesh);
    mesh.SplitCell(cells[random() % cells.size()]);
    if (onConstraints)
    {
      cells = FiniteCells(mesh.Mesh);
      mesh.SplitFace({ cells[random() % cells.size()], static_cast<int>(random() % 4) });
      const std::vector<Id> path =
        mesh.Segments.Path(static_cast<Id>(random() % static_cast<unsigned>(mesh.Segments.Size())));
      mesh.SplitEdge(path[0], path[1]);
    }
  }
  mesh.FlipAtRandom(random, 30);
  return mesh;
}

std::vector<Id> SteinerPointsOf(const FlippableMesh& mesh)
{
  std::vector<Id> points;
  for (Id p = mesh.Infinite() + 1; p < mesh.Vertices().Size(); ++p)
  {
    if (mesh.HasVertex(p))
    {
      points.push_back(p);
    }
  }
  return points;
}

/** Cut all facets into a mesh. */
void RecoverAll(MeshWithFacets& mesh)
{
  std::vector<Id> segments(static_cast<std::size_t>(mesh.Segments.Size()));
  std::iota(segments.begin(), segments.end(), 0);
  std::vector<Id> facets(mesh.Facets.size());
  std::iota(facets.begin(), facets.end(), 0);
  const std::vector<Id> left = RecoverSegmentsByFlips(mesh, FindMissingSegments(mesh, segments));
  EXPECT_TRUE(RecoverSegmentsBySplits(mesh, left, SplitFrom::Middle).empty());
  EXPECT_TRUE(RecoverFacetsBySplits(mesh, MarkWholeFacets(mesh, facets)).empty());
}

void ExpectKept(const MeshWithFacets& mesh, const MeshRecord& before)
{
  ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsAreas);
  EXPECT_EQ(
    ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), std::vector<std::string>());
}
} // namespace

TEST(SteinerPoints, TidyingTakesAllOutOfTheVolumeThatNothingNeedsAndShakingTheRest)
{
  std::size_t before = 0;
  std::size_t left = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    MeshWithFacets mesh = WithSteinerPoints(seed, false);
    const MeshRecord record(mesh.Mesh);
    before += SteinerPointsOf(mesh.Mesh).size();
    Tidy(mesh, mesh.Mesh.Infinite() + 1);
    left += SteinerPointsOf(mesh.Mesh).size();
    for (int k = 0; k < ShakesWithoutGain && !SteinerPointsOf(mesh.Mesh).empty(); ++k)
    {
      Shake(mesh, SteinerPointsOf(mesh.Mesh));
    }
    EXPECT_EQ(SteinerPointsOf(mesh.Mesh), std::vector<Id>()) << "seed " << seed;
    ExpectKept(mesh, record);
  }
  EXPECT_GT(before, 100u);
  EXPECT_LT(left, before / 50);
}

TEST(SteinerPoints, TidyingTakesPointsOffTheSurfaceAndKeepsIt)
{
  std::size_t before = 0;
  std::size_t after = 0;
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    MeshWithFacets mesh = WithSteinerPoints(seed, true);
    const MeshRecord record(mesh.Mesh);
    before += SteinerPointsOf(mesh.Mesh).size();
    Tidy(mesh, mesh.Mesh.Infinite() + 1);
    after += SteinerPointsOf(mesh.Mesh).size();
    ExpectKept(mesh, record);
    for (Id segment = 0; segment < mesh.Segments.Size(); ++segment)
    {
      for (const Id point : mesh.Segments.Path(segment))
      {
        EXPECT_TRUE(mesh.Mesh.HasVertex(point));
      }
    }
  }
  EXPECT_LT(after, before / 4);
}

TEST(SteinerPoints, TidyingLeavesThoseAloneThatWereThereBefore)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    MeshWithFacets mesh = WithSteinerPoints(seed, true);
    const std::vector<Id> old = SteinerPointsOf(mesh.Mesh);
    const Id first = mesh.Mesh.Vertices().Size();
    const std::vector<Id> cells = FiniteCells(mesh.Mesh);
    const Id fresh = mesh.SplitCell(cells[seed]);
    Tidy(mesh, first);
    EXPECT_EQ(SteinerPointsOf(mesh.Mesh), old);
    EXPECT_TRUE(fresh == None || !mesh.Mesh.HasVertex(fresh));
    ExpectFlippableMeshLaws(mesh.Mesh);
  }
}

TEST(SteinerPoints, TidyingLeavesThoseAloneAroundWhichNothingHasChanged)
{
  std::size_t touched = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    MeshWithFacets mesh = WithSteinerPoints(seed, false);
    const Id first = mesh.Mesh.Infinite() + 1;
    const std::vector<Id> points = SteinerPointsOf(mesh.Mesh);
    const MeshRecord before(mesh.Mesh);
    const std::int64_t since = mesh.Mesh.NumberOfChanges();
    Tidy(mesh, first, since);
    ExpectUnchanged(mesh.Mesh, before);
    if (!points.empty())
    {
      mesh.Mesh.Touch(points[0]);
      Tidy(mesh, first, since);
      touched += mesh.Mesh.HasVertex(points[0]) ? 0 : 1;
      ExpectKept(mesh, before);
    }
  }
  EXPECT_GT(touched, 6u);
}

TEST(SteinerPoints, FlippingAroundAVertexChangesItsCellsAndNoConstraint)
{
  int changed = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    MeshWithFacets mesh = WithSteinerPoints(seed, true);
    const MeshRecord before(mesh.Mesh);
    mesh.Random.seed(seed);
    for (const Id vertex : { 0, 3, 5 })
    {
      FlipAround(mesh, vertex);
    }
    ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsFaces);
    changed += MeshRecord(mesh.Mesh).FiniteCells() != before.FiniteCells() ? 1 : 0;
  }
  EXPECT_GT(changed, 6);
}

TEST(SteinerPoints, ShakingGetsRidOfMoreAndKeepsTheSurface)
{
  std::size_t tidied = 0;
  std::size_t shaken = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    std::mt19937 random(seed);
    const std::vector<Point> points = AnyPoints(seed, 20);
    MeshWithFacets mesh(DelaunayMesh(points), FacetsThatDoNotMeet(points, random, 80));
    RecoverAll(mesh);
    const MeshRecord before(mesh.Mesh);
    tidied += SteinerPointsOf(mesh.Mesh).size();
    for (int k = 0; k < 4; ++k)
    {
      Shake(mesh, SteinerPointsOf(mesh.Mesh));
      ExpectKept(mesh, before);
    }
    shaken += SteinerPointsOf(mesh.Mesh).size();
  }
  EXPECT_LT(shaken, tidied);
}

TEST(SteinerPoints, OnceItsWorkIsDoneTidyingChangesNothing)
{
  WorkBudget none(0);
  MeshWithFacets mesh = WithSteinerPoints(2, true, none);
  const MeshRecord before(mesh.Mesh);
  ASSERT_TRUE(none.IsUsedUp());
  Tidy(mesh, mesh.Mesh.Infinite() + 1);
  ExpectUnchanged(mesh.Mesh, before);
}
