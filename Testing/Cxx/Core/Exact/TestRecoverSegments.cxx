// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverSegments.h"

#include "Exact/PullSegments.h"
#include "Exact/SegmentWalk.h"
#include "Support/ExactReference.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace testflips;

namespace
{
using From = SplitFrom;

/** A mesh, segments that it may lack, and what recovers them. */
struct Recovery
{
  Recovery(const std::vector<Point>& points, const std::vector<Triangle>& facets)
    : Mesh(DelaunayMesh(points), facets)
  {
  }

  std::vector<Id> Missing() const
  {
    std::vector<Id> all;
    for (Id segment = 0; segment < this->Mesh.Segments.Size(); ++segment)
    {
      all.push_back(segment);
    }
    return FindMissingSegments(this->Mesh, all);
  }

  /** Expect that the mesh has every segment but some, split into edges on it. */
  void ExpectThere(const std::vector<Id>& missing) const
  {
    const MeshRecord record(this->Mesh.Mesh);
    for (Id segment = 0; segment < this->Mesh.Segments.Size(); ++segment)
    {
      if (std::find(missing.begin(), missing.end(), segment) != missing.end())
      {
        continue;
      }
      const std::vector<Id> path = this->Mesh.Segments.Path(segment);
      const Vector& a = record.Places[path.front()];
      const Vector along = testmeshes::Minus(record.Places[path.back()], a);
      Rational before = -1;
      for (std::size_t k = 0; k < path.size(); ++k)
      {
        const Vector to = testmeshes::Minus(record.Places[path[k]], a);
        const Vector aside = testmeshes::Cross(to, along);
        const Rational share = testmeshes::Dot(to, along);
        const bool isFree =
          path[k] > record.Infinite && this->Mesh.Mesh.Vertices().IsDouble(path[k]);
        EXPECT_TRUE(isFree || testmeshes::Dot(aside, aside) == 0);
        EXPECT_TRUE(share > before);
        before = share;
        EXPECT_TRUE(k == 0 || this->Mesh.Mesh.FindEdge(path[k - 1], path[k]) != None);
      }
    }
  }

  MeshWithFacets Mesh;
};

} // namespace

TEST(RecoverSegments, FindsThoseThatAreNoEdges)
{
  int missing = 0;
  int there = 0;
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    std::mt19937 random(seed);
    const std::vector<Point> points = AnyPoints(seed, 14);
    std::vector<Triangle> facets;
    for (Id k = 0; k + 2 < 14; ++k)
    {
      facets.push_back({ { k, k + 1, k + 2 } });
    }
    Recovery recovery(points, facets);
    const std::vector<Id> found = recovery.Missing();
    for (Id segment = 0; segment < recovery.Mesh.Segments.Size(); ++segment)
    {
      const std::array<Id, 2>& ends = recovery.Mesh.Segments.EndsOf(segment);
      bool isEdge = false;
      for (const Id cell : FiniteCells(recovery.Mesh.Mesh))
      {
        isEdge = isEdge ||
          (recovery.Mesh.Mesh.Has(cell, ends[0]) && recovery.Mesh.Mesh.Has(cell, ends[1]));
      }
      EXPECT_EQ(std::count(found.begin(), found.end(), segment), isEdge ? 0 : 1);
      (isEdge ? there : missing) += 1;
    }
  }
  EXPECT_GT(missing, 5);
  EXPECT_GT(there, 5);
}

TEST(RecoverSegments, FlipsTheFaceAwayThatASegmentPassesThrough)
{
  // Two cells, and the segment from apex to apex.
  Recovery recovery(
    { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } }, { { 2, 2, 9 } }, { { 3, 3, -9 } } },
    { { { 3, 4, 0 } } });
  ASSERT_EQ(recovery.Missing(), (std::vector<Id>{ 0 }));
  const MeshRecord before(recovery.Mesh.Mesh);
  EXPECT_TRUE(RecoverSegmentsByFlips(recovery.Mesh, { 0 }).empty());
  EXPECT_EQ(MeshRecord(recovery.Mesh.Mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 3, 4 } }, { { 1, 2, 3, 4 } }, { { 0, 2, 3, 4 } } }));
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
}

