// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/Outliers.h"

#include "Common/Error.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;
using testtetrahedra::RandomInside;

/** Give the faces of the mesh to `facets` facets at random, several pieces each. */
FacetComplex DealFaces(TetrahedralMesh& mesh, unsigned seed, int facets)
{
  FacetComplex surface = testtetrahedra::RandomFaces(mesh, seed);
  surface.Facets.resize(facets);
  surface.Multiplicity.resize(facets);
  surface.NumberOfConstraints = facets;
  for (std::array<Id, 4>& ids : mesh.Facets)
  {
    for (Id& id : ids)
    {
      id = id == None ? None : id % facets;
    }
  }
  return surface;
}

Triangle Sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

/** Faces of the mesh on facets, by their points: the facet, and how many inside cells touch it. */
std::map<Triangle, std::pair<Id, int>> Pieces(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  std::map<Triangle, std::pair<Id, int>> pieces;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Facets[cell][k] != None)
      {
        const std::array<int, 3>& corners = TetrahedronFaces[k];
        const Tetrahedron& points = mesh.Cells[cell];
        auto& piece =
          pieces[Sorted({ points[corners[0]], points[corners[1]], points[corners[2]] })];
        piece.first = mesh.Facets[cell][k];
        piece.second += inside[cell];
      }
    }
  }
  return pieces;
}

std::vector<OutlierPiece> OutlierPieces(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside)
{
  Monitor monitor;
  return OutlierPieces(surface, mesh, inside, monitor, { "extracting", 0, 1 });
}

TEST(OutlierPieces, AreThoseThatTouchNoInsideCell)
{
  std::size_t outlying = 0;
  std::size_t satisfied = 0;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    TetrahedralMesh mesh = Grid(seed, 3);
    const FacetComplex surface = DealFaces(mesh, seed, 30);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    std::set<std::pair<Triangle, Id>> expected;
    for (const auto& [corners, piece] : Pieces(mesh, inside))
    {
      if (piece.second == 0)
      {
        expected.insert({ corners, piece.first });
      }
      satisfied += piece.second != 0;
    }
    std::set<std::pair<Triangle, Id>> found;
    Id last = 0;
    for (const OutlierPiece& piece : OutlierPieces(surface, mesh, inside))
    {
      EXPECT_TRUE(found.insert({ Sorted(piece.Corners), piece.Facet }).second);
      EXPECT_EQ(piece.Reason, OutlierReason::Energy);
      EXPECT_LE(last, piece.Facet);
      last = piece.Facet;
    }
    outlying += expected.size();
    EXPECT_EQ(found, expected);
  }
  EXPECT_GT(outlying, 100u);
  EXPECT_GT(satisfied, 100u);
}

TEST(OutlierPieces, RunAlongTheirFacets)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    TetrahedralMesh mesh = Grid(seed, 3);
    const FacetComplex surface = testtetrahedra::RandomFaces(mesh, seed);
    const std::vector<OutlierPiece> pieces =
      OutlierPieces(surface, mesh, std::vector<unsigned char>(mesh.Cells.size(), 0));
    EXPECT_EQ(pieces.size(), surface.Facets.size()); // each facet is one face there
    for (const OutlierPiece& piece : pieces)
    {
      Triangle facet = surface.Facets[piece.Facet];
      std::rotate(
        facet.begin(), std::find(facet.begin(), facet.end(), piece.Corners[0]), facet.end());
      EXPECT_EQ(piece.Corners, facet);
    }
  }
}

TEST(OutlierPieces, IncludeLostUnresolvedAndMissingFacetsWithTheReason)
{
  TetrahedralMesh mesh = Grid(1, 3);
  FacetComplex surface = DealFaces(mesh, 1, 30);
  const auto reasons = [&](const std::vector<unsigned char>& inside)
  {
    std::map<Id, OutlierReason> found;
    for (const OutlierPiece& piece : OutlierPieces(surface, mesh, inside))
    {
      found[piece.Facet] = piece.Reason;
      if (piece.Reason != OutlierReason::Energy)
      {
        EXPECT_EQ(piece.Corners, surface.Facets[piece.Facet]);
      }
    }
    return found;
  };
  using Found = std::map<Id, OutlierReason>;
  const std::vector<unsigned char> all(mesh.Cells.size(), 1);
  const std::vector<unsigned char> none(mesh.Cells.size(), 0);
  EXPECT_EQ(reasons(all), Found());
  EXPECT_EQ(reasons(none).size(), 30u);

  mesh.LostFacets = { 17 };
  EXPECT_EQ(reasons(all), Found({ { 17, OutlierReason::Lost } }));
  surface.NumberOfConstraints = 28;
  EXPECT_EQ(reasons(all),
    Found({ { 17, OutlierReason::Lost }, { 28, OutlierReason::LeftOut },
      { 29, OutlierReason::LeftOut } }));
  EXPECT_EQ(reasons(none).size(), 30u);
  EXPECT_EQ(reasons(none).at(28), OutlierReason::LeftOut);
  EXPECT_EQ(reasons(none).at(16), OutlierReason::Energy);

  surface.Facets.push_back(surface.Facets[0]); // a constraint that no face carries
  surface.NumberOfConstraints = 31;
  EXPECT_EQ(reasons(all), Found({ { 17, OutlierReason::Lost }, { 30, OutlierReason::Lost } }));
}

TEST(OutlierPieces, CanBeStopped)
{
  TetrahedralMesh mesh = Grid(1, 10);
  const FacetComplex surface = testtetrahedra::RandomFaces(mesh, 1);
  const std::vector<unsigned char> inside = RandomInside(mesh, 1);
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { OutlierPieces(surface, mesh, inside, monitor, range); });
  EXPECT_EQ(reports, 2);
}

TEST(OutlierPieces, WantOneLabelPerCell)
{
  TetrahedralMesh mesh = Grid(1, 1);
  const FacetComplex surface = testtetrahedra::RandomFaces(mesh, 1);
  try
  {
    OutlierPieces(surface, mesh, std::vector<unsigned char>(5, 1));
    FAIL() << "five labels for six cells are an error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    EXPECT_STREQ(error.what(), "5 inside labels for 6 cells");
  }
}
} // namespace
