// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/BoundaryPieces.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "Resolve/FindIntersections.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace insideout;

namespace
{
/**
 * A triangle among others with few whole numbers as coordinates, so that they touch in all ways.
 */
std::vector<Point> RandomPoints(std::mt19937& random, std::size_t count)
{
  std::vector<Point> points(count);
  for (Point& p : points)
  {
    for (double& x : p)
    {
      x = static_cast<double>(random() % 20);
    }
  }
  return points;
}

std::vector<SurfacePiece> RandomPieces(
  std::mt19937& random, const std::vector<Point>& points, std::size_t count)
{
  std::vector<SurfacePiece> pieces;
  std::set<Triangle> taken;
  while (pieces.size() < count)
  {
    Triangle corners;
    for (Id& corner : corners)
    {
      corner = static_cast<Id>(random() % points.size());
    }
    const std::array<Point, 3> places = CornersOf(points, corners);
    if (!IsDegenerate(places[0], places[1], places[2]) &&
      taken.insert(SortedTriangle(corners).Points).second)
    {
      pieces.push_back({ corners, places, 0 });
    }
  }
  return pieces;
}

std::vector<std::array<Id, 2>> CrossingsOf(
  const std::vector<Point>& points, const std::vector<SurfacePiece>& pieces)
{
  std::vector<Triangle> triangles;
  for (const SurfacePiece& piece : pieces)
  {
    triangles.push_back(piece.Corners);
  }
  Monitor monitor;
  return FindIntersections(points, triangles, monitor);
}
} // namespace

class BoundaryPiecesOfAnySurface : public testing::TestWithParam<unsigned>
{
};

TEST_P(BoundaryPiecesOfAnySurface, StayApartWhereNoFreshOneMeetsAnother)
{
  std::mt19937 random(GetParam());
  const std::vector<Point> points = RandomPoints(random, 60);
  std::vector<SurfacePiece> there = RandomPieces(random, points, 12);
  BoundaryPieces pieces(there);
  int allowed = 0;
  for (int change = 0; change < 300; ++change)
  {
    std::shuffle(there.begin(), there.end(), random);
    const auto firstGone = there.end() - static_cast<std::ptrdiff_t>(random() % 3);
    const std::vector<SurfacePiece> gone(firstGone, there.end());
    std::vector<SurfacePiece> after(there.begin(), firstGone);
    const Id firstFresh = static_cast<Id>(after.size());
    for (const SurfacePiece& piece : RandomPieces(random, points, 1 + random() % 2))
    {
      const Triangle key = SortedTriangle(piece.Corners).Points;
      if (std::none_of(after.begin(), after.end(),
            [&](const SurfacePiece& other) { return SortedTriangle(other.Corners).Points == key; }))
      {
        after.push_back(piece);
      }
    }
    const std::vector<SurfacePiece> fresh(after.begin() + firstFresh, after.end());
    const std::vector<std::array<Id, 2>> crossings = CrossingsOf(points, after);
    const bool isApart = std::none_of(crossings.begin(), crossings.end(),
      [&](const std::array<Id, 2>& pair) { return pair[1] >= firstFresh; });
    ASSERT_EQ(pieces.StayApart(gone, fresh), isApart) << "change " << change;
    if (isApart || (change % 8 == 0 && after.size() < 16))
    {
      pieces.Replace(gone, fresh);
      there = after;
      ++allowed;
    }
  }
  EXPECT_GT(allowed, 20);
}

INSTANTIATE_TEST_SUITE_P(Seeds, BoundaryPiecesOfAnySurface, testing::Range(0U, 5U));

TEST(BoundaryPieces, AreNotTwiceInOnePlace)
{
  const std::array<Point, 3> places = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } } };
  const SurfacePiece piece = { { { 0, 1, 2 } }, places, 0 };
  const SurfacePiece turned = { { { 0, 2, 1 } }, { { places[0], places[2], places[1] } }, 0 };
  const BoundaryPieces pieces({ piece });
  EXPECT_FALSE(pieces.StayApart({}, { turned }));
  EXPECT_TRUE(pieces.StayApart({ piece }, { turned }));
}
