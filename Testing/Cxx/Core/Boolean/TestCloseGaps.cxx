// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/CloseGaps.h"

#include "Boolean/ResolveBodies.h"
#include "Common/Vectors.h"
#include "Support/BodiesOfSoups.h"
#include "Support/TestMeshes.h"
#include "Support/Turn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

constexpr double Tolerance = 1e-3;

struct Areas
{
  double All = 0;
  double Common = 0; ///< of facets that count for two bodies
};

Areas AreasOfResolved(const std::vector<TriangleSoup>& soups, double tolerance = Tolerance)
{
  Monitor monitor;
  BodyParameters parameters;
  parameters.Chain.MergeTolerance = tolerance;
  const ResolvedBodies bodies = ResolveBodies(BodiesOf(soups), parameters, monitor);
  Areas areas;
  for (Id f = 0; f < bodies.Surface.NumberOfFacets(); ++f)
  {
    const auto [a, b, c] = CornersOf(bodies.Surface.Points, bodies.Surface.Facets[f]);
    const double area = Length(NormalOf(a, b, c)) / 2;
    areas.All += area;
    areas.Common += bodies.CountOffsets[f + 1] - bodies.CountOffsets[f] == 2 ? area : 0;
  }
  return areas;
}

TEST(CloseGaps, MakesOneInterfaceOfFlatFacesThatNearlyTouch)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-1.5, 1.5), size(0.5, 4);
  for (int turn = 0; turn < 40; ++turn)
  {
    const Turn turned(random);
    const double x = place(random), y = place(random), dx = size(random), dy = size(random);
    const double gap = (turn % 2 == 0 ? 0.6 : -0.6) * Tolerance; // of both kinds
    const auto areas = AreasOfResolved({ turned(Box({ -1, -1, 0 }, { 1, 1, 1 })),
      turned(Box({ x, y, 1 + gap }, { x + dx, y + dy, 2 })) });
    const double common = std::max(0.0, std::min(1.0, x + dx) - std::max(-1.0, x)) *
      std::max(0.0, std::min(1.0, y + dy) - std::max(-1.0, y));
    EXPECT_NEAR(areas.Common, common, 1e-9) << turn;
    // A corner whose facets are above none of A stays, and tilts them by less than this.
    EXPECT_NEAR(areas.All, 16 + 2 * (dx * dy + (dx + dy)) - common, 2 * (dx + dy) * Tolerance)
      << turn;
  }
}

/** Whether the faces happen to cross or not. */
TEST(CloseGaps, MakesFacesOneThatTouchUpToRounding)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-1.5, 0.5), size(0.6, 4);
  for (int turn = 0; turn < 60; ++turn)
  {
    const Turn turned(random);
    const double x = place(random), y = place(random), dx = size(random), dy = size(random);
    const Areas areas = AreasOfResolved(
      { turned(Box({ -1, -1, 0 }, { 1, 1, 1 })), turned(Box({ x, y, 1 }, { x + dx, y + dy, 2 })) },
      1e-12);
    const double common = std::max(0.0, std::min(1.0, x + dx) - std::max(-1.0, x)) *
      std::max(0.0, std::min(1.0, y + dy) - std::max(-1.0, y));
    EXPECT_NEAR(areas.Common, common, 1e-9) << turn;
    EXPECT_NEAR(areas.All, 16 + 2 * (dx * dy + dx + dy) - common, 1e-9) << turn;
  }
}

TEST(CloseGaps, LeavesWiderGaps)
{
  Monitor monitor;
  for (const double gap : { 1.1, -1.1, 3.0 })
  {
    std::vector<Body> bodies = BodiesOf({ Box({ -1, -1, 0 }, { 1, 1, 1 }),
      Box({ -0.5, -0.5, 1 + gap * Tolerance }, { 0.5, 0.5, 2 }) });
    const std::vector<Point> points = bodies[1].Soup.Points;
    EXPECT_EQ(CloseGaps(bodies, Tolerance, monitor), 0);
    EXPECT_EQ(bodies[1].Soup.Points, points);
  }
}

