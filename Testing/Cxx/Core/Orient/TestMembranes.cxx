// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/OrientFacets.h"

#include "Common/Vectors.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

struct Oriented
{
  FacetComplex Surface;
  SurfaceCounts Counts;
  FacetTurns Turns;

  double At(const Point& p) const
  {
    Monitor monitor;
    return SurfaceWindingNumber(this->Surface, {}, monitor).At(p);
  }
};

TriangleSoup Scaled(TriangleSoup soup, double factor)
{
  for (Point& p : soup.Points)
  {
    p = { factor * p[0], factor * p[1], factor * p[2] };
  }
  return soup;
}

/** Sizes at which products of coordinates over- or underflow, too. */
constexpr double Sizes[] = { 1e-200, 1, 1e200 };

Oriented Orient(const TriangleSoup& soup)
{
  Monitor monitor;
  CountedChain chain = CountFacets(soup, {}, monitor);
  Oriented oriented = { std::move(chain.Surface), chain.Counts, {} };
  oriented.Turns = OrientFacets(oriented.Surface, chain.Edges, Orientation::Automatic, monitor);
  return oriented;
}

/** A bent square of edge 2 about a point, turned at random. */
TriangleSoup Sheet(const Point& at, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  std::array<Point, 3> frame;
  for (int k = 0; k < 3; ++k)
  {
    Point& axis = frame[k];
    axis = { normal(random), normal(random), normal(random) };
    for (int i = 0; i < k; ++i)
    {
      const double along = Dot(axis, frame[i]);
      for (int j = 0; j < 3; ++j)
      {
        axis[j] -= along * frame[i][j];
      }
    }
    const double length = Length(axis);
    axis = { axis[0] / length, axis[1] / length, axis[2] / length };
  }
  TriangleSoup sheet;
  constexpr Id Steps = 6;
  for (Id i = 0; i <= Steps; ++i)
  {
    for (Id j = 0; j <= Steps; ++j)
    {
      const double u = 2.0 * i / Steps - 1;
      const double v = 2.0 * j / Steps - 1;
      Point p = at;
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] += u * frame[0][axis] + v * frame[1][axis] + 0.1 * u * v * frame[2][axis];
      }
      sheet.Points.push_back(p);
    }
  }
  for (Id i = 0; i < Steps; ++i)
  {
    for (Id j = 0; j < Steps; ++j)
    {
      const Id a = i * (Steps + 1) + j;
      sheet.Triangles.push_back({ a, a + Steps + 1, a + 1 });
      sheet.Triangles.push_back({ a + 1, a + Steps + 1, a + Steps + 2 });
    }
  }
  return sheet;
}

/** A tube along z with n sides; its upper end may be closed. */
TriangleSoup Tube(double radius, double from, double to, bool closed)
{
  TriangleSoup tube;
  constexpr Id Sides = 24;
  for (Id i = 0; i < Sides; ++i)
  {
    const double a = 2 * 3.14159265358979 * i / Sides;
    tube.Points.push_back({ radius * std::cos(a), radius * std::sin(a), from });
    tube.Points.push_back({ radius * std::cos(a), radius * std::sin(a), to });
    const Id next = 2 * ((i + 1) % Sides);
    tube.Triangles.push_back({ 2 * i, next, next + 1 });
    tube.Triangles.push_back({ 2 * i, next + 1, 2 * i + 1 });
  }
  for (Id i = 2; closed && i < Sides; ++i)
  {
    tube.Triangles.push_back({ 1, 2 * i - 1, 2 * i + 1 });
  }
  return tube;
}