TEST(RecoverSegments, NoFlipsHaveAllEdgesOfSchoenhardtsPolyhedronAndASteinerPointHas)
{
  // With them all its faces were there, and it cannot be filled without another point. Turned the
  // other way the prism is convex.
  for (const double turn : { 0.3, -0.3, -0.6 })
  {
    const TriangleSoup prism = testmeshes::TwistedPrism(3, turn);
    for (const From from : { From::Middle, From::HigherEnd })
    {
      Recovery recovery(prism.Points, prism.Triangles);
      const MeshRecord before(recovery.Mesh.Mesh);
      const std::vector<Id> missing = RecoverSegmentsByFlips(recovery.Mesh, recovery.Missing());
      ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
      EXPECT_EQ(missing.empty(), turn > 0) << turn;
      recovery.ExpectThere(missing);
      EXPECT_TRUE(RecoverSegmentsBySplits(recovery.Mesh, missing, from).empty());
      ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
      recovery.ExpectThere({});
      bool hasSteinerPoint = false;
      for (Id p = recovery.Mesh.Mesh.Infinite() + 1; p < recovery.Mesh.Mesh.Vertices().Size(); ++p)
      {
        hasSteinerPoint = hasSteinerPoint || recovery.Mesh.Mesh.HasVertex(p);
      }
      EXPECT_EQ(hasSteinerPoint, turn < 0);
    }
  }
}

TEST(RecoverSegments, ASegmentThroughAVertexIsGivenUpAndLetGo)
{
  std::vector<Point> points = { { { -4, 0, 0 } }, { { 4, 0, 0 } }, { { 0, 0, 0 } } };
  for (const double z : { -5.0, 5.0 })
  {
    points.push_back({ { 1, 1, z } });
    points.push_back({ { 1, -2, z } });
    points.push_back({ { -2, z / 2, z } });
  }
  Recovery recovery(points, { { { 0, 1, 3 } } });
  const Id segment = recovery.Mesh.Segments.Find(0, 1);
  ASSERT_EQ(FindMissingSegments(recovery.Mesh, { segment }), (std::vector<Id>{ segment }));
  const MeshRecord before(recovery.Mesh.Mesh);
  EXPECT_EQ(RecoverSegmentsByFlips(recovery.Mesh, { segment }), (std::vector<Id>{ segment }));
  EXPECT_EQ(RecoverSegmentsBySplits(recovery.Mesh, { segment }, From::Middle),
    (std::vector<Id>{ segment }));
  EXPECT_EQ(recovery.Mesh.Segments.Find(0, 1), None);
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
}

TEST(RecoverSegments, FlipsGetNearlyAllAndSplitsTheRest)
{
  std::size_t missing = 0;
  std::size_t left = 0;
  for (unsigned seed = 1; seed <= 30; ++seed)
  {
    std::mt19937 random(seed);
    const std::vector<Point> points = AnyPoints(seed, 16);
    Recovery recovery(points, FacetsThatDoNotMeet(points, random, 60));
    const MeshRecord before(recovery.Mesh.Mesh);
    const std::vector<Id> wanted = recovery.Missing();
    missing += wanted.size();
    const std::vector<Id> rest = RecoverSegmentsByFlips(recovery.Mesh, wanted);
    left += rest.size();
    ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
    recovery.ExpectThere(rest);
    EXPECT_EQ(recovery.Missing(),
      [&rest]()
      {
        std::vector<Id> sorted = rest;
        std::sort(sorted.begin(), sorted.end());
        return sorted;
      }());
    EXPECT_TRUE(
      RecoverSegmentsBySplits(recovery.Mesh, rest, seed % 4 < 2 ? From::Middle : From::HigherEnd)
        .empty())
      << "seed " << seed;
    ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
    recovery.ExpectThere({});
  }
  EXPECT_GT(missing, 50u);
  EXPECT_LT(left, missing / 4);
}

TEST(RecoverSegments, PullsGetMostAndFlipsSomeOfTheRest)
{
  std::size_t missing = 0;
  std::size_t left = 0;
  std::size_t stillLeft = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    std::mt19937 random(seed);
    const std::vector<Point> points = AnyPoints(seed, 16);
    Recovery recovery(points, FacetsThatDoNotMeet(points, random, 60));
    const MeshRecord before(recovery.Mesh.Mesh);
    const std::vector<Id> wanted = recovery.Missing();
    const std::vector<Id> rest = RecoverSegmentsByPulls(recovery.Mesh, wanted);
    EXPECT_EQ(rest, recovery.Missing());
    ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
    recovery.ExpectThere(rest);
    missing += wanted.size();
    left += rest.size();
    stillLeft += RecoverSegmentsByFlips(recovery.Mesh, rest).size();
  }
  EXPECT_GT(missing, 100u);
  EXPECT_LT(left, missing / 4);
  EXPECT_LT(stillLeft, left);
}

