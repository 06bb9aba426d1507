// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/NearBodies.h"

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

ResolvedBodies Resolved(const std::vector<TriangleSoup>& soups, double tolerance = 0)
{
  return ResolveTouching(soups, tolerance);
}

/** Box with sides of four by four squares. */
TriangleSoup FineBox(const Point& low, const Point& high)
{
  TriangleSoup soup;
  const int cells = 4;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool isHigh : { false, true })
    {
      const Id first = static_cast<Id>(soup.Points.size());
      for (int i = 0; i <= cells; ++i)
      {
        for (int j = 0; j <= cells; ++j)
        {
          Point p = isHigh ? high : low;
          const int u = (axis + 1) % 3;
          const int v = (axis + 2) % 3;
          p[u] = low[u] + (high[u] - low[u]) * i / cells;
          p[v] = low[v] + (high[v] - low[v]) * j / cells;
          soup.Points.push_back(p);
        }
      }
      for (int i = 0; i < cells; ++i)
      {
        for (int j = 0; j < cells; ++j)
        {
          const Id a = first + i * (cells + 1) + j;
          const Id b = a + cells + 1;
          const std::array<Triangle, 2> halves = { { { a, b, b + 1 }, { a, b + 1, a + 1 } } };
          for (const auto& [p, q, r] : halves)
          {
            soup.Triangles.push_back(isHigh ? Triangle{ p, q, r } : Triangle{ p, r, q });
          }
        }
      }
    }
  }
  return soup;
}

/** The tolerance that a warning advises. */
double AdvisedIn(const std::string& warning)
{
  const std::string before = "TouchTolerance ";
  const std::size_t at = warning.find(before);
  return at == std::string::npos ? 0 : std::stod(warning.substr(at + before.size()));
}

TEST(NearBodies, AreToldOfAndTouchWithTheAdvisedTolerance)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1.5, 1.5), size(0.5, 4);
  int told = 0;
  for (int turn = 0; turn < 60; ++turn)
  {
    const Turn turned(random);
    const double x = place(random), y = place(random), dx = size(random), dy = size(random);
    const double scale = std::pow(10.0, turn % 7 * 3 - 9);
    const Point low = { x * scale, y * scale, scale };
    const Point high = { (x + dx) * scale, (y + dy) * scale, 2 * scale };
    const std::vector<TriangleSoup> soups = { turned(Box(
                                                { -scale, -scale, 0 }, { scale, scale, scale })),
      turned(turn % 2 == 0 ? Box(low, high) : FineBox(low, high)) };
    const double common = std::max(0.0, std::min(1.0, x + dx) - std::max(-1.0, x)) *
      std::max(0.0, std::min(1.0, y + dy) - std::max(-1.0, y)) * scale * scale;
    const double rounding = 1e-9 * scale * scale;
    const ResolvedBodies apart = Resolved(soups);
    if (InterfaceOf(apart) > common - rounding)
    {
      EXPECT_EQ(apart.Warnings, std::vector<std::string>()) << turn;
      EXPECT_EQ(apart.NearTriangles, 0);
      continue;
    }
    ++told;
    ASSERT_EQ(apart.Warnings.size(), 1u) << turn;
    EXPECT_EQ(apart.Warnings[0].rfind("bodies A and B nearly touch: " +
                  std::to_string(apart.NearTriangles) + " triangles are within ",
                0),
      0u)
      << apart.Warnings[0];
    const double advised = AdvisedIn(apart.Warnings[0]);
    EXPECT_LE(advised, 1e-12 * scale) << apart.Warnings[0];
    const ResolvedBodies touching = Resolved(soups, advised);
    EXPECT_EQ(touching.NearTriangles, 0);
    EXPECT_NEAR(InterfaceOf(touching), common, rounding) << apart.Warnings[0];
  }
  EXPECT_GT(told, 5);
}

TEST(NearBodies, AreNotThoseThatTouchCrossOrAreFartherApart)
{
  const TriangleSoup box = Box({ -1, -1, 0 }, { 1, 1, 1 });
  std::mt19937 random(2);
  const Turn turned(random);
  const TriangleSoup above = Box({ -0.5, -0.5, 1 }, { 3, 3, 2 });
  const TriangleSoup within = Box({ -0.5, -0.5, 0.5 }, { 3, 3, 2 });
  const TriangleSoup apart = Box({ -0.5, -0.5, 1 + 1e-9 }, { 3, 3, 2 });
  const std::vector<std::vector<TriangleSoup>> all = { { box, above },
    { turned(box), turned(apart) }, { turned(box), turned(within) }, { turned(box), turned(box) },
    { turned(box) }, { turned(Join(box, above)) } };
  for (const std::vector<TriangleSoup>& soups : all)
  {
    const ResolvedBodies bodies = Resolved(soups);
    EXPECT_EQ(bodies.NearTriangles, 0);
    EXPECT_EQ(bodies.Warnings, std::vector<std::string>());
  }
}

TEST(NearBodies, AreNamedAsLongAsTheyAreFew)
{
  const std::vector<std::string> names = { "foot", "leg", "knee" };
  const std::vector<NearBodies> near(12, { 0, 2, 4, 3e-16, 1e-14 });
  std::vector<std::string> lines = WordsOf(near, names, 0);
  ASSERT_EQ(lines.size(), 11u);
  EXPECT_EQ(lines[9],
    "bodies foot and knee nearly touch: 4 triangles are within 3e-16 of the other's; "
    "TouchTolerance 1e-14 makes them one interface");
  EXPECT_EQ(lines[10], "2 more pairs of bodies nearly touch");
  lines = WordsOf({ { 1, 2, 7, 3e-16, 1e-15 } }, names, 1e-15); // it did not
  EXPECT_EQ(lines,
    std::vector<std::string>(
      { "bodies leg and knee nearly touch: 7 triangles are within 3e-16 of the other's" }));
}
} // namespace
