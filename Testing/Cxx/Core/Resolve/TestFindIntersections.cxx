// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FindIntersections.h"

#include "Common/Team.h"
#include "Resolve/FacetsNearOthers.h"
#include "Resolve/MeetBeyondSharedCorners.h"
#include "Support/ExactReference.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace insideout;
using namespace testmeshes;

namespace
{
using Pairs = std::vector<std::array<Id, 2>>;

Pairs Find(const TriangleSoup& soup)
{
  Monitor monitor;
  return FindIntersections(soup.Points, soup.Triangles, monitor);
}

/** The triangle (0, 0, 0), (4, 0, 0), (0, 4, 0) and one with its corners at the given ids: 0 to 2
 * are the first's own corners, 3 to 5 the points given. Asked in every order of the corners. */
bool MeetsFixed(const std::vector<Point>& more, const Triangle& other)
{
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } };
  soup.Points.insert(soup.Points.end(), more.begin(), more.end());
  std::set<std::size_t> answers;
  Triangle order = { 0, 1, 2 };
  do
  {
    soup.Triangles = { { 0, 1, 2 }, { other[order[0]], other[order[1]], other[order[2]] } };
    answers.insert(Find(soup).size());
    std::swap(soup.Triangles[0], soup.Triangles[1]);
    answers.insert(Find(soup).size());
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(answers.size(), 1u);
  return *answers.begin() == 1;
}

/** Fans of needles, and a needle that crosses each fan: the last triangle. */
TriangleSoup CrossedFans(int fans, int needles)
{
  const double above = 50 + 0.0004 * fans;
  return Join(SlantedFans(fans, needles),
    { { { 49.99, 49.8, 50.02 }, { above + 0.1, above - 0.1, 50 - 2 * (above - 50) },
        { above + 0.2, above - 0.1, 50 - 2 * (above - 50) } },
      { { 0, 1, 2 } } });
}

/** All pairs with the last triangle that meet beyond shared corners. */
Pairs PairsWithTheLast(const TriangleSoup& soup)
{
  Pairs pairs;
  const Id last = static_cast<Id>(soup.Triangles.size()) - 1;
  for (Id f = 0; f < last; ++f)
  {
    if (MeetBeyondSharedCorners(soup.Points, soup.Triangles[f], soup.Triangles[last]))
    {
      pairs.push_back({ f, last });
    }
  }
  return pairs;
}

/** Stops at its n-th question. */
class StopAt : public Monitor
{
public:
  explicit StopAt(int n)
    : Left(n)
  {
  }
  bool Continue(const char*, double) override { return --this->Left > 0; }

private:
  int Left;
};
} // namespace

TEST(FindIntersections, SharingNothing)
{
  EXPECT_FALSE(MeetsFixed({ { 1, 1, 1 }, { 2, 1, 1 }, { 1, 2, 2 } }, { 3, 4, 5 })) << "above";
  EXPECT_FALSE(MeetsFixed({ { 5, 5, -1 }, { 5, 5, 1 }, { 6, 5, 1 } }, { 3, 4, 5 })) << "beside";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 1 } }, { 3, 4, 5 }))
    << "edge through";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 0 }, { 1, 1, 1 }, { 2, 1, 1 } }, { 3, 4, 5 }))
    << "corner on facet";
  EXPECT_TRUE(MeetsFixed({ { 2, 2, 0 }, { 3, 3, 1 }, { 3, 4, 1 } }, { 3, 4, 5 }))
    << "corner on edge";
  EXPECT_TRUE(MeetsFixed({ { 1, -1, -1 }, { 1, 1, 1 }, { 1, -1, 1 } }, { 3, 4, 5 }))
    << "edge on edge, crosswise";
  EXPECT_TRUE(MeetsFixed({ { 1, 0, 0 }, { 3, 0, 0 }, { 2, -1, 1 } }, { 3, 4, 5 }))
    << "edge along edge";
  EXPECT_TRUE(MeetsFixed({ { 4, 0, 0 }, { 5, 0, 1 }, { 5, 1, 1 } }, { 3, 4, 5 }))
    << "equal corner under another id";
  EXPECT_TRUE(MeetsFixed({ { 1, 0, 1 }, { 1, 0, -1 }, { 1, -1, 0 } }, { 3, 4, 5 }))
    << "corner of nobody: an edge pierces an edge";
}

