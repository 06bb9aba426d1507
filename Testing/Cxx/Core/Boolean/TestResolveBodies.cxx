// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/ResolveBodies.h"

#include "Boolean/SingleBodies.h"
#include "Common/Stages.h"
#include "Common/Team.h"
#include "Resolve/FindIntersections.h"
#include "Support/AllowedThreads.h"
#include "Support/BodiesOfSoups.h"
#include "Support/TestMeshes.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <thread>

namespace
{
using namespace insideout;
using namespace testmeshes;

TriangleSoup Cube(double low, double high)
{
  return Box({ low, low, low }, { high, high, high });
}

ResolvedBodies Resolved(const std::vector<TriangleSoup>& soups, const BodyParameters& given = {})
{
  Monitor monitor;
  return ResolveBodies(BodiesOf(soups), given, monitor);
}

TEST(ResolveBodies, CountsWhatCoincidesForEachBody)
{
  // B stands on A: two triangles of each are one face, and face opposite ways.
  const ResolvedBodies bodies =
    Resolved({ Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0, 0, 1 }, { 1, 1, 2 }) });
  Id common = 0;
  for (Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    EXPECT_EQ(bodies.Surface.Multiplicity[f], CountFor(bodies, f, 0) + CountFor(bodies, f, 1));
    if (bodies.CountOffsets[f + 1] - bodies.CountOffsets[f] == 2)
    {
      ++common;
      EXPECT_EQ(CountFor(bodies, f, 0), -CountFor(bodies, f, 1));
      EXPECT_EQ(bodies.Surface.SourceOffsets[f + 1] - bodies.Surface.SourceOffsets[f], 2);
    }
  }
  EXPECT_GE(common, 2);
}

TEST(ResolveBodies, LetsDuplicatesCancelWithinABodyOnly)
{
  const TriangleSoup cube = Cube(0, 1);
  const ResolvedBodies bodies = Resolved({ cube, cube, Join(cube, cube) });
  ASSERT_EQ(bodies.Surface.NumberOfFacets(), 12);
  for (Id f = 0; f < 12; ++f)
  {
    for (Id body = 0; body < 3; ++body)
    {
      EXPECT_EQ(CountFor(bodies, f, body), 1);
    }
    EXPECT_EQ(bodies.Surface.SourceOffsets[f + 1] - bodies.Surface.SourceOffsets[f], 4);
  }
  EXPECT_EQ(bodies.Bodies[0].Counts.DuplicateFacets, 0);
  EXPECT_EQ(bodies.Bodies[2].Counts.DuplicateFacets, 12);
}

TEST(ResolveBodies, OrientsEachBodyByItself)
{
  // The inner cube faces inward: alone it is a body that is inside out, and no cavity of the other.
  const ResolvedBodies bodies = Resolved({ Cube(0, 4), Reversed(Cube(1, 2)) });
  EXPECT_EQ(bodies.Bodies[0].Turns.TurnedFacets, 0);
  EXPECT_EQ(bodies.Bodies[1].Turns.TurnedFacets, 12);
  ASSERT_EQ(bodies.TurnedTriangles.size(), 12u);
  EXPECT_EQ(bodies.TurnedTriangles.front(), 12);
  ASSERT_EQ(bodies.Warnings.size(), 1u);
  EXPECT_EQ(bodies.Warnings.front().substr(0, 8), "body B: ");
}

