// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/DissolvePoint.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace testflips;

namespace
{
bool Dissolve(MeshWithFacets& mesh, Id point, VolumePoints volumePoints = VolumePoints::None)
{
  return DissolvePoint(mesh, point, volumePoints);
}

/** Expect all laws, and that facets cover what they covered, between the segments. */
void ExpectKept(const MeshWithFacets& mesh, const MeshRecord& before)
{
  ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsAreas);
  EXPECT_EQ(
    ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), std::vector<std::string>());
}

/** All paths of a table. */
std::vector<std::vector<Id>> PathsOf(const SegmentTable& segments)
{
  std::vector<std::vector<Id>> paths;
  for (Id segment = 0; segment < segments.Size(); ++segment)
  {
    paths.push_back(segments.Path(segment));
  }
  return paths;
}

/** Points of a facet's plane z = 0, below and above; the facets 0 1 2 and 0 2 3 in it. */
MeshWithFacets TwoFacets()
{
  return MeshWithFacets(MeshOfCells({ { { 0, 0, 0 } }, { { 6, 0, 0 } }, { { 6, 6, 0 } },
                                      { { 0, 6, 0 } }, { { 3, 2, 5 } }, { { 2, 3, -5 } } },
                          Pyramids({ { { 0, 1, 2 } }, { { 0, 2, 3 } } }, { 4, 5 })),
    { { { 0, 1, 2 } }, { { 0, 2, 3 } } });
}
} // namespace

TEST(DissolvePoint, TakesOutOfACellWhatWasPutIn)
{
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 12, 6);
    const MeshRecord before(mesh.Mesh);
    for (const Id cell : FiniteCells(mesh.Mesh))
    {
      const Id point = mesh.Mesh.IsDead(cell) ? None : mesh.SplitCell(cell);
      if (point != None)
      {
        ASSERT_TRUE(Dissolve(mesh, point));
        EXPECT_FALSE(mesh.Mesh.HasVertex(point));
      }
    }
    EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(), before.FiniteCells());
    ExpectFlippableMeshLaws(mesh.Mesh, before);
  }
}

TEST(DissolvePoint, TakesOutOfAFaceWhatWasPutInBeItAFacetOnTheHullOrNeither)
{
  std::array<int, 4> kinds = { { 0, 0, 0, 0 } };
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 10, 4);
    for (int k = 0; k < 12; ++k)
    {
      const std::vector<Id> cells = FiniteCells(mesh.Mesh);
      const MeshFace face = { cells[static_cast<std::size_t>(5 * k) % cells.size()], k % 4 };
      const FlippableCell cell = CellAt(mesh.Mesh, face.Cell);
      const bool isFacet = cell.Facets[face.Face] != None;
      const bool onHull = mesh.Mesh.IsInfinite(cell.Neighbors[face.Face]);
      const MeshRecord before(mesh.Mesh);
      const Id point = mesh.SplitFace(face);
      ExpectKept(mesh, before);
      EXPECT_FALSE(mesh.Mesh.Vertices().IsDouble(point));
      ASSERT_TRUE(Dissolve(mesh, point));
      EXPECT_FALSE(mesh.Mesh.HasVertex(point));
      ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsFaces);
      ++kinds[(isFacet ? 1 : 0) + (onHull ? 2 : 0)];
    }
  }
  for (const int kind : kinds)
  {
    EXPECT_GT(kind, 2);
  }
}

TEST(DissolvePoint, TakesOutOfASegmentWhatWasPutIn)
{
  int dissolved = 0;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 10, 4);
    for (Id segment = 0; segment < mesh.Segments.Size(); segment += 3)
    {
      const MeshRecord before(mesh.Mesh);
      const std::array<Id, 2> ends = mesh.Segments.EndsOf(segment);
      const Id point = mesh.SplitEdge(ends[0], ends[1]);
      ASSERT_EQ(mesh.Segments.Path(segment), (std::vector<Id>{ ends[0], point, ends[1] }));
      ExpectKept(mesh, before);
      ASSERT_TRUE(Dissolve(mesh, point)) << "seed " << seed << " segment " << segment;
      EXPECT_FALSE(mesh.Mesh.HasVertex(point));
      EXPECT_EQ(mesh.Segments.Path(segment), (std::vector<Id>{ ends[0], ends[1] }));
      ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsFaces);
      ++dissolved;
    }
  }
  EXPECT_GT(dissolved, 30);
}

