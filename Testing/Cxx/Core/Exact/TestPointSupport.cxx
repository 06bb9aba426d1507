// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PointSupport.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

using namespace testflips;

TEST(PointSupport, NamesTheFacetsAndASegmentOfEachVertex)
{
  int onSegments = 0;
  int onNothing = 0;
  for (unsigned seed = 1; seed <= 6; ++seed)
  {
    const MeshWithFacets mesh = RandomMeshWithFacets(seed, 16, 12);
    for (Id vertex = 0; vertex < mesh.Mesh.Infinite(); ++vertex)
    {
      std::vector<Id> facets;
      std::set<Id> segments;
      for (Id f = 0; f < static_cast<Id>(mesh.Facets.size()); ++f)
      {
        for (int k = 0; k < 3; ++k)
        {
          if (mesh.Facets[f][k] == vertex)
          {
            facets.push_back(f);
            segments.insert(mesh.Segments.OfFacet(f, k));
          }
        }
      }
      const PointSupport support = FindPointSupport(mesh.Mesh, mesh.Segments, vertex);
      EXPECT_EQ(support.Facets, facets);
      EXPECT_EQ(support.Segment != None, !segments.empty());
      if (support.Segment != None)
      {
        const std::array<Id, 2>& ends = mesh.Segments.EndsOf(support.Segment);
        EXPECT_TRUE(ends[0] == vertex || ends[1] == vertex);
        ++onSegments;
      }
      else
      {
        ++onNothing;
      }
    }
  }
  EXPECT_GT(onSegments, 10);
  EXPECT_GT(onNothing, 10);
}

TEST(PointSupport, OfAPointWithinASegmentIsTheSegmentAndAllFacetsAroundIt)
{
  MeshWithFacets mesh(MeshOfCells({ { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } },
                                    { { 2, 2, 9 } }, { { 3, 3, -9 } } },
                        Pyramids({ { { 0, 1, 2 } } }, { 3, 4 })),
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 2, 4 } } });
  const Id onSegment = mesh.SplitEdge(0, 1);
  const Id onFreeEdge = mesh.SplitEdge(0, 4);
  const Id onFacet = mesh.SplitFace(mesh.Mesh.FindFaces({ { { 1, 2, 4 } } })[0]);
  const Id inVolume = mesh.SplitCell(FiniteCells(mesh.Mesh)[0]);
  const auto supportOf = [&](Id vertex)
  { return FindPointSupport(mesh.Mesh, mesh.Segments, vertex); };
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

TEST(PointSupport, OfAVertexThatIsInNoCellIsNothing)
{
  MeshWithFacets mesh = RandomMeshWithFacets(1, 10, 2);
  const Id vertex = mesh.Mesh.AddVertex({ { 1, 1, 1 } });
  const PointSupport support = FindPointSupport(mesh.Mesh, mesh.Segments, vertex);
  EXPECT_EQ(support.Segment, None);
  EXPECT_TRUE(support.Facets.empty());
}
