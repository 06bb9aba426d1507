// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/ConnectCells.h"

#include "Common/Error.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

using namespace insideout;
using testtetrahedra::Grid;

TEST(ConnectCells, FindsNeighborsAndTurnsNegativeCells)
{
  const TetrahedralMesh grid = Grid(1, 3);
  std::vector<Tetrahedron> cells = grid.Cells;
  for (std::size_t c = 0; c < cells.size(); c += 2)
  {
    std::swap(cells[c][2], cells[c][3]);
  }
  const TetrahedralMesh mesh = ConnectCells(grid.Points, cells);
  EXPECT_EQ(mesh.Cells, grid.Cells);
  EXPECT_EQ(mesh.Neighbors, grid.Neighbors);
}

TEST(ConnectCells, NamesThreeCellsThatShareAFace)
{
  try
  {
    ConnectCells({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 2 }, { 0, 0, -1 } },
      { { 0, 1, 2, 3 }, { 0, 1, 2, 4 }, { 0, 1, 2, 5 } });
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    EXPECT_STREQ(error.what(), "cells 0, 1 and 2 share one face: the grid does not conform");
  }
}