TEST(DissolvePoint, TakesOutOfAnInnerEdgeWhatWasPutIn)
{
  int dissolved = 0;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    MeshWithFacets mesh(DelaunayMesh(AnyPoints(seed, 12)), {});
    for (const Id cell : FiniteCells(mesh.Mesh))
    {
      const Id u = CellAt(mesh.Mesh, cell).Corners[0];
      const Id v = CellAt(mesh.Mesh, cell).Corners[1];
      EdgeRing ring;
      if (mesh.Mesh.IsDead(cell))
      {
        continue;
      }
      mesh.Mesh.Ring(u, v, cell, ring);
      if (std::find(ring.Points.begin(), ring.Points.end(), mesh.Mesh.Infinite()) !=
        ring.Points.end())
      {
        continue;
      }
      const MeshRecord before(mesh.Mesh);
      const Id point = mesh.SplitEdge(u, v);
      ASSERT_TRUE(Dissolve(mesh, point));
      ExpectFlippableMeshLaws(mesh.Mesh, before);
      ++dissolved;
    }
  }
  EXPECT_GT(dissolved, 30);
}

TEST(DissolvePoint, ASegmentWithoutFacetsStaysWhenItsPointGoes)
{
  // Three cells around the edge 3 4, which a facet has that is not there.
  MeshWithFacets mesh(MeshOfCells({ { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } },
                                    { { 2, 2, 9 } }, { { 3, 3, -9 } } },
                        { { { 4, 3, 0, 1 } }, { { 4, 3, 1, 2 } }, { { 4, 3, 2, 0 } } }),
    { { { 3, 4, 0 } } });
  const MeshFace face = mesh.Mesh.FindFaces({ { { 3, 4, 0 } } })[0];
  mesh.Mesh.SetFacet(face.Cell, face.Face, None);
  const MeshRecord before(mesh.Mesh);
  const Id point = mesh.SplitEdge(3, 4, { 3, 1 });
  EXPECT_TRUE(Dissolve(mesh, point));
  EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(), before.FiniteCells());
  EXPECT_EQ(mesh.Segments.Find(3, 4), 0);
  ExpectFlippableMeshLaws(mesh.Mesh, before);
}

TEST(DissolvePoint, TwoFacetsOnASegmentAreWholeAgain)
{
  MeshWithFacets mesh = TwoFacets();
  const MeshRecord before(mesh.Mesh);
  const Id first = mesh.SplitEdge(0, 2, { 3, 1 });
  const Id second = mesh.SplitEdge(first, 2);
  const Id third = mesh.SplitFace(mesh.Mesh.FindFaces({ { { first, second, 1 } } })[0]);
  EXPECT_EQ(FacesOfFacets(MeshRecord(mesh.Mesh))[0].size(), 5u);
  for (const Id point : { third, first, second })
  {
    EXPECT_TRUE(Dissolve(mesh, point));
    ExpectKept(mesh, before);
  }
  EXPECT_EQ(MeshRecord(mesh.Mesh).FiniteCells(), before.FiniteCells());
  EXPECT_EQ(FacesOfFacets(MeshRecord(mesh.Mesh)), FacesOfFacets(before));
}

TEST(DissolvePoint, TakesAPointOutOfASegmentWithSteinerPointsInTheFacets)
{
  // From the segment first, while the facets' own points are in the way.
  MeshWithFacets mesh = TwoFacets();
  const MeshRecord before(mesh.Mesh);
  const Id onSegment = mesh.SplitEdge(0, 2, { 5, 3 });
  const Id inFirst = mesh.SplitFace(mesh.Mesh.FindFaces({ { { onSegment, 2, 1 } } })[0]);
  const Id inSecond = mesh.SplitFace(mesh.Mesh.FindFaces({ { { onSegment, 0, 3 } } })[0]);
  for (const Id point : { onSegment, inFirst, inSecond })
  {
    EXPECT_TRUE(Dissolve(mesh, point, VolumePoints::AsNeeded)) << point;
    EXPECT_FALSE(mesh.Mesh.HasVertex(point));
    ExpectKept(mesh, before);
  }
  EXPECT_EQ(FacesOfFacets(MeshRecord(mesh.Mesh)), FacesOfFacets(before));
}

