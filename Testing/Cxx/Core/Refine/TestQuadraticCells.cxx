// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/QuadraticCells.h"

#include "Common/Error.h"
#include "Common/Vectors.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

using namespace insideout;
using testtetrahedra::Grid;

TEST(QuadraticCells, HaveOnePointAmidEachEdge)
{
  const TetrahedralMesh grid = Grid(2, 3);
  const Id corners = static_cast<Id>(grid.Points.size());
  const QuadraticCells quadratic = MakeQuadraticCells(corners, grid.Cells);
  ASSERT_EQ(quadratic.Cells.size(), grid.Cells.size());

  // As vtkQuadraticTetra has them.
  const int ends[6][2] = { { 0, 1 }, { 1, 2 }, { 0, 2 }, { 0, 3 }, { 1, 3 }, { 2, 3 } };
  std::set<std::set<Id>> edges;
  for (std::size_t c = 0; c < grid.Cells.size(); ++c)
  {
    const QuadraticTetrahedron& cell = quadratic.Cells[c];
    for (int k = 0; k < 4; ++k)
    {
      EXPECT_EQ(cell[k], grid.Cells[c][k]);
    }
    for (int k = 0; k < 6; ++k)
    {
      const std::set<Id> edge = { cell[ends[k][0]], cell[ends[k][1]] };
      ASSERT_GE(cell[4 + k], corners);
      const Edge& amid = quadratic.Edges.at(cell[4 + k] - corners);
      EXPECT_EQ((std::set<Id>{ amid[0], amid[1] }), edge);
      edges.insert(edge);
    }
  }
  EXPECT_EQ(quadratic.Edges.size(), edges.size());
}

TEST(QuadraticCells, AreRefusedWhereTheirPointsCannotBeCounted)
{
  EXPECT_THROW(
    MakeQuadraticCells(std::numeric_limits<Id>::max() - 5, { { { 0, 1, 2, 3 } } }), Error);
  EXPECT_NO_THROW(MakeQuadraticCells(std::numeric_limits<Id>::max() - 6, { { { 0, 1, 2, 3 } } }));
}

TEST(QuadraticCells, AreAsStraightAsDoublesCanBe)
{
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(Midpoint({ 1, -3, 0.1 }, { 2, 5, 0.3 }), (Point{ 1.5, 1, (0.1 + 0.3) / 2 }));
  EXPECT_EQ(Midpoint({ most, 0, 0 }, { most, 0, 0 }), (Point{ most, 0, 0 }));
  EXPECT_EQ(
    Midpoint({ 0.1, 0.7, 1e9 }, { 0.3, 1e-9, 3 }), Midpoint({ 0.3, 1e-9, 3 }, { 0.1, 0.7, 1e9 }));
}
