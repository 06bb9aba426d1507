// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/InsertPoint.h"

#include "Common/PointPredicates.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/CellShape.h"
#include "Refine/MakeRefinable.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace insideout;
using testtetrahedra::EvenGrid;

namespace
{
std::ptrdiff_t CountCells(const RefinableMesh& mesh)
{
  std::ptrdiff_t count = 0;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    count += mesh.IsDead(c) ? 0 : 1;
  }
  return count;
}

/** As long as six times the volume. All cells have to be positive. */
double VolumeOf(const RefinableMesh& mesh)
{
  double volume = 0;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (!mesh.IsDead(c))
    {
      const auto [a, b, d, e] = CornersOf(mesh.Points, mesh.Cell(c).Corners);
      EXPECT_GT(Orient3D(a, b, d, e), 0);
      volume += Determinant(Difference(b, a), Difference(d, a), Difference(e, a));
    }
  }
  return volume;
}
} // namespace

TEST(PointInsertion, TakesTheNearestCellsWhereSpheresHoldMany)
{
  const TetrahedralMesh grid = EvenGrid(4);
  const std::vector<FacetOfInput> facets = FacetsOf(grid, {}, {});
  for (const std::size_t most : { 1, 2, 3, 5, 1000 })
  {
    RefinableMesh mesh = MakeRefinable(grid, {}, facets);
    const double volume = VolumeOf(mesh);
    PointInsertion insertion(mesh);
    const Id cell = mesh.NumberOfCells() / 2;
    ASSERT_TRUE(insertion.Find(cell, Barycentre(mesh.Points, mesh.Cell(cell).Corners), most));
    EXPECT_EQ(insertion.Holder(), cell);
    const std::ptrdiff_t before = CountCells(mesh);
    insertion.Insert(1);
    const std::ptrdiff_t gone =
      before + static_cast<std::ptrdiff_t>(mesh.Fresh().size()) - CountCells(mesh);
    EXPECT_GE(gone, 1);
    EXPECT_LE(gone, static_cast<std::ptrdiff_t>(most));
    EXPECT_NEAR(VolumeOf(mesh), volume, 1e-9 * volume);
    EXPECT_TRUE(most != 1000 || gone > 5) << gone;
  }
}

TEST(PointInsertion, ReplacesACellThatDoesNotContainItsRoundedCenter)
{
  const double below = std::nextafter(1.0, 0.0);
  const std::vector<Point> points = { { { 0, 0, 1 } }, { { 1, 0, below } }, { { 1, 1, 1 } },
    { { 0, 1, below } }, { { 0.5, 0.5, 0 } } };
  const TetrahedralMesh solid =
    ConnectCells(points, { { { 0, 1, 3, 2 } }, { { 0, 3, 1, 4 } }, { { 1, 3, 2, 4 } } });
  const std::vector<FacetOfInput> facets = FacetsOf(solid, {}, {});
  RefinableMesh mesh = MakeRefinable(solid, {}, facets);
  const double volume = VolumeOf(mesh);
  PointInsertion insertion(mesh);
  EXPECT_FALSE(insertion.Find(0, Barycentre(mesh.Points, mesh.Cell(0).Corners), 9));
  int inner = 0;
  for (int k = 0; k < 4; ++k)
  {
    const bool isInner = mesh.Cell(0).Facets[k] == None;
    EXPECT_EQ(insertion.FindBeside(0, k, 9), isInner);
    inner = isInner ? k : inner;
  }
  ASSERT_TRUE(insertion.FindBeside(0, inner, 9));
  EXPECT_GT(insertion.OptimizePlace(), ShapeOfAngle(20));
  insertion.Insert(1);
  EXPECT_EQ(mesh.Fresh().size(), 6); // one at each facet
  EXPECT_NEAR(VolumeOf(mesh), volume, 1e-9 * volume);
}
