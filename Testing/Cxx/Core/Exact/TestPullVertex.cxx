// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/PullVertex.h"

#include "Exact/ExactTetrahedralization.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/FlippableMeshes.h"
#include "Support/MeshLaws.h"
#include "Support/TestMeshes.h"
#include "Tetrahedralize/AssembleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace testflips;

namespace
{
/** Both caps are fans from a corner. Turned, its faces are flat and its corners on a sphere up to
 * rounding only. */
TriangleSoup Prism(int sides, double turn)
{
  TriangleSoup soup;
  for (const double z : { 0., 10. })
  {
    for (int i = 0; i < sides; ++i)
    {
      const double x = 50 * std::cos(2 * M_PI * i / sides);
      const double y = 50 * std::sin(2 * M_PI * i / sides);
      const double aside = std::cos(turn) * y - std::sin(turn) * z;
      const double up = std::sin(turn) * y + std::cos(turn) * z;
      soup.Points.push_back({ { std::cos(turn) * x - std::sin(turn) * aside,
        std::sin(turn) * x + std::cos(turn) * aside, up } });
    }
  }
  for (int i = 0; i < sides; ++i)
  {
    const int j = (i + 1) % sides;
    soup.Triangles.push_back({ { i, j, sides + j } });
    soup.Triangles.push_back({ { i, sides + j, sides + i } });
    if (i > 0 && j > 0)
    {
      soup.Triangles.push_back({ { 0, j, i } });
      soup.Triangles.push_back({ { sides, sides + i, sides + j } });
    }
  }
  return soup;
}

TetrahedralMesh MeshWithEveryFacet(const TriangleSoup& soup)
{
  Monitor monitor;
  const FacetComplex surface = testmeshes::ToComplex(soup);
  const ExactTetrahedralization exact = TetrahedralizeExactly(surface.Points,
    { surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints }, monitor);
  TetrahedralMesh mesh = AssembleMesh(surface, exact.Tetrahedra, monitor);
  testmeshes::ExpectMeshLaws(surface, mesh);
  EXPECT_TRUE(mesh.LostFacets.empty());
  return mesh;
}
} // namespace

TEST(PullVertex, ConnectsAndKeepsTheMeshLawfulWithItsConstraints)
{
  int pulled = 0;
  for (unsigned seed = 0; seed < 120; ++seed)
  {
    MeshWithFacets mesh = RandomMeshWithFacets(seed, 30, 8);
    std::mt19937 random(seed);
    for (int k = 0; k < 20; ++k)
    {
      const Id apex = static_cast<Id>(random() % 30);
      const Id other = static_cast<Id>(random() % 30);
      if (apex == other || mesh.Mesh.FindEdge(apex, other) != None)
      {
        continue;
      }
      const MeshRecord before(mesh.Mesh);
      if (!PullVertex(mesh, apex, other))
      {
        ExpectUnchanged(mesh.Mesh, before);
        continue;
      }
      ++pulled;
      EXPECT_NE(mesh.Mesh.FindEdge(apex, other), None);
      ExpectFlippableMeshLaws(mesh.Mesh);
      EXPECT_EQ(FacesOfFacets(before), FacesOfFacets(MeshRecord(mesh.Mesh)));
      for (const Triangle& facet : mesh.Facets)
      {
        for (int edge = 0; edge < 3; ++edge)
        {
          EXPECT_NE(mesh.Mesh.FindEdge(facet[edge], facet[(edge + 1) % 3]), None);
        }
      }
    }
  }
  EXPECT_GT(pulled, 100);
}

TEST(PullVertex, ConnectsACornerOfAPolygonWithAllOthers)
{
  const int sides = 12;
  const TriangleSoup soup = Prism(sides, 0);
  MeshWithFacets state(DelaunayMesh(soup.Points), {});
  const FlippableMesh& mesh = state.Mesh;
  int pulled = 0;
  for (Id vertex = 1; vertex < sides; ++vertex)
  {
    if (mesh.FindEdge(0, vertex) == None)
    {
      EXPECT_TRUE(PullVertex(state, 0, vertex));
      ++pulled;
    }
  }
  EXPECT_GT(pulled, 0);
  ExpectFlippableMeshLaws(mesh);
  for (Id vertex = 1; vertex < sides; ++vertex)
  {
    EXPECT_NE(mesh.FindEdge(0, vertex), None);
  }
}

TEST(PullVertex, LetsPrismsHaveFewCells)
{
  for (const int sides : { 8, 64, 250 })
  {
    EXPECT_LE(MeshWithEveryFacet(Prism(sides, 0)).NumberOfCells(), 4 * sides);
  }
}

/** A cap that is flat up to rounding has slivers between its facets and the hull: as many as n - 2
 * more per cap. */
TEST(PullVertex, LetsPrismsHaveFewCellsThatAreFlatUpToRounding)
{
  for (const int sides : { 8, 64, 250 })
  {
    EXPECT_LE(MeshWithEveryFacet(Prism(sides, 0.7)).NumberOfCells(), 8 * sides);
  }
}
