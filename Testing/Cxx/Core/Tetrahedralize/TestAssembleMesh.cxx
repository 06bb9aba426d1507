// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/AssembleMesh.h"

#include "Support/MeshLaws.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"
#include "Tetrahedralize/TetgenProcess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace insideout;

namespace
{
RawTetrahedra Answer(const FacetComplex& surface, SurfaceSteinerPoints steiner)
{
  Monitor monitor;
  return RunTetgen(surface.Points, surface.Facets, steiner, {}, monitor);
}

TetrahedralMesh Assembled(const FacetComplex& surface, const RawTetrahedra& answer)
{
  Monitor monitor;
  return AssembleMesh(surface, answer, monitor);
}

FacetComplex BoxComplex()
{
  return testmeshes::ToComplex(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
}

void ExpectInconsistent(
  const FacetComplex& surface, const RawTetrahedra& answer, const std::string& part)
{
  try
  {
    Assembled(surface, answer);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Inconsistent);
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

/**
 * An octahedron around the edge from point 0 to 1, and point 6, which rounding moved off it: the
 * triangle of points 0, 1 and 2 is a face, and nearly so are two triangles together that have point
 * 6. On the other side of the edge there are only two such.
 */
struct MeshBesideAnEdge
{
  const std::vector<Point> Points = { { { -1, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, -1, 0 } }, { { 0, 0, 1 } }, { { 0, 0, -1 } }, { { 0, -1e-14, -1e-14 } } };
  const std::vector<Tetrahedron> Cells = { { { 0, 1, 2, 4 } }, { { 0, 1, 4, 6 } },
    { { 0, 1, 6, 2 } }, { { 0, 6, 3, 4 } }, { { 6, 1, 3, 4 } }, { { 0, 6, 3, 5 } },
    { { 6, 1, 3, 5 } }, { { 0, 6, 2, 5 } }, { { 6, 1, 2, 5 } } };

  /** A surface of facets between all points but the last. */
  FacetComplex With(const std::vector<Triangle>& facets) const
  {
    return testmeshes::ToComplex({ { this->Points.begin(), this->Points.end() - 1 }, facets });
  }
};

/** An answer with a facet in pieces; the first such facet. */
struct SplitAnswer
{
  SplitAnswer()
    : Surface(testmeshes::ToComplex(testmeshes::TwistedPrism(8, -M_PI / 6)))
    , Whole(Answer(this->Surface, SurfaceSteinerPoints::Leave))
  {
    std::vector<int> pieces(this->Surface.Facets.size(), 0);
    for (const Id facet : this->Whole.FacetOfFaces)
    {
      ++pieces[facet];
    }
    this->Facet = static_cast<Id>(
      std::find_if(pieces.begin(), pieces.end(), [](int n) { return n > 1; }) - pieces.begin());
  }

  const FacetComplex Surface;
  const RawTetrahedra Whole;
  Id Facet;
};
} // namespace

TEST(AssembleMesh, RecognizesFacetsInPieces)
{
  const SplitAnswer answer;
  ASSERT_LT(answer.Facet, static_cast<Id>(answer.Surface.Facets.size()))
    << "TetGen split no facet: this test needs another surface";
  const TetrahedralMesh mesh = Assembled(answer.Surface, answer.Whole);
  testmeshes::ExpectMeshLaws(answer.Surface, mesh);
  EXPECT_TRUE(mesh.LostFacets.empty());
  EXPECT_GT(mesh.NumberOfSurfaceSteinerPoints, 0);
}

TEST(AssembleMesh, InterpolatesPointsOnFacets)
{
  const SplitAnswer answer;
  const TetrahedralMesh mesh = Assembled(answer.Surface, answer.Whole);
  int checked = 0;
  for (std::size_t p = answer.Surface.Points.size(); p < mesh.Points.size(); ++p)
  {
    const PointOrigin& origin = mesh.Origins[p];
    for (int axis = 0; origin.Points[0] != None && axis < 3; ++axis, ++checked)
    {
      double x = 0;
      for (int k = 0; k < 3; ++k)
      {
        x += origin.Weights[k] * mesh.Points[origin.Points[k]][axis];
      }
      EXPECT_NEAR(x, mesh.Points[p][axis], 1e-15);
    }
  }
  EXPECT_EQ(checked, 3 * mesh.NumberOfSurfaceSteinerPoints);
}

TEST(AssembleMesh, LosesAFacetWithAPieceMissing)
{
  const SplitAnswer answer;
  RawTetrahedra damaged = answer.Whole;
  const auto at =
    std::find(damaged.FacetOfFaces.begin(), damaged.FacetOfFaces.end(), answer.Facet) -
    damaged.FacetOfFaces.begin();
  damaged.FacetOfFaces.erase(damaged.FacetOfFaces.begin() + at);
  damaged.Faces.erase(damaged.Faces.begin() + at);
  const TetrahedralMesh mesh = Assembled(answer.Surface, damaged);
  testmeshes::ExpectMeshLaws(answer.Surface, mesh);
  EXPECT_EQ(mesh.LostFacets, std::vector<Id>{ answer.Facet });
}

TEST(AssembleMesh, LosesAFacetWithAPieceThatIsNoFace)
{
  const SplitAnswer answer;
  RawTetrahedra damaged = answer.Whole;
  damaged.Faces.push_back({ { 0, 6, 3 } });
  damaged.FacetOfFaces.push_back(answer.Facet);
  const TetrahedralMesh mesh = Assembled(answer.Surface, damaged);
  EXPECT_EQ(mesh.LostFacets, std::vector<Id>{ answer.Facet });
}

TEST(AssembleMesh, PrefersPiecesThatMatchToAFaceByChance)
{
  const MeshBesideAnEdge example;
  const TetrahedralMesh mesh = Assembled(example.With({ { { 0, 1, 2 } }, { { 1, 0, 3 } } }),
    { example.Points, example.Cells,
      { { { 0, 6, 2 } }, { { 6, 1, 2 } }, { { 0, 3, 6 } }, { { 6, 3, 1 } } }, { 0, 0, 1, 1 } });
  EXPECT_TRUE(mesh.LostFacets.empty());
  EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 1);
  std::array<int, 2> sides = { { 0, 0 } };
  for (const std::array<Id, 4>& cell : mesh.Facets)
  {
    for (const Id facet : cell)
    {
      if (facet != None)
      {
        ++sides[facet];
      }
    }
  }
  EXPECT_EQ(sides, (std::array<int, 2>{ { 4, 4 } }));
}

TEST(AssembleMesh, TakesTheWholeFaceWhereANeighborIsNotSplit)
{
  const MeshBesideAnEdge example;
  const TetrahedralMesh mesh = Assembled(example.With({ { { 0, 1, 2 } }, { { 0, 1, 4 } } }),
    { example.Points, example.Cells, { { { 0, 6, 2 } }, { { 6, 1, 2 } }, { { 0, 1, 4 } } },
      { 0, 0, 1 } });
  EXPECT_TRUE(mesh.LostFacets.empty());
  EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 0);
}