/** w of each body is that of the body alone, wherever bodies cross, touch and coincide. */
TEST(ResolveBodies, ChangesNoBodysWindingNumber)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const std::vector<TriangleSoup> soups = { GridSoup(seed, 12, 3), GridSoup(seed + 100, 12, 3),
      Box({ 0, 0, 0 }, { 2, 2, 1 }), RandomSoup(seed, 6) };
    BodyParameters parameters;
    parameters.Orientation = Orientation::AsGiven;
    const ResolvedBodies bodies = Resolved(soups, parameters);
    ASSERT_EQ(bodies.Surface.NumberOfConstraints, bodies.Surface.NumberOfFacets());
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-0.5, 3);
    Monitor monitor;
    for (Id b = 0; b < 4; ++b)
    {
      CountedChain alone = CountFacets(soups[b], {}, monitor);
      OrientFacets(alone.Surface, alone.Edges, Orientation::AsGiven, monitor); // membranes
      const SurfaceWindingNumber expected(alone.Surface, {}, monitor);
      const SurfaceWindingNumber w(ComplexOfBody(bodies, b), {}, monitor);
      for (int i = 0; i < 20; ++i)
      {
        const Point p = { place(random), place(random), place(random) };
        EXPECT_NEAR(w.At(p), expected.At(p), 1e-9) << seed << " body " << b;
      }
    }
  }
}

TEST(ResolveBodies, KnowsWhichBodiesAreClosed)
{
  TriangleSoup open = Cube(0, 1);
  open.Triangles.pop_back();
  const ResolvedBodies bodies = Resolved({ Cube(0.5, 2), open, Cube(0, 1) });
  EXPECT_EQ(FindClosedBodies(bodies, SortedFacetEdges(bodies.Surface.Facets)),
    (std::vector<char>{ 1, 0, 1 }));
}

TEST(ResolveBodies, KnowWhichAreClosedAtAnyNumberOfEdges)
{
  // Tetrahedra by turns of bodies 0, 1 and 2; of body 3 facets there and back, all at one edge.
  ResolvedBodies bodies;
  bodies.Bodies.resize(4);
  const auto add = [&](const Triangle& corners, Id body)
  {
    bodies.Surface.Facets.push_back(corners);
    bodies.BodyCounts.push_back({ body, 1 });
    bodies.CountOffsets.push_back(static_cast<Id>(bodies.BodyCounts.size()));
  };
  for (Id i = 0; i < 6000; ++i)
  {
    const Id a = 4 * i + 2;
    for (const Triangle& t : { Triangle{ a, a + 2, a + 1 }, Triangle{ a, a + 1, a + 3 },
           Triangle{ a + 1, a + 2, a + 3 }, Triangle{ a, a + 3, a + 2 } })
    {
      add(t, i % 3);
    }
    add({ 0, 1, a }, 3);
    add({ 1, 0, a }, 3);
    add({ 0, 1, a + 1 }, 3);
    add({ 1, 0, a + 1 }, 3);
  }
  const FacetEdges edges = SortedFacetEdges(bodies.Surface.Facets);
  const WholeTeams teams;
  for (const int threads : { 1, 3 })
  {
    const testthreads::Allowed allowed(threads);
    EXPECT_EQ(FindClosedBodies(bodies, edges), (std::vector<char>{ 1, 1, 1, 1 }));
    for (std::size_t f = 0; f < bodies.BodyCounts.size(); f += 4799)
    {
      std::vector<char> expected(4, 1);
      expected[bodies.BodyCounts[f].Body] = 0;
      bodies.BodyCounts[f].Count = 2;
      EXPECT_EQ(FindClosedBodies(bodies, edges), expected) << f;
      bodies.BodyCounts[f].Count = 1;
    }
  }
}

TEST(ResolveBodies, OfOneSurfaceAreThoseOfSeveral)
{
  const std::vector<TriangleSoup> soups = { Cube(0, 2), Cube(1, 3), Cube(2, 4) };
  const TriangleSoup all = Join(Join(soups[0], soups[1]), soups[2]);
  std::vector<Id> bodyOfTriangle(36, 0);
  std::fill(bodyOfTriangle.begin() + 12, bodyOfTriangle.begin() + 24, 1);
  std::fill(bodyOfTriangle.begin() + 24, bodyOfTriangle.end(), 2);
  Monitor monitor;
  const ResolvedBodies one =
    ResolveBodies(SplitBodies(all, bodyOfTriangle, { "A", "B", "C" }), {}, monitor);
  const ResolvedBodies several = Resolved(soups);
  EXPECT_EQ(one.Surface.Facets, several.Surface.Facets);
  EXPECT_EQ(one.CountOffsets, several.CountOffsets);
  EXPECT_THROW(SplitBodies(all, std::vector<Id>(36, 3), { "A", "B", "C" }), Error);
  EXPECT_THROW(SplitBodies(all, { 0 }, { "A" }), Error);
}