TEST(FindIntersections, SharingNothingInOnePlane)
{
  EXPECT_FALSE(MeetsFixed({ { 3, 3, 0 }, { 5, 3, 0 }, { 3, 5, 0 } }, { 3, 4, 5 })) << "apart";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 0 }, { 2, 1, 0 }, { 1, 2, 0 } }, { 3, 4, 5 })) << "nested";
  EXPECT_TRUE(MeetsFixed({ { -9, -9, 0 }, { 20, -9, 0 }, { -9, 20, 0 } }, { 3, 4, 5 }))
    << "nested the other way";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 0 }, { 9, 1, 0 }, { 9, 2, 0 } }, { 3, 4, 5 })) << "partly";
  EXPECT_TRUE(MeetsFixed({ { 2, 2, 0 }, { 9, 1, 0 }, { 9, 9, 0 } }, { 3, 4, 5 })) << "at a point";
  EXPECT_TRUE(MeetsFixed({ { 1, 0, 0 }, { 3, 0, 0 }, { 2, -1, 0 } }, { 3, 4, 5 }))
    << "along an edge";
  EXPECT_TRUE(MeetsFixed({ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 } }, { 3, 4, 5 })) << "equal";
  EXPECT_TRUE(MeetsFixed({ { 2, -1, 0 }, { -1, 3, 0 }, { 3, 3, 0 } }, { 3, 4, 5 })) << "a star";
}

TEST(FindIntersections, SharingACorner)
{
  EXPECT_FALSE(MeetsFixed({ { -1, 0, 1 }, { 0, -1, 1 } }, { 0, 3, 4 })) << "only it";
  EXPECT_FALSE(MeetsFixed({ { -1, -1, 1 }, { -1, -1, -1 } }, { 0, 3, 4 })) << "through the plane";
  EXPECT_FALSE(MeetsFixed({ { -1, 0, 0 }, { 0, -1, 0 } }, { 0, 3, 4 })) << "only it, in plane";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 1 }, { 1, 1, -1 } }, { 0, 3, 4 })) << "pierced";
  EXPECT_TRUE(MeetsFixed({ { 9, 9, 1 }, { 9, 9, -1 } }, { 0, 3, 4 })) << "cut across";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 0 }, { 1, 1, -1 } }, { 0, 3, 4 })) << "edge in the facet";
  EXPECT_TRUE(MeetsFixed({ { 2, 0, 0 }, { 1, -1, -1 } }, { 0, 3, 4 })) << "shorter edge on edge";
  EXPECT_TRUE(MeetsFixed({ { 9, 0, 0 }, { 1, -1, -1 } }, { 0, 3, 4 })) << "longer edge on edge";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 0 }, { 1, 2, 0 } }, { 0, 3, 4 })) << "nested";
  EXPECT_TRUE(MeetsFixed({ { 9, 1, 0 }, { 1, 9, 0 } }, { 0, 3, 4 })) << "nested the other way";
  EXPECT_TRUE(MeetsFixed({ { 2, 0, 0 }, { 1, -1, 0 } }, { 0, 3, 4 })) << "edge on edge, in plane";
  EXPECT_TRUE(MeetsFixed({ { 4, 0, 0 }, { 1, -1, 1 } }, { 0, 3, 4 })) << "the edge, by coordinates";
}

TEST(FindIntersections, SharingAnEdge)
{
  EXPECT_FALSE(MeetsFixed({ { 1, 1, 1 } }, { 0, 1, 3 })) << "a fold";
  EXPECT_FALSE(MeetsFixed({ { 1, -1, 0 } }, { 0, 1, 3 })) << "flat";
  EXPECT_TRUE(MeetsFixed({ { 1, 1, 0 } }, { 0, 1, 3 })) << "folded flat, within";
  EXPECT_TRUE(MeetsFixed({ { 9, 9, 0 } }, { 0, 1, 3 })) << "folded flat, beyond";
  EXPECT_TRUE(MeetsFixed({ { 0, 4, 0 } }, { 0, 1, 3 })) << "the same by coordinates";
}

TEST(FindIntersections, IsTheDefinitionOnGridSoups)
{
  for (unsigned seed = 0; seed < 400; ++seed)
  {
    const TriangleSoup soup = GridSoup(seed, 14, 2 + seed % 4);
    ASSERT_EQ(Find(soup), IntersectionsByClipping(soup.Points, soup.Triangles)) << "seed " << seed;
  }
}

TEST(FindIntersections, IsTheDefinitionOnSlantedGridSoups)
{
  // A linear map with odd coefficients: exactly coplanar facets, in no plane of the axes.
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    TriangleSoup soup = GridSoup(seed, 14, 2 + seed % 3);
    for (Point& p : soup.Points)
    {
      p = { p[0] + 3 * p[1] + 5 * p[2], 7 * p[0] - p[1] + p[2], p[0] + p[1] - 11 * p[2] };
    }
    ASSERT_EQ(Find(soup), IntersectionsByClipping(soup.Points, soup.Triangles)) << "seed " << seed;
  }
}

TEST(FindIntersections, IsTheDefinitionOnRandomSoups)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const TriangleSoup soup = RandomSoup(seed, 40);
    ASSERT_EQ(Find(soup), IntersectionsByClipping(soup.Points, soup.Triangles)) << "seed " << seed;
  }
}

