// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SolidFaces.h"

#include "Common/Error.h"

#include <gtest/gtest.h>

#include <limits>

using namespace insideout;

namespace
{
/** Two tetrahedra on the face 1 2 3. */
SolidMesh TwoCells()
{
  SolidMesh solid;
  solid.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  solid.Cells = { { 0, 1, 2, 3 }, { 4, 2, 1, 3 } };
  return solid;
}

std::vector<std::array<int, 2>> Pairs(const std::vector<CellFace>& faces)
{
  std::vector<std::array<int, 2>> pairs;
  for (const CellFace& face : faces)
  {
    pairs.push_back({ { face.Cell, face.Face } });
  }
  return pairs;
}

template <typename Work>
void ExpectError(ErrorCode code, const std::string& words, const Work& work)
{
  try
  {
    work();
    ADD_FAILURE() << "no error: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code) << error.what();
    EXPECT_EQ(error.what(), words);
  }
}

using Faces = std::vector<std::array<int, 2>>;
} // namespace

TEST(SolidFaces, OfOneCellAreTheOuterOnes)
{
  // Face 1 of both is the one between them.
  EXPECT_EQ(Pairs(OuterFaces(TwoCells())),
    (Faces{ { 0, 0 }, { 0, 2 }, { 0, 3 }, { 1, 0 }, { 1, 2 }, { 1, 3 } }));
}

TEST(SolidFaces, OfTrianglesAreFoundByTheirPlaces)
{
  const SolidMesh solid = TwoCells();
  const std::vector<Point> points = { { 5, 5, 5 }, { 0, 0, 1 }, { 1, 0, 0 }, { -0.0, -0.0, 0 },
    { 0, 1, 0 } };
  EXPECT_EQ(Pairs(FacesOfTriangles(solid, points, { { 3, 2, 1 }, { 1, 2, 3 }, { 2, 1, 3 } })),
    (Faces{ { 0, 0 }, { 0, 0 }, { 0, 0 } }));
}

TEST(SolidFaces, BetweenCellsAreOfTheOneThatTheTriangleFacesAwayFrom)
{
  const SolidMesh solid = TwoCells();
  const Triangle first = FaceOf(solid.Cells[0], 1);
  const Triangle second = FaceOf(solid.Cells[1], 1);
  const Triangle turned = { { first[1], first[2], first[0] } };
  EXPECT_EQ(Pairs(FacesOfTriangles(solid, solid.Points, { first, second, turned })),
    (Faces{ { 0, 1 }, { 1, 1 }, { 0, 1 } }));
}

TEST(SolidFaces, OfCellsThatShareNoPointsAreFoundToo)
{
  SolidMesh solid = TwoCells();
  // The second cell gets points of its own, in the same places.
  solid.Points.insert(solid.Points.end(), solid.Points.begin(), solid.Points.end());
  solid.Cells[1] = { { 9, 7, 6, 8 } };
  const std::vector<Triangle> triangles = { FaceOf(solid.Cells[0], 1), FaceOf(solid.Cells[1], 1),
    FaceOf({ { 4, 2, 1, 3 } }, 1), FaceOf(solid.Cells[1], 2) };
  EXPECT_EQ(Pairs(FacesOfTriangles(solid, solid.Points, triangles)),
    (Faces{ { 0, 1 }, { 1, 1 }, { 1, 1 }, { 1, 2 } }));
  EXPECT_EQ(OuterFaces(solid).size(), 8u);
}

TEST(SolidFaces, OfLayersAreOfTheCellThatTheTriangleFacesAwayFrom)
{
  // Two prisms with points of their own, one above the other, and a tetrahedron below them.
  SolidMesh solid;
  for (const double z : { 0, 1, 1, 2 })
  {
    solid.Points.insert(solid.Points.end(), { { 0, 0, z }, { 0, 1, z }, { 1, 0, z } });
  }
  solid.Points.push_back({ 0, 0, -1 });
  solid.Cells = { { 0, 1, 2, 12 } };
  solid.Prisms = { { { 0, 1, 2, 3, 4, 5 } }, { { 6, 7, 8, 9, 10, 11 } } };
  std::vector<Triangle> triangles;
  Faces faces;
  for (const int cell : { 2, 1 })
  {
    for (const int face : { 0, 1 })
    {
      const std::array<Id, 4> corners = FaceOfLayer(solid, { cell, face });
      EXPECT_EQ(corners[3], None);
      triangles.push_back({ { corners[0], corners[1], corners[2] } });
      faces.push_back({ { cell, face } });
    }
  }
  for (int k = 0; k < 4; ++k)
  {
    triangles.push_back(FaceOf(solid.Cells[0], k));
    faces.push_back({ { 0, k } });
  }
  EXPECT_EQ(Pairs(FacesOfTriangles(solid, solid.Points, triangles)), faces);
  // A triangle that faces into the only cell on it is of that cell.
  const Triangle& top = triangles[1];
  EXPECT_EQ(Pairs(FacesOfTriangles(solid, solid.Points, { { { top[1], top[0], top[2] } } })),
    (Faces{ { 2, 1 } }));
  // A quad, however it is cut: points 0 and 1 are below 3 and 4.
  EXPECT_EQ(Pairs(FacesOfTriangles(
              solid, solid.Points, { { 0, 3, 4 }, { 0, 4, 1 }, { 0, 3, 1 }, { 3, 4, 1 } })),
    (Faces{ { 1, 2 }, { 1, 2 }, { 1, 2 }, { 1, 2 } }));
  EXPECT_TRUE(IsQuad(solid, { 1, 2 }));
  EXPECT_FALSE(IsQuad(solid, { 1, 1 }));
}

TEST(SolidFaces, ThatAreNoneAreNamed)
{
  const SolidMesh solid = TwoCells();
  const Triangle face = FaceOf(solid.Cells[0], 0);
  ExpectError(ErrorCode::InvalidParameter,
    "triangle 1 of the boundary is not a face of the solid's cells",
    [&]() {
      FacesOfTriangles(solid, solid.Points, { face, { { 0, 1, 4 } } });
    });
  ExpectError(ErrorCode::InvalidParameter,
    "triangle 0 of the boundary is not a face of the solid's cells",
    [&]() {
      FacesOfTriangles(solid, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 2 } }, { { { 0, 1, 2 } } });
    });
  ExpectError(ErrorCode::PointOutOfRange, "triangle 1 of the boundary refers to point 5 of 5",
    [&]() {
      FacesOfTriangles(solid, solid.Points, { face, { { 0, 1, 5 } } });
    });
}

TEST(SolidFaces, OfCellsThatAreNoneAreNot)
{
  SolidMesh solid = TwoCells();
  solid.Cells[1][2] = 5;
  ExpectError(
    ErrorCode::PointOutOfRange, "cell 1 refers to point 5 of 5", [&]() { OuterFaces(solid); });
  solid = TwoCells();
  solid.Midpoints = { { { 0, 0, 0, 0, 0, 0 } }, { { 0, 0, 0, 0, 0, -1 } } };
  ExpectError(
    ErrorCode::PointOutOfRange, "cell 1 refers to point -1 of 5", [&]() { OuterFaces(solid); });
  solid = TwoCells();
  solid.Points[3][1] = std::numeric_limits<double>::quiet_NaN();
  ExpectError(ErrorCode::PointNotFinite, "point 3 has a coordinate that is infinite or no number",
    [&]() { FacesOfTriangles(solid, solid.Points, {}); });
  ExpectError(
    ErrorCode::InvalidParameter, "the grid has no cells", [&]() { OuterFaces(SolidMesh()); });
}
