// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/Seeds.h"

#include "Common/Error.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;

Point Between(const TetrahedralMesh& mesh, const std::vector<Id>& points)
{
  Point sum = { 0, 0, 0 };
  for (const Id p : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      sum[axis] += mesh.Points[p][axis] / static_cast<double>(points.size());
    }
  }
  return sum;
}

SeededCells Find(const TetrahedralMesh& mesh, const std::vector<Seed>& seeds)
{
  return FindSeededCells(mesh.Points, mesh.Cells, seeds);
}

TEST(Seeds, LieInTheCellThatContainsThem)
{
  const TetrahedralMesh mesh = Grid(1, 4);
  std::vector<Seed> seeds;
  for (Id cell = 0; cell < mesh.NumberOfCells(); cell += 3)
  {
    const Tetrahedron& t = mesh.Cells[cell];
    seeds.push_back({ Between(mesh, { t.begin(), t.end() }), cell % 2 == 0 });
  }
  const SeededCells found = Find(mesh, seeds);
  EXPECT_EQ(found.Conflicts, 0);
  EXPECT_TRUE(found.Warnings.empty());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    EXPECT_EQ(found.Demands[cell], cell % 3 != 0 ? 0 : cell % 2 == 0 ? 1 : -1);
    EXPECT_EQ(found.Seeds[cell], cell % 3 != 0 ? None : cell / 3);
  }
}

TEST(Seeds, OnSharedPointsBelongToTheCellOfLowestId)
{
  const TetrahedralMesh mesh = Grid(2, 3);
  for (Id p = 0; p < static_cast<Id>(mesh.Points.size()); p += 5)
  {
    Id lowest = None;
    for (Id cell = mesh.NumberOfCells() - 1; cell >= 0; --cell)
    {
      const Tetrahedron& t = mesh.Cells[cell];
      lowest = std::find(t.begin(), t.end(), p) != t.end() ? cell : lowest;
    }
    const SeededCells found = Find(mesh, { { mesh.Points[p], true } });
    for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      EXPECT_EQ(found.Demands[cell], cell == lowest);
    }
  }
}

/** A unit in the last place off a face is on its one side, and the predicate knows it. */
TEST(Seeds, AreOnTheRightSideOfAFaceByAHair)
{
  TetrahedralMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 }, { 0, 0, 1 } };
  mesh.Cells = { { 0, 2, 1, 3 }, { 0, 1, 2, 4 } };
  const double hair = std::numeric_limits<double>::denorm_min();
  const auto cellAt = [&](double z)
  {
    const SeededCells found = Find(mesh, { { { 0.3, 0.3, z }, true } });
    return found.Demands[0] == 1 ? 0 : found.Demands[1] == 1 ? 1 : -1;
  };
  EXPECT_EQ(cellAt(-hair), 0);
  EXPECT_EQ(cellAt(0), 0);
  EXPECT_EQ(cellAt(hair), 1);
}

TEST(Seeds, ThatContradictAnEarlierOneAreNamed)
{
  const TetrahedralMesh mesh = Grid(1, 1);
  const Tetrahedron& t = mesh.Cells[2];
  const Point centre = Between(mesh, { t.begin(), t.end() });
  const SeededCells found = Find(mesh, { { centre, true }, { centre, true }, { centre, false } });
  EXPECT_EQ(found.Demands[2], 1);
  EXPECT_EQ(found.Conflicts, 1);
  ASSERT_EQ(found.Warnings.size(), 1u);
  EXPECT_EQ(found.Warnings[0],
    "seed 2 is to be outside, but lies in one cell with seed 0, which is to be inside and comes "
    "first: it does not count");
}

TEST(Seeds, BeyondTheHullAreOutsideAnyway)
{
  const TetrahedralMesh mesh = Grid(1, 1);
  const SeededCells outside = Find(mesh, { { { 1e6, 0, 0 }, false } });
  EXPECT_EQ(outside.Conflicts, 0);
  const SeededCells inside = Find(mesh, { { { 0, 0, 0 }, false }, { { 1e6, 0, 0 }, true } });
  EXPECT_EQ(inside.Conflicts, 1);
  ASSERT_EQ(inside.Warnings.size(), 1u);
  EXPECT_EQ(
    inside.Warnings[0], "seed 1 is to be inside, but lies beyond all cells: it does not count");
}

TEST(Seeds, ThatAreNotFiniteAreNamed)
{
  const TetrahedralMesh mesh = Grid(1, 1);
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    try
    {
      Find(mesh, { { { 0, 0, 0 }, true }, { { 0, bad, 0 }, true } });
      ADD_FAILURE();
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::PointNotFinite);
      EXPECT_STREQ(error.what(), "seed 1 is not finite");
    }
  }
}
} // namespace
