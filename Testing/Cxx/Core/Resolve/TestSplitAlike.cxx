// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/SplitAlike.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace insideout;

namespace
{
/** Points 0 to 4 stand on a line, in this order; the others beside it. */
const std::vector<Point> Line = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 }, { 4, 0, 0 },
  { 2, 3, 0 }, { 2, -3, 0 } };

std::vector<Triangle> Applied(const std::vector<Triangle>& facets, const Replacement& replacement)
{
  std::vector<Triangle> after;
  for (Id f = 0; f < static_cast<Id>(facets.size()); ++f)
  {
    if (!std::binary_search(replacement.Removed.begin(), replacement.Removed.end(), f))
    {
      after.push_back(facets[f]);
    }
  }
  for (const ReplacedFacet& part : replacement.Added)
  {
    after.push_back(part.Corners);
  }
  return after;
}

/** The edges between points of the line that the facets at a point beside it have. */
std::set<Edge> EdgesOnLine(const std::vector<Triangle>& facets, Id beside)
{
  std::set<Edge> edges;
  for (const Triangle& t : facets)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (t[k] == beside)
      {
        edges.insert(EdgeBetween(t[(k + 1) % 3], t[(k + 2) % 3]));
      }
    }
  }
  return edges;
}
} // namespace

TEST(SplitAlike, SplitsAWholeEdgeAsItsChainSays)
{
  const std::vector<Triangle> facets = { { 0, 4, 5 } };
  const auto after = Applied(facets, SplitAlike(Line, facets, { { { 0, 4 }, { 0, 1, 3, 4 } } }));
  EXPECT_EQ(EdgesOnLine(after, 5), (std::set<Edge>{ { 0, 1 }, { 1, 3 }, { 3, 4 } }));
}

TEST(SplitAlike, UnitesTheChainsOfAnEdge)
{
  // On one side there are the pieces of one chain, on the other those of another.
  const std::vector<Triangle> facets = { { 0, 2, 5 }, { 2, 4, 5 }, { 1, 0, 6 }, { 4, 1, 6 } };
  const auto after = Applied(
    facets, SplitAlike(Line, facets, { { { 0, 4 }, { 0, 2, 4 } }, { { 0, 4 }, { 0, 1, 4 } } }));
  const std::set<Edge> expected = { { 0, 1 }, { 1, 2 }, { 2, 4 } };
  EXPECT_EQ(EdgesOnLine(after, 5), expected);
  EXPECT_EQ(EdgesOnLine(after, 6), expected);
}

TEST(SplitAlike, CarriesSplitsOverToEdgesThatLieOnEachOther)
{
  // Edge 0-4 has point 1 as its neighbor sees it; that 1-4 has point 3 only another edge knows.
  const std::vector<Triangle> facets = { { 0, 4, 5 }, { 1, 4, 6 } };
  const auto after = Applied(
    facets, SplitAlike(Line, facets, { { { 0, 4 }, { 0, 1, 4 } }, { { 1, 4 }, { 1, 3, 4 } } }));
  EXPECT_EQ(EdgesOnLine(after, 5), (std::set<Edge>{ { 0, 1 }, { 1, 3 }, { 3, 4 } }));
  EXPECT_EQ(EdgesOnLine(after, 6), (std::set<Edge>{ { 1, 3 }, { 3, 4 } }));
}

TEST(SplitAlike, NamesTheParentOfEveryPart)
{
  const std::vector<Triangle> facets = { { 0, 1, 6 }, { 0, 4, 5 } };
  const Replacement result = SplitAlike(Line, facets, { { { 0, 4 }, { 0, 2, 4 } } });
  EXPECT_EQ(result.Removed, std::vector<Id>{ 1 });
  ASSERT_EQ(result.Added.size(), 2u);
  EXPECT_EQ(result.Added[0].Parent, 1);
  EXPECT_EQ(result.Added[1].Parent, 1);
}

TEST(SplitAlike, ReadsTheChainsOfAFacetFromItsPieces)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, { 1, -1, 0 },
    { 1, 1, 0 }, { 3, -1, 0 } };
  const std::vector<Triangle> facets = { { 0, 1, 2 }, { 3, 4, 5 } };
  const PlanarSubdivision subdivision = SubdividePlane({ points, facets }, { 0, 1 }, {});
  std::vector<Id> ids;
  Id next = 6;
  for (const ConstructedPoint& point : subdivision.Points)
  {
    ids.push_back(point.Kind == ConstructedPoint::Type::Corner ? point.Ids[0] : next++);
  }
  const std::vector<EdgeChain> chains = ChainsOf(subdivision, ids);
  ASSERT_EQ(chains.size(), 6u);
  std::map<Edge, std::size_t> lengths;
  for (const EdgeChain& chain : chains)
  {
    EXPECT_EQ(chain.Points.front(), chain.Along[0]);
    EXPECT_EQ(chain.Points.back(), chain.Along[1]);
    lengths[chain.Along] = chain.Points.size();
  }
  // Edge 0-1 is crossed twice, edges 3-4 and 4-5 once each.
  EXPECT_EQ(lengths,
    (std::map<Edge, std::size_t>{ { { 0, 1 }, 4 }, { { 1, 2 }, 2 }, { { 0, 2 }, 2 },
      { { 3, 4 }, 3 }, { { 4, 5 }, 3 }, { { 3, 5 }, 2 } }));
}
