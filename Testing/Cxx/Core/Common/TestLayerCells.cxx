// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/LayerCells.h"

#include "Common/PointPredicates.h"
#include "Common/SortedTriangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

using namespace insideout;

namespace
{
const std::vector<Point> PrismPoints = { { { 0, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 0, 0 } },
  { { 0, 0, 1 } }, { { 0, 1, 1 } }, { { 1, 0, 1 } } };
const Prism OnePrism = { { 0, 1, 2, 3, 4, 5 } };

/** How often each face is one of a part, and how often a half of a quad. */
std::map<Triangle, std::array<int, 2>> CountFaces(const std::vector<CellPart>& parts)
{
  std::map<Triangle, std::array<int, 2>> counts;
  for (const CellPart& part : parts)
  {
    for (int k = 0; k < 4; ++k)
    {
      auto& [all, halves] = counts[SortedTriangle(FaceOf(part.Corners, k)).Points];
      ++all;
      halves += part.IsHalf[k] ? 1 : 0;
    }
  }
  return counts;
}

/** The points and the cell with other ids. */
template <class Cell>
std::pair<std::vector<Point>, Cell> Renumbered(
  const std::vector<Point>& points, Cell cell, const std::vector<Id>& ids)
{
  std::vector<Point> places(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    places[ids[p]] = points[p];
  }
  for (Id& corner : cell)
  {
    corner = ids[corner];
  }
  return { places, cell };
}
} // namespace

TEST(LayerCells, TellPrismsThatAreTurnedOver)
{
  std::vector<Point> points = PrismPoints;
  EXPECT_EQ(Orient(points, OnePrism), 1);
  EXPECT_EQ(Orient(points, Prism{ { 3, 4, 5, 0, 1, 2 } }), -1);
  points[5] = { { 1, 0, 0 } }; // an edge of no length
  EXPECT_EQ(Orient(points, OnePrism), 0);
  points[5] = { { -1, 0, 1 } }; // its triangle is turned over, its edges go inward
  EXPECT_EQ(Orient(points, OnePrism), -1);
  points[5] = { { 1, 0, 1 } };
  EXPECT_EQ(Orient(points, Pyramid{ { 1, 2, 5, 4, 0 } }), 1);
  EXPECT_EQ(Orient(points, Pyramid{ { 2, 5, 4, 1, 0 } }), 1);
  EXPECT_EQ(Orient(points, Pyramid{ { 1, 4, 5, 2, 0 } }), -1);
}

TEST(LayerCells, ArePartedAtTheLowestCornersOfTheirQuads)
{
  std::vector<Id> ids(6);
  std::iota(ids.begin(), ids.end(), 0);
  do
  {
    const auto [points, prism] = Renumbered(PrismPoints, OnePrism, ids);
    std::vector<CellPart> parts;
    AppendParts(prism, parts);
    ASSERT_EQ(parts.size(), 3U);
    for (const CellPart& part : parts)
    {
      EXPECT_EQ(Orient3D(points, part.Corners), 1);
    }
    int outer = 0;
    int halves = 0;
    for (const auto& [face, count] : CountFaces(parts))
    {
      outer += count[0] == 1 ? 1 : 0;
      halves += count[1];
      EXPECT_TRUE(count[0] == 1 || (count[0] == 2 && count[1] == 0));
    }
    EXPECT_EQ(outer, 8);
    EXPECT_EQ(halves, 6);
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const std::array<Id, 4> quad = { { prism[k], prism[next], prism[next + 3], prism[k + 3] } };
      // A pyramid on the same quad has the same halves.
      std::vector<CellPart> others;
      AppendParts(Pyramid{ { quad[0], quad[1], quad[2], quad[3], 6 } }, others);
      ASSERT_EQ(others.size(), 2U);
      auto faces = CountFaces(parts);
      for (const auto& [face, count] : CountFaces(others))
      {
        EXPECT_TRUE(count[1] == 0 || faces[face][1] == 1);
      }
    }
  } while (std::next_permutation(ids.begin(), ids.end()));
}
