// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/TouchBodies.h"

#include "Boolean/ResolveBodies.h"
#include "Boolean/TouchingFacets.h"
#include "Common/Vectors.h"
#include "Support/BodiesOfSoups.h"
#include "Support/TestMeshes.h"
#include "Support/Turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

ResolvedBodies Resolved(const std::vector<TriangleSoup>& soups, double tolerance = -1)
{
  return ResolveTouching(soups, tolerance);
}

TriangleSoup InFloats(TriangleSoup soup)
{
  for (Point& p : soup.Points)
  {
    for (double& x : p)
    {
      x = static_cast<float>(x);
    }
  }
  return soup;
}

/** A block, and a stud above a gap over a corner of it, turned. */
std::vector<TriangleSoup> BlockAndStud(std::mt19937& random, double gap)
{
  const Turn turned(random);
  return { InFloats(turned(Box({ 0, 0, 0 }, { 37, 37, 37 }))),
    InFloats(turned(Box({ 9, 30, 37 + gap }, { 20, 50, 44 }))) };
}

TEST(TouchBodies, MakesOneInterfaceOfFloats)
{
  std::mt19937 random(1);
  for (int turn = 0; turn < 60; ++turn)
  {
    std::vector<TriangleSoup> soups = BlockAndStud(random, 0);
    if (turn % 2 == 1)
    {
      std::swap(soups[0], soups[1]);
    }
    const ResolvedBodies touching = Resolved(soups);
    EXPECT_NEAR(InterfaceOf(touching), 11 * 7, 1e-3) << turn;
    EXPECT_EQ(touching.Surface.NumberOfConstraints, touching.Surface.NumberOfFacets());
    ASSERT_EQ(touching.Warnings.size(), 1u);
    EXPECT_EQ(touching.Warnings[0].rfind("bodies A and B touch within ", 0), 0u);
    EXPECT_EQ(touching.TouchingPairs, 1);
    for (const Point& p : soups[0].Points) // the earlier body stays
    {
      const std::vector<Point>& points = touching.Surface.Points;
      EXPECT_NE(std::find(points.begin(), points.end(), p), points.end());
    }
  }
}

TEST(TouchBodies, LeavesGapsOfTenRoundings)
{
  std::mt19937 random(2);
  for (int turn = 0; turn < 60; ++turn)
  {
    const ResolvedBodies apart = Resolved(BlockAndStud(random, 10 * std::ldexp(64.0, -25)));
    EXPECT_EQ(InterfaceOf(apart), 0) << turn;
    EXPECT_EQ(apart.TouchMovedPoints, 0);
  }
}

TEST(TouchBodies, MovesNothingWithoutAToleranceOrAGrid)
{
  std::mt19937 random(3);
  const Turn turned(random);
  const std::vector<TriangleSoup> doubles = { turned(Box({ 0, 0, 0 }, { 1, 1, 1 })),
    turned(Box({ 0, 0, 1 + 1e-9 }, { 1, 1, 2 })) };
  const std::vector<std::pair<ResolvedBodies, std::vector<TriangleSoup>>> all = {
    { Resolved(doubles), doubles }, { Resolved(BlockAndStud(random, 0), 0), {} }
  };
  for (const auto& [bodies, soups] : all)
  {
    EXPECT_EQ(bodies.TouchingPairs, 0);
    EXPECT_EQ(bodies.TouchMovedPoints, 0);
  }
}

TEST(TouchBodies, ClosesWhatALengthSays)
{
  std::mt19937 random(4);
  const Turn turned(random);
  const std::vector<TriangleSoup> soups = { turned(Box({ 0, 0, 0 }, { 1, 1, 1 })),
    turned(Box({ 0.25, 0.25, 1 + 1e-4 }, { 0.5, 0.5, 2 })) };
  EXPECT_EQ(InterfaceOf(Resolved(soups, 9e-5)), 0);
  EXPECT_NEAR(InterfaceOf(Resolved(soups, 1.1e-4)), 0.0625, 1e-9);
}

TEST(TouchBodies, LeavesALoneBodyAsItIs)
{
  std::mt19937 random(5);
  const TriangleSoup joined = Join(BlockAndStud(random, 0)[0], BlockAndStud(random, 0)[1]);
  const ResolvedBodies one = Resolved({ joined });
  const ResolvedBodies same = Resolved({ joined }, 0);
  EXPECT_EQ(one.Surface.Points, same.Surface.Points);
  EXPECT_EQ(one.Surface.Facets, same.Surface.Facets);
}

TEST(TouchingFacets, LieOnEachOtherWithinTheirTolerances)
{
  Monitor monitor;
  const std::vector<Point> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, 1, 0.01 },
    { 3, 1, 0.02 }, { 1, 3, 0.01 } };
  const std::vector<Triangle> facets = { { 0, 1, 2 }, { 3, 5, 4 } };
  const auto found = FindTouchingFacets(points, facets, { 0, 1 }, { 0.01, 0.01 }, monitor);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].First, 0);
  EXPECT_EQ(found[0].Second, 1);
  EXPECT_NEAR(found[0].Distance, 0.02, 1e-12);
  EXPECT_TRUE(FindTouchingFacets(points, facets, { 0, 1 }, { 0.005, 0.01 }, monitor).empty());
  EXPECT_TRUE(FindTouchingFacets(points, facets, { 0, 1 }, { 0.01, -1 }, monitor).empty());
  EXPECT_TRUE(FindTouchingFacets(points, facets, { 0, 0 }, { 0.01, 0.01 }, monitor).empty());
}
} // namespace
