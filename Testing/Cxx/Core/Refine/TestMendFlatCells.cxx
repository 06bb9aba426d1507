// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/MendFlatCells.h"

#include "Common/PointPredicates.h"
#include "Common/RawTetrahedra.h"
#include "Common/Team.h"
#include "Refine/CellShape.h"
#include "Support/AllowedThreads.h"
#include "Support/TestTetrahedra.h"
#include "Tetrahedralize/AssembleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

using namespace insideout;

namespace
{
std::ptrdiff_t CountFlat(const TetrahedralMesh& mesh)
{
  return std::count_if(mesh.Cells.begin(), mesh.Cells.end(),
    [&mesh](const Tetrahedron& cell) { return ShapeOf(mesh.Points, cell) < 1e-20; });
}

/** The faces of facets, sorted. */
std::vector<std::pair<Id, Triangle>> FacesOfFacets(const TetrahedralMesh& mesh)
{
  std::vector<std::pair<Id, Triangle>> faces;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Facets[c][k] != None && mesh.FacetSides[c][k] > 0)
      {
        Triangle face = FaceOf(mesh.Cells[c], k);
        std::sort(face.begin(), face.end());
        faces.emplace_back(mesh.Facets[c][k], face);
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/** Expect the mesh that is assembled and verified from its cells and faces of facets. */
void ExpectConsistent(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  RawTetrahedra raw = { mesh.Points, mesh.Cells, {}, {} };
  for (const auto& [facet, face] : FacesOfFacets(mesh))
  {
    raw.Faces.push_back(face);
    raw.FacetOfFaces.push_back(facet);
  }
  Monitor monitor;
  const TetrahedralMesh assembled = AssembleMesh(surface, raw, monitor);
  EXPECT_EQ(mesh.Cells, assembled.Cells); // turned over if they were negative
  EXPECT_EQ(mesh.Neighbors, assembled.Neighbors);
  EXPECT_EQ(mesh.Facets, assembled.Facets);
  EXPECT_EQ(mesh.FacetSides, assembled.FacetSides);
  EXPECT_TRUE(assembled.LostFacets.empty());
}
} // namespace

TEST(MendFlatCells, ReconnectsAndKeepsFacets)
{
  std::ptrdiff_t before = 0;
  std::ptrdiff_t after = 0;
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    TetrahedralMesh mesh = testtetrahedra::EvenGrid(5);
    testtetrahedra::Flatten(mesh, seed);
    const FacetComplex surface = testtetrahedra::RandomFaces(mesh, seed);
    Monitor monitor;
    TetrahedralMesh mended = mesh;
    MendFlatCells(mended, monitor);
    EXPECT_TRUE(testtetrahedra::AllPositive(mended));
    EXPECT_EQ(mended.Points, mesh.Points);
    EXPECT_EQ(FacesOfFacets(mended), FacesOfFacets(mesh));
    EXPECT_TRUE(mended.LostFacets.empty());
    ExpectConsistent(surface, mended);
    before += CountFlat(mesh);
    after += CountFlat(mended);
  }
  EXPECT_GT(before, 20);
  EXPECT_LT(after, 0.8 * static_cast<double>(before));
}

TEST(MendFlatCells, LeavesCellsFarFromFlatOnes)
{
  std::ptrdiff_t before = 0;
  std::ptrdiff_t after = 0;
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    TetrahedralMesh mesh = testtetrahedra::EvenGrid(9);
    ASSERT_EQ(testtetrahedra::Flatten(mesh, seed, 1), 1);
    const FacetComplex surface = testtetrahedra::RandomFaces(mesh, seed);
    TetrahedralMesh mended = mesh;
    Monitor monitor;
    MendFlatCells(mended, monitor);
    ExpectConsistent(surface, mended);
    before += CountFlat(mesh);
    after += CountFlat(mended);
    std::vector<Tetrahedron> common;
    std::sort(mended.Cells.begin(), mended.Cells.end());
    std::sort(mesh.Cells.begin(), mesh.Cells.end());
    std::set_intersection(mesh.Cells.begin(), mesh.Cells.end(), mended.Cells.begin(),
      mended.Cells.end(), std::back_inserter(common));
    EXPECT_GT(common.size(), mesh.Cells.size() - 50);
  }
  EXPECT_LT(after, before);
}

TEST(MendFlatCells, MovesSteinerPointsAlone)
{
  TetrahedralMesh cube = testtetrahedra::EvenGrid(1);
  const std::vector<int> inside(cube.Cells.size(), 1);
  const FacetComplex surface = testtetrahedra::BoundaryOfLabels(cube, inside, 1);
  RawTetrahedra raw;
  raw.Points = cube.Points;
  raw.Points.push_back({ { 40, 30, 1e-18 } });
  for (Id c = 0; c < cube.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (cube.Neighbors[c][k] == None)
      {
        const Triangle f = FaceOf(cube.Cells[c], k);
        raw.Cells.push_back({ { f[0], f[1], f[2], static_cast<Id>(cube.Points.size()) } });
        raw.Faces.push_back(f);
        raw.FacetOfFaces.push_back(cube.Facets[c][k]);
      }
    }
  }
  Monitor monitor;
  const TetrahedralMesh mesh = AssembleMesh(surface, raw, monitor);
  ASSERT_GT(CountFlat(mesh), 0);
  TetrahedralMesh mended = mesh;
  MendFlatCells(mended, monitor);
  EXPECT_EQ(CountFlat(mended), 0);
  EXPECT_EQ(mended.Cells.size(), mesh.Cells.size());
  EXPECT_GT(mended.Points.back()[2], 1);
  EXPECT_TRUE(std::equal(cube.Points.begin(), cube.Points.end(), mended.Points.begin()));
  EXPECT_EQ(FacesOfFacets(mended), FacesOfFacets(mesh));

  FacetComplex withPoint = surface; // the same point is one of the input now
  withPoint.Points.push_back(raw.Points.back());
  withPoint.Origins.push_back(PointOrigin::Input(static_cast<Id>(cube.Points.size())));
  TetrahedralMesh given = AssembleMesh(withPoint, raw, monitor);
  MendFlatCells(given, monitor);
  EXPECT_EQ(given.Points, raw.Points);
}

TEST(MendFlatCells, IsTheSameOnAnyNumberOfThreads)
{
  const WholeTeams teams;
  TetrahedralMesh mesh = testtetrahedra::EvenGrid(5);
  testtetrahedra::Flatten(mesh, 1);
  testtetrahedra::RandomFaces(mesh, 1);
  const auto mendedOn = [&mesh](int threads)
  {
    const testthreads::Allowed allowed(threads);
    TetrahedralMesh mended = mesh;
    Monitor monitor;
    MendFlatCells(mended, monitor);
    return mended;
  };
  const TetrahedralMesh alone = mendedOn(1);
  EXPECT_NE(alone.Cells, mesh.Cells);
  for (const int threads : { 2, 8 })
  {
    const TetrahedralMesh together = mendedOn(threads);
    EXPECT_EQ(together.Cells, alone.Cells);
    EXPECT_EQ(together.Neighbors, alone.Neighbors);
    EXPECT_EQ(together.Facets, alone.Facets);
    EXPECT_EQ(together.FacetSides, alone.FacetSides);
  }
}
