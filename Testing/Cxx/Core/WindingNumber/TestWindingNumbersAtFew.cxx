// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumbersAtFew.h"

#include "Common/PointPredicates.h"
#include "Support/TestMeshes.h"
#include "WindingNumber/ClosedChainTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

using namespace insideout;
using namespace testmeshes;

namespace
{
std::vector<CountedTriangle> ChainOf(const TriangleSoup& soup)
{
  std::vector<CountedTriangle> chain;
  for (const Triangle& t : soup.Triangles)
  {
    chain.push_back({ t, 1 });
  }
  return chain;
}

/** The boundaries of tetrahedra between random places of a grid. */
TriangleSoup Tetrahedra(unsigned seed, int count, int grid)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> number(1 - grid, grid - 1);
  TriangleSoup soup;
  while (count > 0)
  {
    std::array<Point, 4> corners;
    for (Point& p : corners)
    {
      p = { double(number(random)) / grid, double(number(random)) / grid,
        double(number(random)) / grid };
    }
    if (Orient3D(corners[0], corners[1], corners[2], corners[3]) > 0)
    {
      const Id first = static_cast<Id>(soup.Points.size());
      const Tetrahedron cell = { first, first + 1, first + 2, first + 3 };
      soup.Points.insert(soup.Points.end(), corners.begin(), corners.end());
      for (int k = 0; k < 4; ++k)
      {
        soup.Triangles.push_back(FaceOf(cell, k));
      }
      --count;
    }
  }
  return soup;
}

/** In the middle of each triangle, on its edges and corners, and between corners of any. */
std::vector<Tetrahedron> PlacesOn(const TriangleSoup& soup, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_int_distribution<Id> point(0, static_cast<Id>(soup.Points.size()) - 1);
  std::vector<Tetrahedron> cells;
  for (const auto& [a, b, c] : soup.Triangles)
  {
    cells.push_back({ a, b, c, c });
    cells.push_back({ a, a, b, b });
    cells.push_back({ a, a, a, a });
    cells.push_back({ point(random), point(random), point(random), point(random) });
    cells.push_back({ point(random), point(random), a, b });
  }
  return cells;
}

void ExpectAsByTree(const TriangleSoup& soup, unsigned seed)
{
  const std::vector<CountedTriangle> chain = ChainOf(soup);
  const std::vector<Tetrahedron> cells = PlacesOn(soup, seed);
  Monitor monitor;
  const ProgressRange progress = { "", 0, 1 };
  const ClosedChainTree tree(soup.Points, chain, monitor, progress);
  const std::vector<double> w =
    WindingNumbersAtFew(soup.Points, chain, { soup.Points, cells }, monitor, progress);
  ASSERT_EQ(w.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const double expected = tree.At(Sites{ soup.Points, cells }[i]);
    EXPECT_NEAR(w[i], expected, 1e-12);
  }
}

TEST(WindingNumbersAtFew, AreThoseOfTheTreeWhereverTheyAreAsked)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    ExpectAsByTree(Tetrahedra(seed, 20, 1000), seed);
    ExpectAsByTree(Tetrahedra(seed, 20, 4), seed); // along the axes there are edges and corners
  }
}

TEST(WindingNumbersAtFew, AreThoseOfTheTreeInBoxes)
{
  TriangleSoup boxes = testmeshes::Box({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 });
  boxes = Join(boxes, testmeshes::Box({ -0.25, -0.5, -0.25 }, { 0.25, 0.75, 0.25 }));
  boxes =
    Join(boxes, Reversed(testmeshes::Box({ -0.125, -0.125, -0.125 }, { 0.125, 0.125, 0.125 })));
  ExpectAsByTree(boxes, 1);
}

TEST(WindingNumbersAtFew, AreNothingWhereNothingIs)
{
  TriangleSoup soup = testmeshes::Box({ -0.5, -0.5, -0.5 }, { 0, 0, 0 });
  const Id first = static_cast<Id>(soup.Points.size());
  soup.Points.insert(
    soup.Points.end(), { { 0.5, 0.5, 0.5 }, { -0.25, 0.5, -0.25 }, { -0.25, -0.25, -0.25 } });
  std::vector<Tetrahedron> cells;
  for (Id p = first; p < first + 3; ++p)
  {
    cells.push_back({ p, p, p, p });
  }
  Monitor monitor;
  EXPECT_EQ(
    WindingNumbersAtFew(soup.Points, ChainOf(soup), { soup.Points, cells }, monitor, { "", 0, 1 }),
    (std::vector<double>{ 0, 0, 1 }));
  EXPECT_EQ(WindingNumbersAtFew(soup.Points, {}, { soup.Points, cells }, monitor, { "", 0, 1 }),
    (std::vector<double>{ 0, 0, 0 }));
}
} // namespace
