// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace testflips;

namespace
{
/** Whether one of the lines begins with the name of a law. */
bool Breaks(const std::vector<std::string>& lines, const std::string& law)
{
  return std::any_of(lines.begin(), lines.end(),
    [&law](const std::string& line) { return line.rfind(law + ": ", 0) == 0; });
}

/** An octahedron around its center, with facets. */
MeshWithFacets Octahedron()
{
  const std::vector<Point> points = { { { 0, 0, 0 } }, { { 4, 0, 0 } }, { { -4, 0, 0 } },
    { { 0, 4, 0 } }, { { 0, -4, 0 } }, { { 0, 0, 4 } }, { { 0, 0, -4 } } };
  return MeshWithFacets(
    DelaunayMesh(points), { { { 0, 1, 3 } }, { { 0, 3, 2 } }, { { 1, 3, 5 } }, { { 0, 2, 6 } } });
}

Id FirstCell(const MeshRecord& mesh, bool infinite)
{
  Id cell = 0;
  while (mesh.IsDead(cell) || mesh.IsInfinite(cell) != infinite)
  {
    ++cell;
  }
  return cell;
}

/** All cells with the same permutation of corners, neighbors and facets. */
void SwapCorners(FlippableCell& cell, int i, int j)
{
  std::swap(cell.Corners[i], cell.Corners[j]);
  std::swap(cell.Neighbors[i], cell.Neighbors[j]);
  std::swap(cell.Facets[i], cell.Facets[j]);
}
} // namespace

TEST(FlippableMeshLaws, HoldForDelaunayMeshesAndForOnesThatFlipsAndSplitsChanged)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 14, 4);
    ExpectFlippableMeshLaws(mesh.Mesh);
    const MeshRecord before(mesh.Mesh);
    std::mt19937 random(seed);
    mesh.FlipAtRandom(random, 30);
    ExpectFlippableMeshLaws(mesh.Mesh, before);
    const FlippableCell cell = CellAt(mesh.Mesh, FiniteCells(mesh.Mesh)[0]);
    mesh.SplitEdge(cell.Corners[0], cell.Corners[1]);
    mesh.SplitFace({ FiniteCells(mesh.Mesh)[2], 1 });
    ExpectFlippableMeshLaws(mesh.Mesh, before, FacetsKept::AsAreas);
    EXPECT_TRUE(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets).empty());
  }
}

TEST(FlippableMeshLaws, AreBrokenByAnyTwoNeighborsThatAreSwapped)
{
  const MeshRecord mesh(Octahedron().Mesh);
  ASSERT_TRUE(Violations(mesh).empty());
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    MeshRecord broken = mesh;
    std::swap(broken.Cells[cell].Neighbors[0], broken.Cells[cell].Neighbors[3]);
    EXPECT_TRUE(Breaks(Violations(broken), "neighbors"));
    broken.Cells[cell].Neighbors[0] = None;
    EXPECT_TRUE(Breaks(Violations(broken), "neighbors"));
  }
}

TEST(FlippableMeshLaws, AreBrokenByCornersThatAreTurnedOverOrTheSame)
{
  const MeshRecord mesh(Octahedron().Mesh);
  for (Id cell = 0; cell < static_cast<Id>(mesh.Cells.size()); ++cell)
  {
    MeshRecord broken = mesh;
    SwapCorners(broken.Cells[cell], 1, 2);
    EXPECT_TRUE(Breaks(Violations(broken), mesh.IsInfinite(cell) ? "hull" : "orientation"));
    EXPECT_TRUE(mesh.IsInfinite(cell) || Breaks(Violations(broken), "volume"));
    broken.Cells[cell].Corners[1] = broken.Cells[cell].Corners[2];
    EXPECT_TRUE(Breaks(Violations(broken), "corners"));
  }
}

TEST(FlippableMeshLaws, AreBrokenByAFaceOfThreeCells)
{
  MeshRecord broken(Octahedron().Mesh);
  broken.Cells.push_back(broken.Cells[FirstCell(broken, false)]);
  EXPECT_TRUE(Breaks(Violations(broken), "faces"));
}