/** Points that bodies share go by one number, whichever body comes first. */
TEST(ResolveBodies, NumbersMergedPointsAlike)
{
  const TriangleSoup both = Merged(Join(Cube(0, 1), Box({ 1, 0, 0 }, { 2, 1, 1 })));
  std::vector<Id> bodyOfTriangle(24, 1);
  std::fill(bodyOfTriangle.begin() + 12, bodyOfTriangle.end(), 0);
  Monitor monitor;
  const ResolvedBodies bodies =
    ResolveBodies(SplitBodies(both, bodyOfTriangle, { "right", "left" }), {}, monitor);
  for (std::size_t p = 0; p < bodies.Surface.Points.size(); ++p)
  {
    const PointOrigin& origin = bodies.Surface.Origins[p];
    if (origin.IsInput())
    {
      EXPECT_EQ(bodies.MergedInto[origin.Points[0]], origin.Points[0]);
      EXPECT_EQ(both.Points[origin.Points[0]], bodies.Surface.Points[p]);
    }
  }
}

TEST(ResolveBodies, CloseGapsThatAreBelowTheTolerance)
{
  BodyParameters parameters;
  parameters.Chain.MergeTolerance = 0.01;
  const TriangleSoup left = Cube(0, 1);
  EXPECT_EQ(
    Resolved({ left, Box({ 1.005, 0, 0 }, { 2, 1, 1 }) }, parameters).Surface.NumberOfFacets(), 22);
  EXPECT_EQ(
    Resolved({ left, Box({ 1.02, 0, 0 }, { 2, 1, 1 }) }, parameters).Surface.NumberOfFacets(), 24);
}

TEST(ResolveBodies, TakeABodyWithoutFacetsForEmpty)
{
  const ResolvedBodies bodies = Resolved({ {}, Cube(0, 1), { { { 0, 0, 0 } }, { { 0, 0, 0 } } } });
  EXPECT_EQ(bodies.Surface.NumberOfFacets(), 12);
  EXPECT_EQ(CountFor(bodies, 3, 1), 1);
  EXPECT_EQ(bodies.Warnings.size(), 2u);
  EXPECT_THROW(Resolved({ {}, {} }), Error);
}

TEST(ResolveBodies, CountWhatHasNoArea)
{
  const TriangleSoup needles = { { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } },
    { { 0, 1, 2 }, { 0, 0, 1 } } };
  const ResolvedBodies bodies = Resolved({ Cube(0, 1), needles });
  EXPECT_EQ(bodies.Bodies[1].Counts.InputPoints, 3);
  EXPECT_EQ(bodies.Bodies[1].Counts.InputTriangles, 2);
  EXPECT_EQ(bodies.Bodies[1].Counts.DegenerateFacets, 2);
  EXPECT_EQ(bodies.Bodies[1].Counts.Facets, 0);
  EXPECT_EQ(bodies.DegenerateTriangles, (std::vector<Id>{ 12, 13 }));
}

TEST(ResolveBodies, NameTheBodyThatIsWrong)
{
  TriangleSoup wrong = Cube(0, 1);
  wrong.Triangles[3][1] = 88;
  try
  {
    Resolved({ Cube(0, 1), wrong });
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::PointOutOfRange);
    EXPECT_STREQ(error.what(), "body B: triangle 3 refers to point 88 of 8");
  }
}
/** Keeps the threads that it was asked on. */
class AskedMonitor : public Monitor
{
public:
  bool Continue(const char* stage, double fraction) override
  {
    this->IsOwn &= std::this_thread::get_id() == this->Own;
    this->Stages.insert(stage);
    return fraction <= 1;
  }