TEST(AssembleMesh, LosesFacetsWhoseNewPointsLieElsewhere)
{
  const SplitAnswer answer;
  RawTetrahedra damaged = answer.Whole;
  // Outwards, so that the cells around stay as they should.
  for (std::size_t p = answer.Surface.Points.size(); p < damaged.Points.size(); ++p)
  {
    for (double& x : damaged.Points[p])
    {
      x *= std::abs(x) > 0.5 ? 1 + 1e-9 : 1;
    }
  }
  const TetrahedralMesh mesh = Assembled(answer.Surface, damaged);
  EXPECT_NE(
    std::find(mesh.LostFacets.begin(), mesh.LostFacets.end(), answer.Facet), mesh.LostFacets.end());
  for (const auto& facets : mesh.Facets)
  {
    EXPECT_EQ(std::find(facets.begin(), facets.end(), answer.Facet), facets.end());
  }
  EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 0);
}

TEST(AssembleMesh, KeepsAFacetInPiecesAroundInputPointsThatLieOnItExactly)
{
  const std::vector<Triangle> around = { { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 2, 0, 3 } } };
  for (const double height : { 0.0, 1e-14 })
  {
    const FacetComplex surface =
      testmeshes::ToComplex({ { { { -2, -1, 0 } }, { { 2, -1, 0 } }, { { 0, 2, 0 } },
                                { { 0, 0, height } }, { { 0, 0, 1 } }, { { 0, 0, -1 } } },
        { { { 0, 1, 2 } } } });
    RawTetrahedra answer;
    answer.Points = surface.Points;
    answer.Faces = around;
    answer.FacetOfFaces = { 0, 0, 0 };
    for (const Triangle& t : around)
    {
      answer.Cells.push_back({ { t[0], t[1], t[2], 4 } });
      answer.Cells.push_back({ { t[0], t[1], t[2], 5 } });
    }
    const TetrahedralMesh mesh = Assembled(surface, answer);
    testmeshes::ExpectMeshLaws(surface, mesh);
    EXPECT_EQ(mesh.LostFacets, height == 0 ? std::vector<Id>() : std::vector<Id>{ 0 });
    EXPECT_EQ(mesh.NumberOfSurfaceSteinerPoints, 0);
    EXPECT_EQ(mesh.Origins[3].Points, (Triangle{ { 3, 3, 3 } }));
  }
}

TEST(AssembleMesh, KeepsFacetsInPiecesAroundInputPointsThatLieOnTheirEdgeExactly)
{
  for (const double y : { -1.0, -1 - 1e-14 })
  {
    const FacetComplex surface = testmeshes::ToComplex(
      { { { { -2, -1, 0 } }, { { 2, -1, 0 } }, { { 0, 2, 0 } }, { { 0, y, 0 } }, { { 0, -1, 1 } } },
        { { { 0, 1, 2 } }, { { 1, 0, 4 } } } });
    RawTetrahedra answer;
    answer.Points = surface.Points;
    answer.Cells = { { { 0, 3, 2, 4 } }, { { 3, 1, 2, 4 } } };
    answer.Faces = { { { 0, 3, 2 } }, { { 3, 1, 2 } }, { { 0, 3, 4 } }, { { 3, 1, 4 } } };
    answer.FacetOfFaces = { 0, 0, 1, 1 };
    const TetrahedralMesh mesh = Assembled(surface, answer);
    testmeshes::ExpectMeshLaws(surface, mesh);
    EXPECT_EQ(mesh.LostFacets, y == -1 ? std::vector<Id>() : (std::vector<Id>{ 0, 1 }));
  }
}