TEST(DissolvePoint, APointThatNoCornerReplacesStaysOrGoesIntoTheVolume)
{
  int stayed = 0;
  int intoVolume = 0;
  int gone = 0;
  for (unsigned seed = 1; seed <= 45; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 12, 6);
    std::mt19937 random(seed);
    const MeshRecord whole(mesh.Mesh);
    std::vector<Id> steiner;
    for (Id segment = 0; segment < mesh.Segments.Size(); segment += 4)
    {
      const std::array<Id, 2> ends = mesh.Segments.EndsOf(segment);
      steiner.push_back(mesh.SplitEdge(ends[0], ends[1]));
    }
    for (int k = 0; k < 3; ++k)
    {
      const std::vector<Id> cells = FiniteCells(mesh.Mesh);
      steiner.push_back(
        mesh.SplitFace({ cells[random() % cells.size()], static_cast<int>(random() % 4) }));
    }
    mesh.FlipAtRandom(random, 60);
    for (const Id point : steiner)
    {
      const MeshRecord before(mesh.Mesh);
      const std::vector<std::vector<Id>> paths = PathsOf(mesh.Segments);
      if (Dissolve(mesh, point))
      {
        EXPECT_EQ(mesh.Mesh.Vertices().Size(), static_cast<Id>(before.Places.size()));
        ++gone;
      }
      else
      {
        ExpectUnchanged(mesh.Mesh, before);
        EXPECT_EQ(PathsOf(mesh.Segments), paths);
        if (!Dissolve(mesh, point, VolumePoints::AsNeeded))
        {
          ExpectUnchanged(mesh.Mesh, before);
          EXPECT_EQ(PathsOf(mesh.Segments), paths);
          ++stayed;
          continue;
        }
        EXPECT_GT(mesh.Mesh.Vertices().Size(), static_cast<Id>(before.Places.size()));
        ++intoVolume;
      }
      EXPECT_FALSE(mesh.Mesh.HasVertex(point));
      ExpectKept(mesh, whole);
    }
  }
  EXPECT_GT(gone, 20);
  EXPECT_GT(intoVolume, 3);
  EXPECT_GT(stayed, 0);
}

TEST(DissolvePoint, ACornerOfAFacetOrOfTheHullStays)
{
  MeshWithFacets mesh = RandomMeshWithFacets(2, 16, 10);
  const MeshRecord before(mesh.Mesh);
  const std::vector<std::vector<Id>> paths = PathsOf(mesh.Segments);
  std::set<Id> onHull;
  for (Id cell = 0; cell < NumberOfCells(mesh.Mesh); ++cell)
  {
    for (const Id corner : CellAt(mesh.Mesh, cell).Corners)
    {
      if (mesh.Mesh.IsInfinite(cell) && corner != mesh.Mesh.Infinite())
      {
        onHull.insert(corner);
      }
    }
  }
  std::set<Id> onSegments;
  for (const Triangle& facet : mesh.Facets)
  {
    onSegments.insert(facet.begin(), facet.end());
  }
  for (const Id corner : onHull)
  {
    if (onSegments.count(corner) == 0)
    {
      EXPECT_FALSE(Dissolve(mesh, corner, VolumePoints::AsNeeded));
    }
  }
  ExpectUnchanged(mesh.Mesh, before);
  EXPECT_EQ(PathsOf(mesh.Segments), paths);
}

TEST(DissolvePoint, APointOnAnEdgeOfTheHullWithoutASegmentStays)
{
  MeshWithFacets mesh(
    DelaunayMesh({ { { 0, 0, 0 } }, { { 9, 0, 0 } }, { { 0, 9, 0 } }, { { 0, 0, 9 } } }), {});
  const Id point = mesh.SplitEdge(1, 2);
  const MeshRecord before(mesh.Mesh);
  EXPECT_FALSE(Dissolve(mesh, point, VolumePoints::AsNeeded));
  ExpectUnchanged(mesh.Mesh, before);
}

TEST(DissolvePoint, APointThatIsInNoCellStaysOut)
{
  MeshWithFacets mesh = TwoFacets();
  const Id point = mesh.Mesh.AddVertex({ { 1, 1, 1 } });
  const MeshRecord before(mesh.Mesh);
  EXPECT_FALSE(Dissolve(mesh, point, VolumePoints::AsNeeded));
  ExpectUnchanged(mesh.Mesh, before);
}
