// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverLostFacets.h"

#include "Support/FlippableMeshLaws.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace insideout;

TEST(LostFacetRecovery, RecoversFacetsThatNobodyTriedBefore)
{
  for (const TriangleSoup& soup :
    { testmeshes::TwistedPrism(3, -M_PI / 6), testmeshes::Chazelle(2) })
  {
    WorkBudget work;
    Monitor monitor;
    std::mt19937 random;
    ConstrainedMesh mesh(soup.Points, soup.Triangles, work, monitor);
    ASSERT_FALSE(mesh.FindLost(monitor).empty());
    const testflips::MeshRecord before(mesh.Mesh);
    LostFacetRecovery(mesh, random, monitor).Recover(soup.Points, SegmentRecovery::From::LowerEnd);
    EXPECT_TRUE(mesh.FindLost(monitor).empty());
    testflips::ExpectFlippableMeshLaws(mesh.Mesh);
    EXPECT_EQ(
      testflips::SixfoldVolume(testflips::MeshRecord(mesh.Mesh)), testflips::SixfoldVolume(before));
    EXPECT_EQ(testflips::ConstraintViolations(mesh.Mesh, mesh.Segments, mesh.Facets),
      std::vector<std::string>());
  }
}

TEST(LostFacetRecovery, LeavesTheMeshLawfulWhereFacetsCross)
{
  const TriangleSoup soup = testmeshes::RandomSoup(3, 12);
  WorkBudget work(100000000);
  Monitor monitor;
  std::mt19937 random;
  ConstrainedMesh mesh(soup.Points, soup.Triangles, work, monitor);
  const std::size_t before = mesh.FindLost(monitor).size();
  LostFacetRecovery(mesh, random, monitor).Recover(soup.Points, SegmentRecovery::From::LowerEnd);
  EXPECT_LE(mesh.FindLost(monitor).size(), before);
  EXPECT_GT(mesh.FindLost(monitor).size(), 0u);
  testflips::ExpectFlippableMeshLaws(mesh.Mesh);
}
