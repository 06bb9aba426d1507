// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/TrianglePredicates.h"
#include "Resolve/CollapseSlivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

using namespace insideout;

namespace
{
constexpr double Radius = 1e-13;

std::vector<Id> AllOf(const std::vector<Triangle>& facets)
{
  std::vector<Id> all(facets.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/** The facets that are there after a collapse. */
std::vector<Triangle> Applied(const std::vector<Triangle>& facets, const Replacement& slivers)
{
  std::vector<Triangle> after;
  for (Id f = 0; f < static_cast<Id>(facets.size()); ++f)
  {
    if (!std::binary_search(slivers.Removed.begin(), slivers.Removed.end(), f))
    {
      after.push_back(facets[f]);
    }
  }
  for (const ReplacedFacet& part : slivers.Added)
  {
    after.push_back(part.Corners);
  }
  return after;
}

/** How often the facets run along each edge from the lower point, less how often back. */
std::map<std::array<Id, 2>, int> Boundary(const std::vector<Triangle>& facets)
{
  std::map<std::array<Id, 2>, int> sums;
  for (const Triangle& t : facets)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id p = t[k];
      const Id q = t[(k + 1) % 3];
      sums[{ std::min(p, q), std::max(p, q) }] += p < q ? 1 : -1;
    }
  }
  return sums;
}

bool IsClosed(const std::vector<Triangle>& facets)
{
  const auto boundary = Boundary(facets);
  return std::all_of(
    boundary.begin(), boundary.end(), [](const auto& edge) { return edge.second == 0; });
}

std::vector<Triangle> TetrahedronBoundary(const std::array<Id, 4>& corners)
{
  const auto& [a, b, c, d] = corners;
  return { { a, c, b }, { a, b, d }, { b, c, d }, { c, a, d } };
}
} // namespace

TEST(CollapseSlivers, SplitsTheOtherFacetsAlongTheLongestEdge)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1e-14, 0 }, { 0.5, -1, 0 } };
  const std::vector<Triangle> facets = { { 0, 1, 2 }, { 1, 0, 3 } };
  const Replacement slivers = CollapseSlivers(points, facets, { 0 }, Radius);
  EXPECT_EQ(slivers.Removed, (std::vector<Id>{ 0, 1 }));
  ASSERT_EQ(slivers.Added.size(), 2u);
  EXPECT_EQ(slivers.Added[0].Corners, (Triangle{ 1, 2, 3 }));
  EXPECT_EQ(slivers.Added[1].Corners, (Triangle{ 2, 0, 3 }));
  EXPECT_EQ(slivers.Added[0].Parent, 1);
  EXPECT_EQ(slivers.Added[1].Parent, 1);
}

TEST(CollapseSlivers, LeavesFacetsAloneThatAreWiderThanTheRadius)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 3e-13, 0 }, { 0.5, -1, 0 } };
  const Replacement slivers =
    CollapseSlivers(points, { { 0, 1, 2 }, { 1, 0, 3 } }, { 0, 1 }, Radius);
  EXPECT_TRUE(slivers.Removed.empty());
  EXPECT_TRUE(slivers.Added.empty());
}

TEST(CollapseSlivers, LeavesSliversAloneThatAreNoCandidates)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1e-14, 0 }, { 0.5, -1, 0 } };
  EXPECT_TRUE(CollapseSlivers(points, { { 0, 1, 2 }, { 1, 0, 3 } }, { 1 }, Radius).Removed.empty());
}

TEST(CollapseSlivers, EndsWhereSliversTurnIntoEachOther)
{
  // Each of the inner points is near enough to the longest edge of a half, not to that of the
  // whole.
  const std::vector<Point> points = { { 0, 0, 0 }, { 3, 0, 0 }, { 1, 1.2e-13, 0 },
    { 2, 1.2e-13, 0 }, { 1.5, 1, 0 } };
  const std::vector<Triangle> facets = { { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 4 }, { 1, 3, 4 },
    { 3, 2, 4 }, { 2, 0, 4 } };
  const auto boundary = Boundary(facets);
  const std::vector<Triangle> after =
    Applied(facets, CollapseSlivers(points, facets, AllOf(facets), Radius));
  EXPECT_TRUE(IsClosed(facets));
  EXPECT_TRUE(IsClosed(after));
}

TEST(CollapseSlivers, LeavesNoDegenerateFacetAndKeepsSurfacesClosed)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 3);
  std::uniform_int_distribution<int> jitter(-2, 2);
  std::size_t degenerateBefore = 0;
  std::size_t slivers = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    // Many of these points are collinear; moved a little in every second trial they nearly are.
    std::vector<Point> points;
    while (points.size() < 12)
    {
      Point p;
      for (double& x : p)
      {
        x = coordinate(random) + (trial % 2 == 0 ? 0 : std::ldexp(jitter(random), -46));
      }
      if (std::find(points.begin(), points.end(), p) == points.end())
      {
        points.push_back(p);
      }
    }
    std::vector<Triangle> facets;
    std::array<Id, 12> order;
    std::iota(order.begin(), order.end(), 0);
    for (int k = 0; k < 6; ++k)
    {
      std::shuffle(order.begin(), order.end(), random);
      const auto boundary = TetrahedronBoundary({ order[0], order[1], order[2], order[3] });
      facets.insert(facets.end(), boundary.begin(), boundary.end());
    }
    const auto isDegenerate = [&](const Triangle& t)
    { return IsDegenerate(points[t[0]], points[t[1]], points[t[2]]); };
    degenerateBefore += std::count_if(facets.begin(), facets.end(), isDegenerate);
    const Replacement collapsed = CollapseSlivers(points, facets, AllOf(facets), Radius);
    slivers += collapsed.Removed.size();
    const std::vector<Triangle> after = Applied(facets, collapsed);
    ASSERT_EQ(std::count_if(after.begin(), after.end(), isDegenerate), 0) << "trial " << trial;
    ASSERT_TRUE(IsClosed(after)) << "trial " << trial;
  }
  EXPECT_GT(degenerateBefore, 100u);
  EXPECT_GT(slivers, 2 * degenerateBefore);
}