TEST(FlippableMeshLaws, AreBrokenByACellThatIsGone)
{
  MeshRecord broken(Octahedron().Mesh);
  broken.Cells[FirstCell(broken, false)].Corners[0] = None;
  EXPECT_TRUE(Breaks(Violations(broken), "neighbors"));
  EXPECT_TRUE(Breaks(Violations(broken), "faces"));
}

TEST(FlippableMeshLaws, AreBrokenByAFlatCell)
{
  MeshRecord broken(Octahedron().Mesh);
  broken.Places[0] = broken.Places[1];
  EXPECT_TRUE(Breaks(Violations(broken), "orientation"));
  EXPECT_FALSE(Breaks(Violations(broken), "volume"));
}

TEST(FlippableMeshLaws, AreBrokenByAHullThatIsReflex)
{
  // Two cells; the second's apex moves to where the face between them does not hide it from the
  // first's.
  MeshRecord broken(DelaunayMesh(
    { { { 0, 0, 0 } }, { { 8, 0, 0 } }, { { 0, 8, 0 } }, { { 0, 0, 8 } }, { { 9, 9, 9 } } }));
  broken.Places[4] = { Rational(3), Rational(4), Rational(8) };
  ASSERT_TRUE(Violations(broken).empty());
  broken.Places[4] = { Rational(-1), Rational(4), Rational(8) };
  EXPECT_TRUE(Breaks(Violations(broken), "hull"));
  EXPECT_FALSE(Breaks(Violations(broken), "orientation"));
}

TEST(FlippableMeshLaws, AreBrokenByAVertexThatNamesACellOfOthers)
{
  const MeshRecord mesh(Octahedron().Mesh);
  MeshRecord broken = mesh;
  Id other = 0;
  while (broken.Cells[other].Corners[0] == 5 || broken.Cells[other].Corners[1] == 5 ||
    broken.Cells[other].Corners[2] == 5 || broken.Cells[other].Corners[3] == 5)
  {
    ++other;
  }
  broken.CellOf[5] = other;
  EXPECT_TRUE(Breaks(Violations(broken), "vertices"));
  broken.CellOf[5] = None;
  EXPECT_TRUE(Breaks(Violations(broken), "vertices"));
}

TEST(FlippableMeshLaws, AreBrokenByAFacetOnOneSideOnly)
{
  const MeshRecord mesh(Octahedron().Mesh);
  ASSERT_EQ(FacesOfFacets(mesh).size(), 4u);
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      MeshRecord broken = mesh;
      Id& facet = broken.Cells[cell].Facets[k];
      facet = facet == None ? 7 : None;
      EXPECT_TRUE(Breaks(Violations(broken), "facets"));
    }
  }
}

TEST(FlippableMeshLaws, AreBrokenByTwoMeshesInOne)
{
  // The second has vertices of its own, in the same places, but for the infinite one.
  const MeshRecord mesh(Octahedron().Mesh);
  MeshRecord broken = mesh;
  const Id cells = static_cast<Id>(mesh.Cells.size());
  const Id vertices = static_cast<Id>(mesh.Places.size());
  for (FlippableCell cell : mesh.Cells)
  {
    for (int k = 0; k < 4; ++k)
    {
      cell.Corners[k] += cell.Corners[k] == mesh.Infinite ? 0 : vertices;
      cell.Neighbors[k] += cells;
    }
    broken.Cells.push_back(cell);
  }
  for (Id vertex = 0; vertex < vertices; ++vertex)
  {
    broken.Places.push_back(mesh.Places[vertex]);
    broken.CellOf.push_back(vertex == mesh.Infinite ? None : mesh.CellOf[vertex] + cells);
  }
  const std::vector<std::string> lines = Violations(broken);
  EXPECT_TRUE(Breaks(lines, "vertices"));
  EXPECT_TRUE(Breaks(lines, "Euler"));
  EXPECT_FALSE(Breaks(lines, "neighbors"));
  EXPECT_FALSE(Breaks(lines, "orientation"));
}