TEST(RecoverSegments, SplitsAloneRecoverAllFromTheMiddleOrAnEnd)
{
  for (unsigned seed = 1; seed <= 16; ++seed)
  {
    for (const From from : { From::Middle, From::HigherEnd })
    {
      std::mt19937 random(seed);
      const std::vector<Point> points = AnyPoints(seed, 14);
      Recovery recovery(points, FacetsThatDoNotMeet(points, random, 40));
      const MeshRecord before(recovery.Mesh.Mesh);
      EXPECT_TRUE(RecoverSegmentsBySplits(recovery.Mesh, recovery.Missing(), from).empty())
        << "seed " << seed;
      recovery.ExpectThere({});
      ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
    }
  }
}

TEST(RecoverSegments, SplitsRecoverASegmentAcrossWhichFlatFlipsGoInCircles)
{
  const std::vector<Point> points = { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } },
    { { 0, 2, 1 } }, { { 1, 2, 0 } }, { { 0, 1, 2 } }, { { 1, 3, 3 } }, { { 1, 2, 1 } },
    { { 2, 1, 0 } } };
  const std::vector<Triangle> facets = { { { 8, 6, 3 } }, { { 4, 3, 0 } } };
  Recovery recovery(points, facets);
  const MeshRecord before(recovery.Mesh.Mesh);
  EXPECT_TRUE(RecoverSegmentsBySplits(recovery.Mesh, recovery.Missing(), From::Middle).empty());
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
  recovery.ExpectThere({});
}

TEST(RecoverSegments, FlipsUpToTheirLimitConnectASegmentWithoutASteinerPoint)
{
  // A flat lens between two apexes. The segment between its tips crosses all edges of the lens but
  // those of its rim; each plain flip removes one.
  constexpr int limit = 50;
  std::vector<Point> points = { { { -1, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 0, 8 } },
    { { 0, 0, -8 } } };
  for (int k = 0; k <= limit; ++k)
  {
    const double x = -1 + 2 * (k + 1.0) / (limit + 2);
    points.push_back({ { x, (k % 2 == 0 ? 0.25 : -0.25) * (1 - x * x), 0 } });
  }
  Recovery recovery(points, { { { 0, 1, 2 } } });
  ASSERT_EQ(recovery.Missing(), (std::vector<Id>{ 0 }));
  const FlippableMesh& mesh = recovery.Mesh.Mesh;
  int crossed = 0;
  for (Crossing at = FirstCrossing(mesh, 0, 1); at.Kind == Crossing::ThroughEdge;
       at = NextCrossing(mesh, 0, 1, at))
  {
    ++crossed;
  }
  ASSERT_EQ(crossed, limit);
  const MeshRecord before(mesh);
  const Id vertices = mesh.Vertices().Size();
  EXPECT_TRUE(RecoverSegmentsBySplits(recovery.Mesh, { 0 }, From::Middle).empty());
  EXPECT_EQ(mesh.Vertices().Size(), vertices);
  EXPECT_TRUE(recovery.Missing().empty());
  ExpectFlippableMeshLaws(mesh, before);
}

TEST(RecoverSegments, StopsWhereTheMonitorWantsTo)
{
  struct Stop : Monitor
  {
    bool Continue(const char*, double) override { return false; }
  };
  const TriangleSoup prism = testmeshes::TwistedPrism(3, -0.3);
  Stop stop;
  MeshWithFacets mesh(DelaunayMesh(prism.Points), prism.Triangles, stop);
  const std::vector<Id> missing =
    FindMissingSegments(mesh, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
  ASSERT_FALSE(missing.empty());
  EXPECT_THROW(RecoverSegmentsByFlips(mesh, missing), Error);
  EXPECT_THROW(RecoverSegmentsBySplits(mesh, missing, From::Middle), Error);
  ExpectFlippableMeshLaws(mesh.Mesh);
}
