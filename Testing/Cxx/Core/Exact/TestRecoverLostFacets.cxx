// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverLostFacets.h"

#include "Exact/RecoverFacets.h"
#include "Support/FlippableMeshLaws.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace insideout;

TEST(RecoverLostFacets, RecoversFacetsThatNobodyTriedBefore)
{
  for (const TriangleSoup& soup :
    { testmeshes::TwistedPrism(3, -M_PI / 6), testmeshes::Chazelle(2) })
  {
    WorkBudget work;
    Monitor monitor;
    ExactState mesh(soup.Points, soup.Triangles, work, monitor);
    ASSERT_FALSE(FindLostFacets(mesh).empty());
    const testflips::MeshRecord before(mesh.Mesh);
    RecoverLostFacets(mesh, soup.Points, SplitFrom::Middle);
    EXPECT_TRUE(FindLostFacets(mesh).empty());
    testflips::ExpectFlippableMeshLaws(mesh.Mesh);
    EXPECT_EQ(
      testflips::SixfoldVolume(testflips::MeshRecord(mesh.Mesh)), testflips::SixfoldVolume(before));
    EXPECT_EQ(testflips::ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets),
      std::vector<std::string>());
  }
}

TEST(RecoverLostFacets, LeavesTheMeshLawfulWhereFacetsCross)
{
  const TriangleSoup soup = testmeshes::RandomSoup(3, 12);
  WorkBudget work(100000000);
  Monitor monitor;
  ExactState mesh(soup.Points, soup.Triangles, work, monitor);
  const std::size_t before = FindLostFacets(mesh).size();
  RecoverLostFacets(mesh, soup.Points, SplitFrom::Middle);
  EXPECT_LE(FindLostFacets(mesh).size(), before);
  EXPECT_GT(FindLostFacets(mesh).size(), 0u);
  testflips::ExpectFlippableMeshLaws(mesh.Mesh);
}