TEST(AssembleMesh, LosesAFacetThatIsNoFace)
{
  FacetComplex surface = BoxComplex();
  const RawTetrahedra answer = Answer(surface, SurfaceSteinerPoints::Avoid);
  // The other diagonal of a side.
  surface.Facets[0] = { { 0, 2, 1 } };
  surface.Facets[1] = { { 1, 2, 3 } };
  const TetrahedralMesh mesh = Assembled(surface, answer);
  EXPECT_EQ(mesh.LostFacets, (std::vector<Id>{ 0, 1 }));
  testmeshes::ExpectMeshLaws(surface, mesh);
}

TEST(AssembleMesh, DropsSteinerPointsThatNoCellUses)
{
  const SplitAnswer answer;
  const Id given = static_cast<Id>(answer.Surface.Points.size());
  RawTetrahedra padded = answer.Whole;
  padded.Points.insert(padded.Points.begin() + given, { { 0.1, 0.2, 0.3 } });
  padded.Points.push_back({ { 0.1, 0.2, 0.3 } });
  const auto shift = [given](auto& elements)
  {
    for (auto& element : elements)
    {
      for (Id& p : element)
      {
        p += p >= given;
      }
    }
  };
  shift(padded.Cells);
  shift(padded.Faces);
  const TetrahedralMesh expected = Assembled(answer.Surface, answer.Whole);
  const TetrahedralMesh mesh = Assembled(answer.Surface, padded);
  EXPECT_EQ(mesh.Points, expected.Points);
  EXPECT_EQ(mesh.Cells, expected.Cells);
  EXPECT_EQ(mesh.Facets, expected.Facets);
  // A marked face on such a point is none.
  padded.Faces.push_back({ { 0, 1, 8 } });
  padded.FacetOfFaces.push_back(answer.Facet);
  EXPECT_EQ(Assembled(answer.Surface, padded).LostFacets, std::vector<Id>{ answer.Facet });
}

TEST(AssembleMesh, RefusesPointsThatMoved)
{
  const FacetComplex surface = BoxComplex();
  RawTetrahedra answer = Answer(surface, SurfaceSteinerPoints::Avoid);
  answer.Points[5][2] = -answer.Points[5][2];
  ExpectInconsistent(surface, answer, "point 5 ");
  answer.Points[5][2] = std::nextafter(surface.Points[5][2], 2);
  ExpectInconsistent(surface, answer, "point 5 ");
}

TEST(AssembleMesh, RefusesASteinerPointThatIsNotFinite)
{
  const SplitAnswer answer;
  RawTetrahedra damaged = answer.Whole;
  damaged.Points.back()[1] = std::nan("");
  ExpectInconsistent(answer.Surface, damaged,
    "Steiner point " + std::to_string(damaged.Points.size() - 1) + " is not finite");
}

TEST(AssembleMesh, RefusesAPointInNoCell)
{
  FacetComplex surface = BoxComplex();
  RawTetrahedra answer = Answer(surface, SurfaceSteinerPoints::Avoid);
  surface.Points.push_back({ { 0.5, 0.5, 0.5 } });
  surface.Origins.push_back(PointOrigin::Input(8));
  answer.Points.push_back(surface.Points.back());
  ExpectInconsistent(surface, answer, "point 8 is in no cell");
}

TEST(AssembleMesh, RefusesAFlatCell)
{
  const FacetComplex surface = BoxComplex();
  RawTetrahedra answer = Answer(surface, SurfaceSteinerPoints::Avoid);
  answer.Cells.push_back({ { 0, 1, 2, 3 } });
  ExpectInconsistent(surface, answer,
    "cell " + std::to_string(answer.Cells.size() - 1) + " (points 0 1 2 3) is flat");
}

TEST(AssembleMesh, RefusesCellsThatOverlap)
{
  const FacetComplex surface = BoxComplex();
  RawTetrahedra answer = Answer(surface, SurfaceSteinerPoints::Avoid);
  RawTetrahedra twice = answer;
  twice.Cells.push_back(twice.Cells[0]);
  ExpectInconsistent(surface, twice, "face ");
  // On a hull face that one cell has, a second one on the same side.
  const TetrahedralMesh mesh = Assembled(surface, answer);
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[c][k] != None)
      {
        continue;
      }
      const Tetrahedron& cell = mesh.Cells[c];
      const std::array<int, 3>& corners = TetrahedronFaces[k];
      for (Id apex = 0; apex < 8; ++apex)
      {
        RawTetrahedra damaged = answer;
        damaged.Cells.push_back({ { cell[corners[0]], cell[corners[1]], cell[corners[2]], apex } });
        EXPECT_THROW(Assembled(surface, damaged), Error);
      }
    }
  }
}
