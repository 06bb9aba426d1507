// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/CellParts.h"

#include "Common/Error.h"
#include "GraphCut/InteriorFaces.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <tuple>

using namespace insideout;
using namespace testtetrahedra;

namespace
{
/** The faces of tetrahedra, each beginning at a random corner and running either way. */
CellParts SidesOf(const TetrahedralMesh& mesh, unsigned seed)
{
  std::mt19937 random(seed);
  CellParts sides;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (const std::array<int, 3>& face : TetrahedronFaces)
    {
      Triangle corners = { mesh.Cells[cell][face[0]], mesh.Cells[cell][face[1]],
        mesh.Cells[cell][face[2]] };
      std::shuffle(corners.begin(), corners.end(), random);
      sides.Add(cell, corners);
    }
  }
  return sides;
}

/** A cube's side that looks along an axis, corners numbered by the bits of their coordinates. */
std::vector<Id> SideOfCube(int axis, int end)
{
  const Id u = 1 << (axis + 1) % 3;
  const Id v = 1 << (axis + 2) % 3;
  const Id corner = end << axis;
  return { corner, corner + u, corner + u + v, corner + v };
}
} // namespace

TEST(SharedSides, AreTheInteriorFacesOfTetrahedra)
{
  const TetrahedralMesh mesh = Grid(5, 4);
  std::vector<InteriorFace> expected = InteriorFaces(mesh); // in another unit
  std::vector<InteriorFace> faces = SharedSides(mesh.Points, SidesOf(mesh, 11));
  const auto byCells = [](const InteriorFace& a, const InteriorFace& b)
  { return std::tie(a.First, a.Second) < std::tie(b.First, b.Second); };
  std::sort(expected.begin(), expected.end(), byCells);
  std::sort(faces.begin(), faces.end(), byCells);
  ASSERT_EQ(faces.size(), expected.size());
  const double unit = faces[0].Area / expected[0].Area;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    EXPECT_EQ(faces[f].First, expected[f].First);
    EXPECT_EQ(faces[f].Second, expected[f].Second);
    EXPECT_NEAR(faces[f].Area, unit * expected[f].Area, 1e-13 * faces[f].Area);
  }
}

TEST(SharedSides, KnowAPolygonByItsCornersAndAnEdgeByItsEnds)
{
  // Two boxes in a row: only the side between them, 2 by 4, is shared.
  std::vector<Point> points;
  for (int i = 0; i < 12; ++i)
  {
    points.push_back({ (i & 1) * 2.0, (i >> 1 & 1) * 4.0, (i >> 2) * 3.0 });
  }
  CellParts sides;
  for (Id box = 0; box < 2; ++box)
  {
    for (int side = 0; side < 6; ++side)
    {
      std::vector<Id> corners = SideOfCube(side / 2, side % 2);
      std::for_each(corners.begin(), corners.end(), [&](Id& corner) { corner += 4 * box; });
      if (box == 1)
      {
        std::reverse(corners.begin(), corners.end());
      }
      sides.Add(box, corners);
    }
  }
  std::vector<InteriorFace> faces = SharedSides(points, sides);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].First, 0);
  EXPECT_EQ(faces[0].Second, 1);
  EXPECT_EQ(faces[0].Area, 8);

  // Two triangles on an edge of length 5.
  CellParts edges;
  const Triangle triangles[2] = { { 0, 1, 2 }, { 2, 1, 3 } };
  for (Id cell = 0; cell < 2; ++cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.Add(cell, std::array<Id, 2>{ triangles[cell][k], triangles[cell][(k + 1) % 3] });
    }
  }
  faces = SharedSides({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 4, 0 }, { 3, 4, 1 } }, edges);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].Area, 5);
}

TEST(SharedSides, OfThreeCellsAreAnErrorThatNamesThem)
{
  const TetrahedralMesh mesh = Grid(2, 2);
  const Id first = 3;
  const auto& neighbors = mesh.Neighbors[first];
  const auto face =
    std::find_if(neighbors.begin(), neighbors.end(), [](Id neighbor) { return neighbor > first; });
  ASSERT_NE(face, neighbors.end());
  CellParts sides = SidesOf(mesh, 1);
  Triangle corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = mesh.Cells[first][TetrahedronFaces[face - neighbors.begin()][k]];
  }
  sides.Add(mesh.NumberOfCells(), corners);
  try
  {
    SharedSides(mesh.Points, sides);
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    EXPECT_EQ(error.what(),
      "cells 3, " + std::to_string(*face) + " and " + std::to_string(mesh.NumberOfCells()) +
        " share one face: the grid does not conform");
  }
}

TEST(CellSizes, OfTetrahedraAreTheirVolumes)
{
  const TetrahedralMesh mesh = Grid(4, 4);
  CellParts simplices;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    simplices.Add(cell, mesh.Cells[cell]);
  }
  const std::vector<double> sizes = CellSizes(mesh.Points, simplices, mesh.NumberOfCells());
  const std::vector<double> expected = CellVolumes(mesh); // in another unit
  ASSERT_EQ(sizes.size(), expected.size());
  const double unit = sizes[0] / expected[0];
  for (std::size_t c = 0; c < sizes.size(); ++c)
  {
    EXPECT_NEAR(sizes[c], unit * expected[c], 1e-13 * sizes[c]);
  }
}

TEST(CellSizes, AddUpHoweverACellIsCut)
{
  // A pentagon, not convex, as triangles; then a cell of no simplex.
  const std::vector<Point> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 2, 0 },
    { 0, 4, 0 } };
  CellParts one;
  one.Add(0, Triangle{ 0, 1, 3 });
  one.Add(0, Triangle{ 1, 2, 3 });
  one.Add(0, Triangle{ 3, 4, 0 });
  EXPECT_EQ(CellSizes(points, one, 2), (std::vector<double>{ 12, 0 }));
}
