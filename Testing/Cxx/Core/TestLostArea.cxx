// SPDX-License-Identifier: GPL-3.0-or-later
#include "LostArea.h"

#include "GraphCut/SegmentMesh.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

namespace
{
using namespace insideout;
using namespace testmeshes;

LostArea Lost(const TriangleSoup& soup, Orientation orientation = Orientation::Automatic)
{
  Monitor monitor;
  HullMeshParameters parameters;
  parameters.Orientation = orientation;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  const HullMesh hull = MeshHull(soup, parameters, monitor);
  const MeshSegmentation cut = SegmentMesh(hull.Mesh, hull.W, {}, {}, {}, monitor);
  return MeasureLostArea(
    hull, OutlierPieces(hull.Surface, hull.Mesh, cut.Inside, monitor, { "extracting", 0, 1 }));
}

/** An open square of this size, away from the unit cube. */
TriangleSoup Square(double size)
{
  TriangleSoup square;
  square.Points = { { 3, 0, 0 }, { 3 + size, 0, 0 }, { 3 + size, size, 0 }, { 3, size, 0 } };
  square.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return square;
}

const TriangleSoup UnitCube = Box({ 0, 0, 0 }, { 1, 1, 1 });

TEST(LostArea, IsNoneOfASolid)
{
  const LostArea lost = Lost(UnitCube);
  EXPECT_EQ(lost.Share, 0);
  EXPECT_TRUE(WarningsAbout(lost).empty());
}

TEST(LostArea, IsWhatASheetHas)
{
  const LostArea lost = Lost(Join(UnitCube, Square(2)));
  EXPECT_NEAR(lost.Share, 0.4, 1e-12);
  EXPECT_NEAR(lost.Sheets, 0.4, 1e-12);
  ASSERT_EQ(WarningsAbout(lost).size(), 1u);
  EXPECT_EQ(WarningsAbout(lost)[0],
    "40 % of the surface's area is not part of the solid; 40 % are sheets, which enclose nothing: "
    "Thicken gives them a width, ConstrainFacets keeps them");
}

TEST(LostArea, IsNotWarnedOfWhenItIsATenthOrLess)
{
  const LostArea lost = Lost(Join(UnitCube, Square(0.8)));
  EXPECT_NEAR(lost.Share, 0.64 / 6.64, 1e-12);
  EXPECT_TRUE(WarningsAbout(lost).empty());
}

TEST(LostArea, IsWhatFacesInwardAsGiven)
{
  const TriangleSoup two = Join(UnitCube, Reversed(Box({ 2, 0, 0 }, { 3, 1, 1 })));
  EXPECT_EQ(Lost(two).Share, 0);
  const LostArea lost = Lost(two, Orientation::AsGiven);
  EXPECT_NEAR(lost.Others, 0.5, 1e-12);
  ASSERT_EQ(WarningsAbout(lost).size(), 1u);
  EXPECT_NE(WarningsAbout(lost)[0].find("50 % of the surface's area"), std::string::npos);
}

TEST(LostArea, NamesAShellThatIsLostAsAWhole)
{
  // A house without a floor, as given within another one that faces inward and cancels its w,
  // beside a block that is far larger.
  TriangleSoup house = Box({ 0, 0, 0 }, { 2, 2, 1 });
  house.Triangles.erase(house.Triangles.begin(), house.Triangles.begin() + 2);
  TriangleSoup other = Box({ -0.2, -0.2, 0 }, { 2.2, 2.2, 1.2 });
  other.Triangles.erase(other.Triangles.begin(), other.Triangles.begin() + 2);
  const TriangleSoup block = Box({ 20, 0, 0 }, { 60, 40, 40 });
  const LostArea lost = Lost(Join(Join(house, Reversed(other)), block), Orientation::AsGiven);
  EXPECT_LT(lost.Share, 0.1);
  ASSERT_EQ(lost.Shells.size(), 1u);
  EXPECT_EQ(lost.Shells[0].Number, 0);
  EXPECT_NEAR(lost.Shells[0].Volume, 4, 1e-9);
  ASSERT_EQ(WarningsAbout(lost).size(), 1u);
  EXPECT_EQ(WarningsAbout(lost)[0].find("shell 0 (volume 4) has holes and is not part"), 0u)
    << WarningsAbout(lost)[0];
  EXPECT_TRUE(Lost(Join(house, block)).Shells.empty());
}
} // namespace