TEST(CloseGaps, MovesPointsIntoThreePlanesAtOnce)
{
  std::mt19937 random(2);
  const TriangleSoup corner = Join(Box({ -1, -1, -1 }, { 3, 3, 0 }),
    Join(Box({ -1, -1, -1 }, { 0, 3, 3 }), Box({ -1, -1, -1 }, { 3, 0, 3 })));
  const double gap = 0.4 * Tolerance;
  for (int turn = 0; turn < 10; ++turn)
  {
    const Turn turned(random);
    const Areas areas =
      AreasOfResolved({ turned(corner), turned(Box({ gap, gap, gap }, { 1, 1, 1 })) });
    EXPECT_NEAR(areas.Common, 3, 1e-9);
  }
}

TEST(CloseGaps, LeavesFacesBesideEachOtherInOnePlane)
{
  // Tops that differ a little in height, of bodies that stand side by side and one in a wide gap.
  std::vector<Body> bodies = BodiesOf({ Box({ 0, 0, 0 }, { 1, 1, 1 }),
    Box({ 1 + 2 * Tolerance, 0, 0 }, { 2, 1, 1 + 0.5 * Tolerance }) });
  Monitor monitor;
  EXPECT_EQ(CloseGaps(bodies, Tolerance, monitor), 0);
}

TEST(CloseGaps, MovesNoPointFartherAndTearsNothing)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Monitor monitor;
  Id allMoved = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    std::vector<Body> bodies = BodiesOf({ GridSoup(seed, 40, 4), RandomSoup(seed, 30),
      GridSoup(seed + 100, 40, 4), GridSoup(seed + 200, 30, 3) });
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> small(-0.1, 0.1);
    std::map<Point, Point> shaken; // alike where points are in one place
    for (Point& p : bodies[2].Soup.Points)
    {
      p = shaken.insert({ p, { p[0] + small(random), p[1] + small(random), p[2] + small(random) } })
            .first->second;
    }
    bodies[3].Soup.Points[0][1] = nan;
    bodies[3].Soup.Triangles.push_back({ 0, 1, 1 << 20 });
    bodies[3].Soup.Triangles.push_back({ -1, 1, 2 });
    const std::vector<Body> given = bodies;
    const double tolerance = 0.25;
    allMoved += CloseGaps(bodies, tolerance, monitor);
    EXPECT_EQ(bodies[0].Soup.Points, given[0].Soup.Points);
    for (std::size_t b = 1; b < bodies.size(); ++b)
    {
      std::map<Point, Point> moved;
      for (std::size_t p = b == 3 ? 1 : 0; p < bodies[b].Soup.Points.size(); ++p)
      {
        const Point& before = given[b].Soup.Points[p];
        const Point& after = bodies[b].Soup.Points[p];
        EXPECT_LE(Distance(before, after), tolerance);
        EXPECT_EQ(moved.insert({ before, after }).first->second, after);
      }
    }
  }
  EXPECT_GT(allMoved, 100);
}
TEST(CloseGaps, StopsWhenItIsToldTo)
{
  struct Stopper : Monitor
  {
    bool Continue(const char*, double) override { return false; }
  } stopper;
  std::vector<Body> bodies =
    BodiesOf({ Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0, 0, 1 }, { 1, 1, 2 }) });
  try
  {
    CloseGaps(bodies, Tolerance, stopper);
    FAIL() << "it went on";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Stopped);
  }
}

TEST(CloseGaps, TakesEmptyBodiesAndToleranceBeyondAllSizes)
{
  const TriangleSoup low = Box({ -1, -1, 0 }, { 1, 1, 1 });
  const TriangleSoup high = Box({ -0.5, -0.5, 1 + Tolerance / 2 }, { 0.5, 0.5, 2 });
  const double expected = AreasOfResolved({ low, high }).Common;
  EXPECT_NEAR(expected, 1, 1e-12);
  EXPECT_EQ(AreasOfResolved({ {}, low, {}, {}, high, {} }).Common, expected);
  EXPECT_THROW(AreasOfResolved({ low, high }, 1e300), Error); // all points are one
  EXPECT_THROW(AreasOfResolved({ low, high }, std::numeric_limits<double>::infinity()), Error);
}
} // namespace
