// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactState.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace testflips;

namespace
{
/** A mesh with Steiner points on edges, faces and in cells, constraints among them. */
MeshWithFacets SplitAtRandom(unsigned seed)
{
  MeshWithFacets mesh = RandomMeshWithFacets(seed, 16, 12);
  std::mt19937 random(seed);
  for (int k = 0; k < 5; ++k)
  {
    const std::vector<Id> path =
      mesh.Segments.Path(static_cast<Id>(random() % static_cast<unsigned>(mesh.Segments.Size())));
    mesh.SplitEdge(path[0], path[1]);
    for (const bool cell : { false, true })
    {
      const std::vector<Id> cells = FiniteCells(mesh.Mesh);
      const Id any = cells[random() % cells.size()];
      cell ? mesh.SplitCell(any) : mesh.SplitFace({ any, static_cast<int>(random() % 4) });
    }
  }
  return mesh;
}

/** The facets of which a face has the vertex: all cells are looked at. */
std::vector<Id> FacetsAt(const FlippableMesh& mesh, Id vertex)
{
  std::set<Id> facets;
  for (const Id cell : FiniteCells(mesh))
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle corners = mesh.FaceCorners(cell, k);
      if (mesh.Cell(cell).Facets[k] != None &&
        std::count(corners.begin(), corners.end(), vertex) > 0)
      {
        facets.insert(mesh.Cell(cell).Facets[k]);
      }
    }
  }
  return { facets.begin(), facets.end() };
}

/** The segment whose path has the point between its ends. */
Id SegmentAround(const SegmentTable& segments, Id point)
{
  for (Id segment = 0; segment < segments.Size(); ++segment)
  {
    const std::vector<Id> path = segments.Path(segment);
    if (std::find(path.begin() + 1, path.end() - 1, point) != path.end() - 1)
    {
      return segment;
    }
  }
  return None;
}
} // namespace

TEST(ExactState, SupportOfNamesTheFacetsOfEachPointAndTheSegmentThatItIsWithin)
{
  int onSegments = 0;
  int onFacets = 0;
  int onNothing = 0;
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const MeshWithFacets mesh = SplitAtRandom(seed);
    for (Id vertex = 0; vertex < mesh.Mesh.Vertices().Size(); ++vertex)
    {
      if (vertex == mesh.Mesh.Infinite())
      {
        continue;
      }
      const PointSupport support = mesh.SupportOf(vertex);
      EXPECT_EQ(support.Facets, FacetsAt(mesh.Mesh, vertex));
      EXPECT_EQ(support.Segment, SegmentAround(mesh.Segments, vertex));
      ++(support.Segment != None ? onSegments : support.Facets.empty() ? onNothing : onFacets);
    }
  }
  EXPECT_GT(onSegments, 10);
  EXPECT_GT(onFacets, 10);
  EXPECT_GT(onNothing, 10);
}

TEST(ExactState, SupportOfAPointWithinASegmentIsTheSegmentAndAllFacetsAroundIt)
{
  MeshWithFacets mesh(MeshOfCells({ { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } },
                                    { { 2, 2, 9 } }, { { 3, 3, -9 } } },
                        Pyramids({ { { 0, 1, 2 } } }, { 3, 4 })),
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 2, 4 } } });
  const Id onSegment = mesh.SplitEdge(0, 1);
  const Id onFreeEdge = mesh.SplitEdge(0, 4);
  const Id onFacet = mesh.SplitFace(mesh.Mesh.FindFaces({ { { 1, 2, 4 } } })[0]);
  const Id inVolume = mesh.SplitCell(FiniteCells(mesh.Mesh)[0]);
  const auto supportOf = [&](Id vertex) { return mesh.SupportOf(vertex); };
  EXPECT_EQ(supportOf(onSegment).Segment, mesh.Segments.OfFacet(0, 0));
  EXPECT_EQ(supportOf(onSegment).Facets, (std::vector<Id>{ 0, 1 }));
  EXPECT_EQ(supportOf(onFacet).Segment, None);
  EXPECT_EQ(supportOf(onFacet).Facets, (std::vector<Id>{ 2 }));
  for (const Id vertex : { onFreeEdge, inVolume })
  {
    EXPECT_EQ(supportOf(vertex).Segment, None);
    EXPECT_TRUE(supportOf(vertex).Facets.empty());
  }
}

TEST(ExactState, SupportOfAVertexThatIsInNoCellIsNothing)
{
  MeshWithFacets mesh = RandomMeshWithFacets(1, 10, 2);
  const Id vertex = mesh.Mesh.AddVertex({ { 1, 1, 1 } });
  const PointSupport support = mesh.SupportOf(vertex);
  EXPECT_EQ(support.Segment, None);
  EXPECT_TRUE(support.Facets.empty());
}
