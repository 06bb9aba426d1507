// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/InteriorFaces.h"

#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace insideout;
using namespace testtetrahedra;

TEST(InteriorFaces, GivesEachFaceBetweenTwoCellsOnce)
{
  const TetrahedralMesh mesh = Grid(3, 7);
  std::size_t sides = 0;
  for (const auto& neighbors : mesh.Neighbors)
  {
    for (const Id neighbor : neighbors)
    {
      sides += neighbor != None;
    }
  }
  const std::vector<InteriorFace> faces = InteriorFaces(mesh);
  EXPECT_EQ(2 * faces.size(), sides);
  for (const InteriorFace& face : faces)
  {
    EXPECT_LT(face.First, face.Second);
    EXPECT_GT(face.Area, 0);
  }
}

TEST(InteriorFaces, GivesTheSameAreasAtEverySize)
{
  TetrahedralMesh mesh = Grid(3, 7);
  const std::vector<InteriorFace> expected = InteriorFaces(mesh);
  const std::vector<Point> points = mesh.Points;
  for (const int exponent : { -1000, -500, 500, 1000 })
  {
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      for (int i = 0; i < 3; ++i)
      {
        mesh.Points[p][i] = std::ldexp(points[p][i], exponent);
      }
    }
    const std::vector<InteriorFace> faces = InteriorFaces(mesh);
    ASSERT_EQ(faces.size(), expected.size());
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      EXPECT_EQ(faces[f].Area, expected[f].Area) << exponent;
    }
  }
}
