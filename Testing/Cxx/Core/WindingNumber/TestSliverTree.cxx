// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/SliverTree.h"

#include "Common/Vectors.h"
#include "WindingNumber/SolidAngle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace insideout;

/** Triangles along random lines, their middle corner beside these by about `width`. */
struct Slivers
{
  std::vector<Point> Points;
  std::vector<CountedTriangle> Triangles;

  Slivers(unsigned seed, int number, double width)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-0.5, 0.5);
    for (Id i = 0; i < number; ++i)
    {
      const double length = std::exp2(-static_cast<int>(random() % 8));
      const Point a = { part(random) / 2, part(random) / 2, part(random) / 2 };
      Point b = a, c = a;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double along = length * part(random);
        b[axis] += 0.4 * along + width * part(random);
        c[axis] += along;
      }
      this->Points.insert(this->Points.end(), { a, b, c });
      this->Triangles.push_back({ { 3 * i, 3 * i + 1, 3 * i + 2 }, 1 + static_cast<int>(i % 3) });
    }
  }
};

/** Sums of the tree and one by one in many digits, at places from far to near. */
void ExpectEqualSums(const Slivers& slivers, unsigned seed)
{
  const SliverTree tree(slivers.Points, slivers.Triangles);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  for (int trial = 0; trial < 60; ++trial)
  {
    // Around a place on a sliver, ever nearer.
    const Point& on = slivers.Points[random() % slivers.Points.size()];
    const double size = std::exp2(-trial / 1.5);
    std::vector<Point> points(Lanes, on);
    for (Point& p : points)
    {
      for (double& x : p)
      {
        x += size * part(random) / 2;
      }
    }
    const std::vector<Tetrahedron> cells = CellsOfPoints(Lanes);
    const Sites sites = { points, cells };
    std::vector<Id> order(Lanes);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      order[lane] = lane;
    }
    const SiteProducts block = MakeBlock(sites, order, 0);
    double sums[Lanes] = {};
    tree.Add(tree.Select(BoxOfSites(block.Rounded)), sites, block, sums);
    for (int lane = 0; lane < Lanes; ++lane)
    {
      double right = 0;
      for (const CountedTriangle& triangle : slivers.Triangles)
      {
        right += triangle.Count *
          std::arg(
            HalfSolidAngle(CornersOf(slivers.Points, triangle.Corners), SiteAt(points[lane])));
      }
      EXPECT_NEAR(sums[lane], right, 1e-13) << "trial " << trial;
    }
  }
}

TEST(SliverTree, SumsAsOneByOne)
{
  ExpectEqualSums(Slivers(1, 200, 0x1p-50), 1);
  ExpectEqualSums(Slivers(2, 200, 0x1p-47), 2);
}

TEST(SliverTree, SumsTrianglesThatAreNoSlivers)
{
  // Nothing is lost where doubles do not decide: it only takes longer.
  ExpectEqualSums(Slivers(3, 30, 0x1p-20), 3);
  ExpectEqualSums(Slivers(4, 30, 0.25), 4);
}

TEST(SliverTree, IsEmptyWithoutSlivers)
{
  const std::vector<Point> points;
  const SliverTree tree(points, {});
  EXPECT_TRUE(tree.Select({ { -1, -1, -1 }, { 1, 1, 1 } }).Slivers.empty());
}
} // namespace