TEST(Membranes, LeaveTheWindingNumberOfAClosedSurfaceAsItIs)
{
  std::mt19937 random(45);
  std::uniform_real_distribution<double> anywhere(-0.6, 0.6);
  for (int sheets = 1; sheets <= 12; ++sheets)
  {
    TriangleSoup soup = Box({ -1.5, -1, -1 }, { 1, 1.5, 1 });
    for (int i = 0; i < sheets; ++i)
    {
      soup = Join(soup, Sheet({ anywhere(random), anywhere(random), anywhere(random) }, random));
    }
    const Oriented oriented = Orient(soup);
    for (std::size_t f = 0; f < oriented.Surface.Facets.size(); ++f)
    {
      ASSERT_EQ(oriented.Surface.Multiplicity[f], f < 12 ? 1 : 0) << sheets << " sheets, " << f;
    }
    EXPECT_EQ(oriented.Turns.Kinds.Closed, 1);
    EXPECT_EQ(oriented.Turns.Membranes + oriented.Turns.Kinds.Sheets, sheets);
    EXPECT_EQ(oriented.Turns.TurnedFacets, 0);
  }
}

TEST(Membranes, OutsideThatSealOffNoSpaceAreSheetsThatDoNotCount)
{
  std::mt19937 random(46);
  std::uniform_real_distribution<double> anywhere(-6, 6);
  const TriangleSoup closed = Box({ -1, -1, -1 }, { 1, 1, 1 });
  TriangleSoup open = closed;
  open.Triangles.resize(10); // without its last side
  for (const TriangleSoup& body : { closed, open })
  {
    Id given = 0;
    Id counting = 0; // two that face each other closely are a slab with an open rim
    for (int trial = 0; trial < 20; ++trial)
    {
      TriangleSoup soup = body;
      const int sheets = 1 + 2 * trial;
      for (int i = 0; i < sheets; ++i)
      {
        Point at;
        do // one near the hole may be its lid
        {
          at = { anywhere(random), anywhere(random), anywhere(random) };
        } while (Length(at) < 4);
        soup = Join(soup, Sheet(at, random));
      }
      const FacetTurns turns = Orient(soup).Turns;
      EXPECT_EQ(turns.Kinds.Sheets, sheets);
      EXPECT_EQ(turns.TurnedFacets, 0);
      EXPECT_TRUE(turns.Warnings.empty());
      EXPECT_EQ(turns.UncountedWarnings.size(), 1u);
      given += sheets;
      counting += sheets - turns.UncountedSheets;
    }
    EXPECT_LE(counting, given / 50);
  }
}