TEST(FindIntersections, IsTheDefinitionAmongNeedles)
{
  for (const int needles : { 40, 256 }) // by facets, and by parts
  {
    const TriangleSoup soup = CrossedFans(32, needles);
    const Pairs expected = PairsWithTheLast(soup);
    EXPECT_GE(expected.size(), 32u);
    EXPECT_EQ(Find(soup), expected);
  }
}

TEST(FindIntersections, IsTheSameAtEveryScale)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const TriangleSoup soup = Merged(Join(RandomSoup(seed, 20), GridSoup(seed, 20, 3)));
    for (const int exponent : { -300, -100, 100, 300 })
    {
      TriangleSoup scaled = soup;
      for (Point& p : scaled.Points)
      {
        p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
      }
      ASSERT_EQ(Find(scaled), Find(soup)) << "seed " << seed << " scale 2^" << exponent;
    }
  }
}

TEST(FindIntersections, FindsNothingOnABox)
{
  EXPECT_TRUE(Find(Box({ 0, 0, 0 }, { 1, 2, 3 })).empty());
  EXPECT_TRUE(Find({}).empty());
}

TEST(FindIntersections, TakesOnlyPairsWithANewFacetWhenAsked)
{
  const TriangleSoup soup = GridSoup(3, 40, 4);
  const Pairs all = Find(soup);
  for (const Id firstNew : { 0, 1, 17, 39, 40 })
  {
    Pairs expected;
    std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
      [&](const std::array<Id, 2>& pair) { return pair[1] >= firstNew; });
    Monitor monitor;
    EXPECT_EQ(FindIntersections(soup.Points, soup.Triangles, firstNew, monitor), expected);
  }
}

TEST(FindIntersections, TakesOnlyPairsOfDifferentSetsWhenAsked)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    const TriangleSoup soup = seed % 2 == 0 ? GridSoup(seed, 80, 5) : RandomSoup(seed, 200);
    std::vector<Id> setOf;
    for (std::size_t f = 0; f < soup.Triangles.size(); ++f)
    {
      setOf.push_back(static_cast<Id>(f * f % (1 + seed / 4)));
    }
    const Pairs all = Find(soup);
    Pairs expected;
    std::copy_if(all.begin(), all.end(), std::back_inserter(expected),
      [&](const std::array<Id, 2>& pair) { return setOf[pair[0]] != setOf[pair[1]]; });
    EXPECT_EQ(expected.empty(), seed < 4);
    Monitor monitor;
    const std::vector<Id> near = FacetsNearOthers(soup.Points, soup.Triangles, setOf, 0);
    EXPECT_EQ(
      FindIntersectionsBetween(soup.Points, soup.Triangles, setOf, near, monitor), expected);
  }
}

TEST(FindIntersections, IsTheSameForAnyThreadCount)
{
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  for (const TriangleSoup& soup :
    { RandomSoup(1, 1000), RandomSoup(1, 1500), CrossedFans(32, 256) })
  {
    omp_set_num_threads(1);
    const Pairs one = Find(soup);
    for (const int n : { 2, 8 })
    {
      omp_set_num_threads(n);
      EXPECT_EQ(Find(soup), one);
    }
    EXPECT_GE(one.size(), 32u);
  }
  omp_set_num_threads(threads);
}

TEST(FindIntersections, CanBeStopped)
{
  const TriangleSoup soup = RandomSoup(1, 600);
  for (int n = 1; n <= 2; ++n)
  {
    StopAt monitor(n);
    try
    {
      FindIntersections(soup.Points, soup.Triangles, monitor);
      ADD_FAILURE() << "went on at question " << n;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
  }
}

TEST(FindIntersections, FindsTrianglesWhoseVolumesOverflow)
{
  // The second triangle's first corner is below the plane x + y + z = 1e103 of the first one, but a
  // sum of products in doubles is infinite there.
  const double s = 1e103;
  const auto at = [s](double x, double y, double z) -> Point {
    return { { s + 0.1 * s * x, 0.1 * s * y, 0.1 * s * z } };
  };
  const std::vector<Point> points = { { { s, 0, 0 } }, { { 0, s, 0 } }, { { 0, 0, s } },
    at(1.81, -0.91, -0.91), at(-1.79, 0.8975, 0.8975), at(-1.78, 0.88, 0.91) };
  const std::vector<std::array<Id, 2>> pair = { { { 0, 1 } } };
  Monitor monitor;
  EXPECT_EQ(FindIntersections(points, { { { 0, 1, 2 } }, { { 3, 4, 5 } } }, monitor), pair);
  EXPECT_EQ(FindIntersections(points, { { { 5, 4, 3 } }, { { 2, 1, 0 } } }, monitor), pair);
}