TEST(FlippableMeshLaws, NoticeFacetsThatAreLostOrCoverAnotherPart)
{
  MeshWithFacets mesh = Octahedron();
  const MeshRecord before(mesh.Mesh);
  EXPECT_TRUE(ChangeViolations(before, before, FacetsKept::AsFaces).empty());
  const MeshFace face = mesh.Mesh.FindFaces({ { { 0, 1, 3 } } })[0];
  mesh.Mesh.SetFacet(face.Cell, face.Face, None);
  EXPECT_TRUE(
    Breaks(ChangeViolations(before, MeshRecord(mesh.Mesh), FacetsKept::AsFaces), "kept facets"));
  EXPECT_TRUE(
    Breaks(ChangeViolations(before, MeshRecord(mesh.Mesh), FacetsKept::AsAreas), "kept facets"));
  mesh.Mesh.SetFacet(face.Cell, face.Face, 1);
  EXPECT_TRUE(
    Breaks(ChangeViolations(before, MeshRecord(mesh.Mesh), FacetsKept::AsAreas), "kept facets"));
  EXPECT_TRUE(Breaks(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), "kept facets"));
}

TEST(FlippableMeshLaws, NoticeAPieceOfASplitFacetThatIsLost)
{
  MeshWithFacets mesh = Octahedron();
  const MeshRecord before(mesh.Mesh);
  const Id point = mesh.SplitFace(mesh.Mesh.FindFaces({ { { 0, 1, 3 } } })[0]);
  EXPECT_TRUE(
    Breaks(ChangeViolations(before, MeshRecord(mesh.Mesh), FacetsKept::AsFaces), "kept facets"));
  EXPECT_TRUE(ChangeViolations(before, MeshRecord(mesh.Mesh), FacetsKept::AsAreas).empty());
  EXPECT_TRUE(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets).empty());
  const MeshFace piece = mesh.Mesh.FindFaces({ { { 0, 1, point } } })[0];
  mesh.Mesh.SetFacet(piece.Cell, piece.Face, None);
  EXPECT_TRUE(
    Breaks(ChangeViolations(before, MeshRecord(mesh.Mesh), FacetsKept::AsAreas), "kept facets"));
  EXPECT_TRUE(Breaks(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), "kept facets"));
}

TEST(FlippableMeshLaws, NoticeASegmentThatIsNoEdge)
{
  MeshWithFacets mesh = Octahedron();
  EXPECT_TRUE(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets).empty());
  const Id segment = mesh.Segments.Find(1, 3);
  mesh.Segments.Release(segment);
  EXPECT_TRUE(Breaks(ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets), "segments"));
}

TEST(FlippableMeshLaws, NoticeAnotherVolume)
{
  const MeshRecord before(Octahedron().Mesh);
  MeshRecord after = before;
  after.Places[5][2] = Rational(5);
  EXPECT_TRUE(Violations(after).empty());
  EXPECT_TRUE(Breaks(ChangeViolations(before, after, FacetsKept::AsFaces), "kept volume"));
}

TEST(FlippableMeshLaws, CoverTheSameOnlyWhereTrianglesDo)
{
  // A square in a slanted plane, its corners, its middle, and a point off the plane.
  std::vector<Vector> places;
  for (const std::array<double, 2>& p : std::vector<std::array<double, 2>>{
         { { 0, 0 } }, { { 3, 0 } }, { { 3, 3 } }, { { 0, 3 } }, { { 1.5, 1.5 } } })
  {
    places.push_back(testmeshes::Exact({ { p[0], p[1], p[0] / 3 + p[1] / 4 } }));
  }
  places.push_back(testmeshes::Exact({ { 1.5, 1.5, 0 } }));
  const std::set<Triangle> square = { { { 0, 1, 2 } }, { { 0, 2, 3 } } };
  EXPECT_TRUE(CoverTheSame(places, square, { { { 0, 1, 3 } }, { { 1, 2, 3 } } }));
  EXPECT_TRUE(CoverTheSame(
    places, square, { { { 0, 1, 4 } }, { { 1, 2, 4 } }, { { 2, 3, 4 } }, { { 0, 3, 4 } } }));
  EXPECT_FALSE(CoverTheSame(places, { { { 0, 1, 2 } } }, { { { 0, 1, 3 } } }));
  EXPECT_FALSE(CoverTheSame(places, square, { { { 0, 1, 4 } }, { { 1, 2, 4 } }, { { 2, 3, 4 } } }));
  EXPECT_FALSE(CoverTheSame(
    places, square, { { { 0, 1, 5 } }, { { 1, 2, 5 } }, { { 2, 3, 5 } }, { { 0, 3, 5 } } }));
  EXPECT_FALSE(CoverTheSame(places, square, {}));
}
