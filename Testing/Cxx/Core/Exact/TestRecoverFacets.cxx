// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverFacets.h"

#include "Exact/RecoverSegments.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace testflips;

namespace
{
/** A mesh, facets that it lacks, and what recovers them. */
struct Recovery
{
  Recovery(FlippableMesh mesh, std::vector<Triangle> facets)
    : Wanted(facets)
    , Mesh(std::move(mesh), std::move(facets), AnyMonitor())
  {
  }

  std::vector<Id> All() const
  {
    std::vector<Id> all(this->Wanted.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  /** Recover the edges of all facets. */
  void RecoverEdges()
  {
    std::vector<Id> segments(static_cast<std::size_t>(this->Mesh.Segments.Size()));
    std::iota(segments.begin(), segments.end(), 0);
    const std::vector<Id> missing = FindMissingSegments(this->Mesh, segments);
    EXPECT_TRUE(RecoverSegmentsBySplits(
      this->Mesh, RecoverSegmentsByFlips(this->Mesh, missing), SplitFrom::Middle)
                  .empty());
  }

  /** Expect that each facet but some is a union of faces between its edges, exactly. */
  void ExpectThere(const std::vector<Id>& missing) const
  {
    const MeshRecord record(this->Mesh.Mesh);
    std::map<Id, std::set<Triangle>> faces = FacesOfFacets(record);
    for (const Id facet : this->All())
    {
      if (std::find(missing.begin(), missing.end(), facet) != missing.end())
      {
        EXPECT_TRUE(faces[facet].empty());
        continue;
      }
      // Points in the volume may have become points of segments, beside these by rounding.
      bool isExact = true;
      for (const Triangle& face : faces[facet])
      {
        for (const Id corner : face)
        {
          isExact = isExact && (corner < record.Infinite || !this->IsFree(corner));
        }
      }
      EXPECT_TRUE(!isExact || CoverTheSame(record.Places, faces[facet], { this->Wanted[facet] }))
        << facet;
    }
    EXPECT_EQ(ConstraintViolations(this->Mesh.Mesh, this->Mesh.Segments, this->Wanted),
      std::vector<std::string>());
  }

  bool IsFree(Id vertex) const { return this->Mesh.Mesh.Vertices().IsDouble(vertex); }

  std::vector<Triangle> Wanted;
  ExactState Mesh; ///< no facet is marked
};

/** Three cells around the edge 3 4, which pierces the triangle 0 1 2. */
FlippableMesh ThreeCells()
{
  return MeshOfCells(
    { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } }, { { 2, 2, 9 } }, { { 3, 3, -9 } } },
    { { { 4, 3, 0, 1 } }, { { 4, 3, 1, 2 } }, { { 4, 3, 2, 0 } } });
}
} // namespace

TEST(RecoverFacets, MarksThoseThatAreFacesAndReturnsTheOthers)
{
  Recovery recovery(
    ThreeCells(), { { { 0, 1, 2 } }, { { 3, 4, 0 } }, { { 1, 0, 4 } }, { { 2, 3, 1 } } });
  EXPECT_EQ(MarkWholeFacets(recovery.Mesh, { 3, 0, 1 }), (std::vector<Id>{ 0 }));
  const std::map<Id, std::set<Triangle>> expected = { { 1, { { { 0, 3, 4 } } } },
    { 3, { { { 1, 2, 3 } } } } };
  EXPECT_EQ(FacesOfFacets(MeshRecord(recovery.Mesh.Mesh)), expected);
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
}

TEST(RecoverFacets, AFaceBesideAPointOfTheFacetsEdgeIsNotTheFacet)
{
  // The point 4 of the edge from 0 to 1 was rounded into the space above the face 0 1 2.
  Recovery recovery(
    MeshOfCells(
      { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } }, { { 0, 0, 8 } }, { { 1, 0.5, 0.5 } } },
      { { { 0, 1, 2, 4 } }, { { 0, 1, 3, 4 } }, { { 0, 2, 3, 4 } }, { { 1, 2, 3, 4 } } }),
    { { { 0, 1, 2 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } } });
  recovery.Mesh.Segments.Split(recovery.Mesh.Segments.OfFacet(0, 0), 0, 1, 4);
  EXPECT_EQ(MarkWholeFacets(recovery.Mesh, recovery.All()), (std::vector<Id>{ 0, 1 }));
  recovery.ExpectThere({ 0, 1 });
}

TEST(RecoverFacets, FlipsTheEdgeAwayThatPiercesAFacet)
{
  Recovery recovery(ThreeCells(), { { { 0, 1, 2 } } });
  const Rational volume = SixfoldVolume(MeshRecord(recovery.Mesh.Mesh));
  EXPECT_TRUE(RecoverFacetsByFlips(recovery.Mesh, { 0 }).empty());
  EXPECT_EQ(MeshRecord(recovery.Mesh.Mesh).FiniteCells(),
    (std::set<Tetrahedron>{ { { 0, 1, 2, 3 } }, { { 0, 1, 2, 4 } } }));
  EXPECT_EQ(SixfoldVolume(MeshRecord(recovery.Mesh.Mesh)), volume);
  recovery.ExpectThere({});
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
}

TEST(RecoverFacets, APiercingEdgeThatIsAConstraintIsCutInTwo)
{
  // No flip may take the edge 3 4 away, and a point on the facet splits it.
  Recovery recovery(ThreeCells(), { { { 0, 1, 2 } }, { { 3, 4, 0 } } });
  ASSERT_EQ(MarkWholeFacets(recovery.Mesh, { 0, 1 }), (std::vector<Id>{ 0 }));
  const MeshRecord before(recovery.Mesh.Mesh);
  EXPECT_EQ(RecoverFacetsByFlips(recovery.Mesh, { 0 }), (std::vector<Id>{ 0 }));
  ExpectUnchanged(recovery.Mesh.Mesh, before);
}