  const std::thread::id Own = std::this_thread::get_id();
  bool IsOwn = true;
  std::set<std::string> Stages;
};

TEST(ResolveBodies, AreTheSameSideBySideAndOneByOne)
{
  // Alike in size, so that threads take a body each, and one that has all threads.
  const TriangleSoup inward = Reversed(Box({ 3, 0, 0 }, { 4, 1, 1 }));
  const TriangleSoup twice = Join(Cube(0, 2), Cube(0, 2));
  for (const std::vector<TriangleSoup>& soups :
    { std::vector<TriangleSoup>{ Cube(0, 1), inward, Cube(0.5, 2), Cube(0.25, 3) },
      std::vector<TriangleSoup>{ Cube(0, 1), Join(twice, Join(twice, twice)), inward } })
  {
    const ResolvedBodies expected = Resolved(soups);
    const WholeTeams teams;
    for (const int threads : { 1, 2, 4 })
    {
      const testthreads::Allowed allowed(threads);
      AskedMonitor monitor;
      const ResolvedBodies bodies = ResolveBodies(BodiesOf(soups), {}, monitor);
      EXPECT_TRUE(monitor.IsOwn);
      EXPECT_EQ(monitor.Stages.count(Stages::Orienting), 1u);
      EXPECT_EQ(bodies.Surface.Points, expected.Surface.Points);
      EXPECT_EQ(bodies.Surface.Facets, expected.Surface.Facets);
      EXPECT_EQ(bodies.TurnedTriangles, expected.TurnedTriangles);
      EXPECT_EQ(bodies.Warnings, expected.Warnings);
    }
  }
}

TEST(ResolveBodies, SaysThatMembranesDoNotCountUnlessTheyAreThickened)
{
  TriangleSoup membrane;
  membrane.Points = { { 0.5, 0.5, 1 }, { 1.5, 0.5, 1 }, { 0.5, 1.5, 1 } };
  membrane.Triangles = { { 0, 1, 2 } };
  for (const double width : { 0.0, 0.25 })
  {
    BodyParameters parameters;
    parameters.Thicken.Width = width;
    const ResolvedBodies bodies = Resolved({ Join(Cube(0, 2), membrane) }, parameters);
    EXPECT_EQ(bodies.Bodies[0].Turns.Membranes, 1);
    EXPECT_EQ(bodies.Warnings.size(), width == 0 ? 1u : 0u);
  }
}

TEST(ResolveBodies, CountsTheCrossingsOfEachBodyAndAmongThem)
{
  // A crosses itself; C is a sheet that is thickened, and its slab crosses A and B.
  const TriangleSoup twice = Join(Cube(0, 2), Cube(1, 3));
  TriangleSoup sheet;
  sheet.Points = { { -1, -1, 0.5 }, { 9, -1, 0.5 }, { -1, 9, 0.5 } };
  sheet.Triangles = { { 0, 1, 2 } };
  for (const double width : { 0.0, 0.25 })
  {
    BodyParameters parameters;
    parameters.Thicken.Width = width;
    const ResolvedBodies alone = Resolved({ twice, Cube(7, 8) }, parameters);
    EXPECT_GT(alone.IntersectingPairs, 0);
    const ResolvedBodies bodies =
      Resolved({ twice, Box({ 5, 0, 0 }, { 6, 1, 1 }), sheet }, parameters);
    EXPECT_GT(bodies.IntersectingPairs, alone.IntersectingPairs);
    EXPECT_EQ(bodies.Bodies[2].ThickenedFacets, width > 0);
    Monitor monitor;
    EXPECT_TRUE(FindIntersections(bodies.Surface.Points, bodies.Surface.Facets, monitor).empty());
  }
}
} // namespace