TEST(Membranes, FromWallToWallDoNotCount)
{
  // Floors of one tower, given once, facing up or down, at whose edges the walls are cut.
  for (unsigned facing = 0; facing < 16; ++facing)
  {
    TriangleSoup tower;
    for (int floor = 0; floor < 5; ++floor)
    {
      TriangleSoup storey = Box({ 0, 0, 0.2 * floor }, { 1, 1, 0.2 * (floor + 1) });
      tower = Join(tower, storey);
    }
    // Both copies of each floor are left out, and one is given again, whichever way it faces.
    TriangleSoup open;
    open.Points = tower.Points;
    const auto isFloor = [&](const Triangle& t)
    {
      const double z = tower.Points[t[0]][2];
      return tower.Points[t[1]][2] == z && tower.Points[t[2]][2] == z && z > 0.1 && z < 0.9;
    };
    const auto normalZ = [&](const Triangle& t)
    {
      const Point& a = tower.Points[t[0]];
      const Point& b = tower.Points[t[1]];
      const Point& c = tower.Points[t[2]];
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    for (const Triangle& t : tower.Triangles)
    {
      const int floor = static_cast<int>(std::lround(tower.Points[t[0]][2] / 0.2)) - 1;
      if (!isFloor(t) || (normalZ(t) > 0) == (facing >> floor % 4 & 1))
      {
        open.Triangles.push_back(t);
      }
    }
    const Oriented oriented = Orient(open);
    EXPECT_EQ(oriented.Turns.Membranes, 4) << facing;
    EXPECT_EQ(oriented.Turns.MembraneFacets, 8);
    for (const double z : { 0.1, 0.3, 0.5, 0.7, 0.9 })
    {
      EXPECT_NEAR(oriented.At({ 0.4, 0.3, z }), 1, 1e-9) << facing << " at " << z;
    }
    EXPECT_NEAR(oriented.At({ 0.4, 0.3, 1.1 }), 0, 1e-9);
    for (const double size : Sizes)
    {
      EXPECT_EQ(Orient(Scaled(open, size)).Turns.Membranes, 4) << facing << " of size " << size;
    }
  }
}

TEST(Membranes, AreNoPadsOnTheSolid)
{
  // A thin cover without a back, a hair's breadth above the body, whose rim is within it.
  const TriangleSoup body = Box({ -2, -2, -2 }, { 2, 2, 0 });
  TriangleSoup pad = Box({ -1, -1, -0.05 }, { 1, 1, 0.2 });
  pad.Triangles.erase(
    std::remove_if(pad.Triangles.begin(), pad.Triangles.end(),
      [&](const Triangle& t)
      { return std::all_of(t.begin(), t.end(), [&](Id p) { return pad.Points[p][2] < 0; }); }),
    pad.Triangles.end());
  EXPECT_EQ(pad.Triangles.size(), 10u);
  const Oriented oriented = Orient(Join(body, pad));
  EXPECT_EQ(oriented.Turns.Membranes, 0);
  EXPECT_GT(oriented.At({ 0.1, 0.2, 0.1 }), 0.5);
}

TEST(Membranes, AreNoTubesAndDomesThatStandOnTheSolid)
{
  const TriangleSoup body = Box({ -2, -2, -2 }, { 2, 2, 0 });
  for (const bool closed : { false, true })
  {
    for (const double from : { 0.0, -0.3 })
    {
      const Oriented oriented = Orient(Join(body, Tube(0.8, from, 1.6, closed)));
      EXPECT_EQ(oriented.Turns.Membranes, 0);
      EXPECT_GT(oriented.At({ 0.1, 0.2, 0.6 }), 0.5);
    }
  }
}

TEST(Membranes, AreNoWallsThatBoundSpaceTogether)
{
  // A closed body, and a box of six squares that nothing joins.
  TriangleSoup soup = Box({ 5, 0, 0 }, { 6, 1, 1 });
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  for (std::size_t side = 0; side < 6; ++side)
  {
    TriangleSoup wall;
    wall.Points = box.Points;
    wall.Triangles = { box.Triangles[2 * side], box.Triangles[2 * side + 1] };
    for (Point& p : wall.Points)
    {
      p[0] += 1e-3 * static_cast<double>(side);
    }
    soup = Join(soup, wall);
  }
  const Oriented oriented = Orient(soup);
  EXPECT_EQ(oriented.Turns.Membranes, 0);
  EXPECT_EQ(oriented.Turns.Kinds.Sheets, 6);
  EXPECT_NEAR(oriented.At({ 0.5, 0.5, 0.5 }), 1, 0.01);
}

TEST(Membranes, AreNoLids)
{
  // Five sides of a box, and a lid apart in its hole, a hundredth above or below it.
  TriangleSoup open = Box({ 0, 0, 0 }, { 1, 1, 1 });
  std::stable_partition(open.Triangles.begin(), open.Triangles.end(),
    [&](const Triangle& t)
    { return std::any_of(t.begin(), t.end(), [&](Id p) { return open.Points[p][2] < 1; }); });
  TriangleSoup lid = open;
  lid.Triangles.erase(lid.Triangles.begin(), lid.Triangles.begin() + 10);
  open.Triangles.resize(10);
  EXPECT_LT(Orient(open).At({ 0.5, 0.5, 0.9 }), 0.7);
  for (const double z : { 0.99, 1.0, 1.01 })
  {
    TriangleSoup moved = lid;
    for (Point& p : moved.Points)
    {
      p = { 0.99 * p[0] + 0.005, 0.99 * p[1] + 0.005, z };
    }
    const Oriented oriented = Orient(Join(open, moved));
    EXPECT_EQ(oriented.Turns.Membranes + oriented.Turns.UncountedSheets, 0) << z;
    EXPECT_GT(oriented.At({ 0.5, 0.5, 0.9 }), 0.9) << z;
  }
}

TEST(Membranes, AreNoneWhereNothingElseBoundsASolid)
{
  std::mt19937 random(9);
  const Oriented oriented = Orient(Join(Sheet({ 0, 0, 0 }, random), Sheet({ 1, 0, 0 }, random)));
  EXPECT_EQ(oriented.Turns.Membranes, 0);
  EXPECT_EQ(oriented.Surface.Multiplicity[0], 1);
}

TEST(CopiesOfFacets, CountAsOftenAsClosedShellsNeedThem)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 3);
  for (int trial = 0; trial < 500; ++trial)
  {
    // Boxes of unit squares on a grid share facets in either direction, and overlap.
    TriangleSoup soup;
    std::vector<std::array<int, 6>> boxes;
    while (boxes.size() < 3)
    {
      std::array<int, 6> b;
      for (int axis = 0; axis < 3; ++axis)
      {
        b[axis] = coordinate(random);
        b[axis + 3] = b[axis] + 1 + coordinate(random) % 2;
      }
      if (std::find(boxes.begin(), boxes.end(), b) != boxes.end())
      {
        continue;
      }
      boxes.push_back(b);
      const auto square = [&](int axis, int at, int u, int v, bool up)
      {
        const Id first = static_cast<Id>(soup.Points.size());
        for (int k = 0; k < 4; ++k)
        {
          Point p;
          p[axis] = at;
          p[(axis + 1) % 3] = u + (k == 1 || k == 2);
          p[(axis + 2) % 3] = v + (k >= 2);
          soup.Points.push_back(p);
        }
        const auto add = [&](Id i, Id j, Id k)
        {
          soup.Triangles.push_back(up ? Triangle{ { first + i, first + j, first + k } }
                                      : Triangle{ { first + i, first + k, first + j } });
        };
        add(0, 1, 2);
        add(0, 2, 3);
      };
      for (int axis = 0; axis < 3; ++axis)
      {
        const int i = (axis + 1) % 3;
        const int j = (axis + 2) % 3;
        for (int u = b[i]; u < b[i + 3]; ++u)
        {
          for (int v = b[j]; v < b[j + 3]; ++v)
          {
            square(axis, b[axis], u, v, false);
            square(axis, b[axis + 3], u, v, true);
          }
        }
      }
    }
    const Oriented oriented = Orient(soup);
    EXPECT_EQ(oriented.Turns.Kinds.Sheets + oriented.Turns.Membranes, 0) << trial;
    for (int sample = 0; sample < 20; ++sample)
    {
      std::array<int, 3> cell;
      int inside = 0;
      for (int& c : cell)
      {
        c = coordinate(random) + sample % 2;
      }
      for (const auto& b : boxes)
      {
        bool in = true;
        for (int axis = 0; axis < 3; ++axis)
        {
          in = in && cell[axis] >= b[axis] && cell[axis] < b[axis + 3];
        }
        inside += in;
      }
      const Point p = { cell[0] + 0.3, cell[1] + 0.4, cell[2] + 0.6 };
      ASSERT_EQ(std::lround(oriented.At(p)) > 0, inside > 0) << "trial " << trial;
    }
    EXPECT_EQ(oriented.Turns.Shells, 3) << trial;
    for (const double size : Sizes)
    {
      EXPECT_EQ(Orient(Scaled(soup, size)).Turns.Shells, 3) << trial << " of size " << size;
    }
  }
}

