// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/UncoveredPart.h"

#include "Common/NearestPoint.h"
#include "Common/Vectors.h"
#include "Refine/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace insideout;

namespace
{
constexpr double Near = 0.01;

const std::array<Point, 3> Whole = { { { { 0.1, 0.1, 0 } }, { { 0.9, 0.2, 0 } },
  { { 0.3, 0.8, 0 } } } };

/** Needles from a corner of a square to pieces of the two sides across from it; `up` of every
 * second point there. */
std::vector<std::array<Point, 3>> Needles(int count, double up)
{
  const auto at = [&](int k)
  {
    const double t = 2.0 * k / count;
    const double height = k % 2 == 0 ? 0 : up;
    return t <= 1 ? Point{ { 1, t, height } } : Point{ { 2 - t, 1, height } };
  };
  std::vector<std::array<Point, 3>> needles;
  for (int k = 0; k < count; ++k)
  {
    needles.push_back({ { { { 0, 0, 0 } }, at(k), at(k + 1) } });
  }
  return needles;
}

bool IsCovered(const std::vector<std::array<Point, 3>>& surface)
{
  UncoveredPart part(Whole, Near);
  for (const std::array<Point, 3>& triangle : surface)
  {
    part.Cover(triangle);
  }
  return part.IsEmpty();
}
} // namespace

TEST(UncoveredPart, IsNothingAmidNeedles)
{
  for (const double up : { 0.0, 0.9 * Near })
  {
    EXPECT_TRUE(IsCovered(Needles(80, up))) << up;
  }
}

TEST(UncoveredPart, IsSomethingWhereANeedleIsMissingOrFar)
{
  EXPECT_FALSE(IsCovered(Needles(80, 3 * Near)));
  std::vector<std::array<Point, 3>> needles = Needles(20, 0);
  needles.erase(needles.begin() + 9);
  EXPECT_FALSE(IsCovered(needles));
}

TEST(UncoveredPart, IsNothingOnALatticeWhoseCornersAreRounded)
{
  constexpr int Count = 6;
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int turn = 0; turn < 100; ++turn)
  {
    const Point along = { { any(engine), any(engine), any(engine) } };
    const Point up = { { any(engine), any(engine), any(engine) } };
    const auto at = [&](int i, int j)
    {
      return Point{ { i * along[0] + j * up[0], i * along[1] + j * up[1],
        i * along[2] + j * up[2] } };
    };
    UncoveredPart part({ { at(1, 0), at(Count, 2), at(0, Count) } }, 1e-3);
    for (int k = 0; k < Count * Count; ++k)
    {
      const int i = k % Count;
      const int j = k / Count;
      part.Cover({ { at(i, j), at(i + 1, j), at(i, j + 1) } });
      part.Cover({ { at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) } });
    }
    EXPECT_TRUE(part.IsEmpty()) << turn;
  }
}

TEST(UncoveredPart, IsNeverTakenAwayWhereItIsFar)
{
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> any(-0.5, 1.5);
  std::uniform_real_distribution<double> height(-2 * Near, 2 * Near);
  int covered = 0;
  for (int turn = 0; turn < 200; ++turn)
  {
    std::vector<std::array<Point, 3>> surface;
    UncoveredPart part(Whole, Near);
    for (int k = 0; k < 12 && !part.IsEmpty(); ++k)
    {
      surface.emplace_back();
      for (Point& corner : surface.back())
      {
        corner = { { any(engine), any(engine), height(engine) / 2 } };
      }
      part.Cover(surface.back());
    }
    covered += part.IsEmpty() ? 1 : 0;
    for (int i = 0; i <= 10 && part.IsEmpty(); ++i)
    {
      for (int j = 0; i + j <= 10; ++j)
      {
        Point place;
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] =
            (i * Whole[0][axis] + j * Whole[1][axis] + (10 - i - j) * Whole[2][axis]) / 10;
        }
        EXPECT_TRUE(std::any_of(surface.begin(), surface.end(),
          [&](const std::array<Point, 3>& t)
          { return Distance(NearestPointOf(t, place), place) <= Near * (1 + 1e-9); }));
      }
    }
  }
  EXPECT_GT(covered, 20);
}

TEST(TriangleTree, KnowsThatATriangleIsAmidNeedles)
{
  std::vector<LabelledTriangle> surface;
  for (const std::array<Point, 3>& needle : Needles(80, 0))
  {
    surface.push_back({ needle, 0 });
  }
  const TriangleTree tree(surface);
  const auto isWithin = [&](double distance)
  {
    std::array<TriangleTree::Nearest, 3> ofCorners;
    for (int k = 0; k < 3; ++k)
    {
      ofCorners[k] = tree.NearestTo(Whole[k], 0);
    }
    return tree.IsWithin({ Whole, 0 }, distance, ofCorners);
  };
  EXPECT_TRUE(isWithin(1e-6));
  EXPECT_EQ(tree.NearestTo(Whole[0], 1).Triangle, None);
}