TEST(RecoverFacets, APiercingEdgeIsSplitOnTheFacet)
{
  Recovery recovery(ThreeCells(), { { { 0, 1, 2 } } });
  EXPECT_TRUE(RecoverFacetsBySplits(recovery.Mesh, { 0 }).empty());
  EXPECT_EQ(recovery.Mesh.Mesh.Vertices().Size(), 7) << "a point should have come";
  recovery.ExpectThere({});
  EXPECT_FALSE(recovery.Mesh.Mesh.HasVertex(6)) << "and gone again";
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
}

TEST(RecoverFacets, AFacetOfWhichAnEdgeIsMissingIsReturned)
{
  Recovery recovery(MeshOfCells({ { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } },
                                  { { 2, 2, 9 } }, { { 3, 3, -9 } } },
                      Pyramids({ { { 0, 1, 2 } } }, { 3, 4 })),
    { { { 3, 4, 0 } } });
  const MeshRecord before(recovery.Mesh.Mesh);
  EXPECT_EQ(RecoverFacetsByFlips(recovery.Mesh, { 0 }), (std::vector<Id>{ 0 }));
  EXPECT_EQ(RecoverFacetsBySplits(recovery.Mesh, { 0 }), (std::vector<Id>{ 0 }));
  // By then the edge 1 2, which passes through its plane beside it, may have been split.
  recovery.ExpectThere({ 0 });
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh, before);
}

TEST(RecoverFacets, FindsAFacetInPiecesAroundThePointsThatLieOnIt)
{
  // The facet 0 1 2 with three points within, and others above and below.
  const std::vector<Point> points = { { { 0, 0, 0 } }, { { 12, 0, 0 } }, { { 0, 12, 0 } },
    { { 2, 2, 0 } }, { { 6, 2, 0 } }, { { 2, 6, 0 } }, { { 3, 3, 7 } }, { { 4, 3, -7 } },
    { { 5, 5, 2 } }, { { 5, 5, -2 } } };
  Recovery recovery(DelaunayMesh(points), { { { 0, 1, 2 } } });
  recovery.RecoverEdges();
  std::vector<Id> missing = MarkWholeFacets(recovery.Mesh, { 0 });
  EXPECT_EQ(missing, (std::vector<Id>{ 0 })) << "it has points within";
  missing = RecoverFacetsByFlips(recovery.Mesh, missing);
  EXPECT_TRUE(RecoverFacetsBySplits(recovery.Mesh, missing).empty());
  recovery.ExpectThere({});
  EXPECT_GE(FacesOfFacets(MeshRecord(recovery.Mesh.Mesh))[0].size(), 7u);
  ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
}

TEST(RecoverFacets, RecoversSchoenhardtsPolyhedron)
{
  for (const double turn : { -0.2, -0.4, -0.6 })
  {
    const TriangleSoup prism = testmeshes::TwistedPrism(3, turn);
    Recovery recovery(DelaunayMesh(prism.Points), prism.Triangles);
    const Rational volume = SixfoldVolume(MeshRecord(recovery.Mesh.Mesh));
    recovery.RecoverEdges();
    std::vector<Id> missing = MarkWholeFacets(recovery.Mesh, recovery.All());
    missing = RecoverFacetsByFlips(recovery.Mesh, missing);
    EXPECT_TRUE(RecoverFacetsBySplits(recovery.Mesh, missing).empty());
    recovery.ExpectThere({});
    EXPECT_EQ(SixfoldVolume(MeshRecord(recovery.Mesh.Mesh)), volume);
    ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
  }
}

TEST(RecoverFacets, RecoversAllFacetsThatDoNotMeet)
{
  std::size_t missing = 0;
  std::size_t left = 0;
  for (unsigned seed = 1; seed <= 24; ++seed)
  {
    std::mt19937 random(seed);
    const std::vector<Point> points = AnyPoints(seed, 16);
    Recovery recovery(DelaunayMesh(points), FacetsThatDoNotMeet(points, random, 60));
    recovery.RecoverEdges();
    const MeshRecord before(recovery.Mesh.Mesh);
    const std::vector<Id> others = MarkWholeFacets(recovery.Mesh, recovery.All());
    recovery.ExpectThere(others);
    missing += others.size();
    const std::vector<Id> rest = RecoverFacetsByFlips(recovery.Mesh, others);
    recovery.ExpectThere(rest);
    ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
    left += rest.size();
    EXPECT_TRUE(RecoverFacetsBySplits(recovery.Mesh, rest).empty()) << "seed " << seed;
    recovery.ExpectThere({});
    ExpectFlippableMeshLaws(recovery.Mesh.Mesh);
    EXPECT_EQ(SixfoldVolume(before), SixfoldVolume(MeshRecord(recovery.Mesh.Mesh)));
  }
  EXPECT_GT(missing, 10u);
  EXPECT_LT(left, missing);
}

TEST(RecoverFacets, StopsWhereTheMonitorWantsTo)
{
  struct Stop : Monitor
  {
    bool Continue(const char*, double) override { return false; }
  };
  Stop stop;
  ExactState mesh(ThreeCells(), { { { 0, 1, 2 } } }, stop);
  EXPECT_THROW(RecoverFacetsByFlips(mesh, { 0 }), Error);
  EXPECT_THROW(RecoverFacetsBySplits(mesh, { 0 }), Error);
  ExpectFlippableMeshLaws(mesh.Mesh);
}