/** A block of 3 by 3 by 3 unit cubes without those of the middle column, in unit squares. */
TriangleSoup BlockWithHole(const std::array<int, 3>& at)
{
  const auto isSolid = [](const std::array<int, 3>& c)
  {
    return std::all_of(c.begin(), c.end(), [](int i) { return i >= 0 && i < 3; }) &&
      (c[0] != 1 || c[1] != 1);
  };
  TriangleSoup block;
  for (int i = 0; i < 27; ++i)
  {
    const std::array<int, 3> cell = { { i % 3, i / 3 % 3, i / 9 } };
    for (int side = 0; isSolid(cell) && side < 6; ++side)
    {
      const int axis = side / 2;
      std::array<int, 3> beyond = cell;
      beyond[axis] += side % 2 ? 1 : -1;
      if (isSolid(beyond))
      {
        continue;
      }
      std::array<Id, 4> corners;
      for (int k = 0; k < 4; ++k)
      {
        std::array<int, 3> p = cell;
        p[axis] += side % 2;
        p[(axis + 1) % 3] += k == 1 || k == 2;
        p[(axis + 2) % 3] += k >= 2;
        corners[side % 2 ? k : (4 - k) % 4] = static_cast<Id>(block.Points.size());
        block.Points.push_back({ static_cast<double>(p[0] + at[0]),
          static_cast<double>(p[1] + at[1]), static_cast<double>(p[2] + at[2]) });
      }
      block.Triangles.push_back({ corners[0], corners[1], corners[2] });
      block.Triangles.push_back({ corners[0], corners[2], corners[3] });
    }
  }
  return Merged(block);
}

