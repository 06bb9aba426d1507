// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SurfaceOfExpression.h"

#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Support/ExpectSound.h"
#include "Support/TestMeshes.h"

namespace
{
using namespace insideout;
using namespace testmeshes;

/** Faces that two boxes share count twice, so that all closes. */
HullMeshParameters CountDuplicates()
{
  HullMeshParameters parameters;
  parameters.Chain.CountDuplicates = true;
  return parameters;
}

/** The union of one body. */
std::optional<ExpressionSurface> Repair(const ResolvedBodies& body)
{
  Monitor monitor;
  return SurfaceOfExpression(body, { SetOperation::Union, 1 }, monitor);
}

/** What the tetrahedra give, with the cut's defaults. */
std::vector<BoundaryTriangle> BoundaryOfCells(const TriangleSoup& soup, HullMesh& hull)
{
  Monitor monitor;
  hull = MeshHull(soup, CountDuplicates(), monitor);
  const MeshSegmentation segmentation = SegmentMesh(hull.Mesh, hull.W, {}, {}, {}, monitor);
  return BoundaryTriangles(hull.Surface, hull.Mesh,
    BoundaryFaces(hull.Mesh, segmentation.Inside, monitor, { "", 0, 1 }), monitor, { "", 0, 1 });
}

/** Boxes that cross, touch, contain each other and coincide, some of them inside out or turned. */
TriangleSoup DirtyBoxes(unsigned seed)
{
  std::mt19937 random(seed);
  const auto coordinate = [&]() { return static_cast<double>(random() % 4); };
  TriangleSoup boxes;
  for (int i = 0; i < 5; ++i)
  {
    const Point low = { coordinate(), coordinate(), coordinate() };
    TriangleSoup box =
      Box(low, { low[0] + 1 + coordinate(), low[1] + 1 + coordinate(), low[2] + 1 + coordinate() });
    for (Point& p : box.Points)
    {
      const double shear = seed % 2 == 0 ? 0 : 0.1 * i; // so that planes are slanted
      p = { { p[0] + shear * p[1], p[1] - shear * p[2], p[2] } };
    }
    boxes = Join(boxes, random() % 3 == 0 ? Reversed(box) : box);
  }
  return boxes;
}

TEST(Repair, BoundsTheSolidOfTheTetrahedra)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    const TriangleSoup soup = DirtyBoxes(seed);
    Monitor monitor;
    const HullMesh resolved = ResolveHull(OneBody(soup), CountDuplicates(), monitor);
    const auto repaired = Repair(resolved);
    ASSERT_TRUE(repaired) << seed;
    ExpectSound(SoupOf(resolved.Surface.Points, repaired->Boundary));
    HullMesh hull;
    const std::vector<BoundaryTriangle> boundary = BoundaryOfCells(soup, hull);
    const double volume = VolumeWithin(hull.Mesh.Points, boundary);
    EXPECT_GT(volume, 0) << seed;
    EXPECT_NEAR(VolumeWithin(resolved.Surface.Points, repaired->Boundary), volume, 1e-9 * volume)
      << seed;
    const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
    EXPECT_EQ(repaired->MinimumW, std::min(0.0, *least)) << seed;
    EXPECT_EQ(repaired->MaximumW, *most) << seed;
  }
}

TEST(Repair, HasTheOutliersOfTheTetrahedra)
{
  // A sheet far from a box, drawn from both sides, is not part of the solid; one within is.
  const TriangleSoup sheets = { { { 1, 1, 1 }, { 2, 1, 1 }, { 1, 2, 2 }, { 9, 9, 9 }, { 8, 9, 9 },
                                  { 9, 8, 8 } },
    { { 0, 1, 2 }, { 0, 2, 1 }, { 3, 4, 5 }, { 3, 5, 4 } } };
  const TriangleSoup soup = Join(Box({ 0, 0, 0 }, { 4, 4, 4 }), sheets);
  Monitor monitor;
  const HullMesh resolved = ResolveHull(OneBody(soup), {}, monitor);
  const auto repaired = Repair(resolved);
  ASSERT_TRUE(repaired);
  EXPECT_EQ(repaired->Boundary.size(), 12u);
  ASSERT_EQ(repaired->Outliers.size(), 1u);
  EXPECT_EQ(SourceOfFacet(resolved.Surface, repaired->Outliers[0].Facet, +1), 14);
}

TEST(Repair, IsTheInputWhereThatIsSound)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 4, 4, 4 });
  Monitor monitor;
  const HullMesh resolved = ResolveHull(OneBody(box), {}, monitor);
  const auto repaired = Repair(resolved);
  ASSERT_TRUE(repaired);
  ASSERT_EQ(repaired->Boundary.size(), 12u);
  for (std::size_t t = 0; t < 12; ++t)
  {
    EXPECT_EQ(repaired->Boundary[t].Corners, box.Triangles[t]);
    EXPECT_EQ(repaired->Boundary[t].Source, static_cast<Id>(t));
  }
}

TEST(Repair, IsNotMadeOfOpenOnesAndWhereFacetsWereLeftOut)
{
  TriangleSoup open = Box({ 0, 0, 0 }, { 1, 1, 1 });
  open.Triangles.pop_back();
  Monitor monitor;
  EXPECT_FALSE(Repair(ResolveHull(OneBody(open), {}, monitor)));
  HullMesh leftOut = ResolveHull(OneBody(Box({ 0, 0, 0 }, { 1, 1, 1 })), {}, monitor);
  EXPECT_TRUE(Repair(leftOut));
  --leftOut.Surface.NumberOfConstraints;
  EXPECT_FALSE(Repair(leftOut));
}
} // namespace