TEST(CopiesOfFacets, AreOfOneShellEachWhereSurfacesCrossThatShareThem)
{
  const TriangleSoup block = BlockWithHole({ 0, 0, 0 });
  for (int i = 0; i < 27; ++i)
  {
    const std::array<int, 3> step = { { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 } };
    for (const bool inward : { false, true })
    {
      TriangleSoup other = BlockWithHole(step);
      if (i == 13)
      {
        continue; // the same again
      }
      if (inward)
      {
        other = Reversed(other);
      }
      // By the points as given, and by the order of facets.
      for (const TriangleSoup& both : { Join(block, other), Merged(Join(block, other)) })
      {
        const Oriented oriented = Orient(both);
        EXPECT_EQ(oriented.Turns.Kinds.Closed, 2) << i;
        EXPECT_EQ(oriented.Turns.Shells, 2) << i;
        EXPECT_EQ(oriented.Turns.TurnedShells, inward) << i;
      }
    }
  }
}

TEST(Cavities, StayWhereTheyShareParts)
{
  // The cavity shares parts of facets with the outer surface. A line crosses both at one place, but
  // for rounding.
  const Point low = { 0.1, 0.2, 0.3 };
  for (const double scale : { 1., 0.7, 1 / 3. })
  {
    const TriangleSoup outer = Scaled(Box(low, { 1.1, 1.2, 1.3 }), scale);
    const TriangleSoup inner = Scaled(Box(low, { 0.6, 0.7, 0.8 }), scale);
    const Oriented oriented = Orient(Join(outer, Reversed(inner)));
    EXPECT_EQ(oriented.Turns.TurnedFacets, 0) << scale;
    EXPECT_EQ(oriented.Turns.Kinds.Cavities, 1) << scale;
    EXPECT_NEAR(oriented.At({ 0.3 * scale, 0.4 * scale, 0.5 * scale }), 0, 1e-9);
    EXPECT_NEAR(oriented.At({ 0.9 * scale, 0.4 * scale, 0.5 * scale }), 1, 1e-9);
  }
}

TEST(CopiesOfFacets, ThatAreStrayDoNotCount)
{
  TriangleSoup cube = Box({ 0, 0, 0 }, { 1, 1, 1 });
  cube.Triangles.push_back(cube.Triangles[3]);
  cube.Triangles.push_back(cube.Triangles[3]);
  const Oriented stray = Orient(cube);
  EXPECT_EQ(stray.Counts.DuplicateFacets, 2);
  EXPECT_EQ(stray.Counts.SharedFacets, 0);
  EXPECT_EQ(stray.Turns.Shells, 1);
  cube.Triangles.resize(12);
  cube.Triangles.insert(cube.Triangles.end(), cube.Triangles.begin(), cube.Triangles.begin() + 12);
  const Oriented twice = Orient(cube);
  EXPECT_EQ(twice.Counts.DuplicateFacets, 12);
  EXPECT_EQ(twice.Turns.Shells, 1);
  EXPECT_NEAR(twice.At({ 0.5, 0.5, 0.5 }), 1, 1e-9);
}
} // namespace
