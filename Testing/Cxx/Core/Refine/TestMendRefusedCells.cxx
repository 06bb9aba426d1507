// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/RawTetrahedra.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Quality/SolverFitness.h"
#include "Refine/MakeRefinable.h"
#include "Refine/MendRefusedCells.h"
#include "Refine/RefineTetrahedra.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"
#include "Tetrahedralize/DelaunayOfPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace insideout;
using testmeshes::ExpectRefinementLaws;
using testmeshes::ExpectRemeshingLaws;
using testtetrahedra::Cubes;
using testtetrahedra::EvenGrid;
using testtetrahedra::Part;

namespace
{
constexpr double Size = 200;
constexpr double Low = 1e-25; ///< a cell 100 wide and as low as this is refused
constexpr Point Apex = { { 50, -Low, Low } };

/** A block whose top is at z = 0. */
TetrahedralMesh Block()
{
  TetrahedralMesh block = EvenGrid(2);
  for (Point& p : block.Points)
  {
    p[2] -= Size;
  }
  return block;
}

Id At(const TetrahedralMesh& mesh, const Point& place)
{
  return static_cast<Id>(
    std::find(mesh.Points.begin(), mesh.Points.end(), place) - mesh.Points.begin());
}

/** The block, and a flat cell beside it. */
TetrahedralMesh BlockAndFlatCell(double height = Low)
{
  TetrahedralMesh block = Block();
  const auto first = static_cast<Id>(block.Points.size());
  block.Points.insert(block.Points.end(),
    { { { 300, 0, 0 } }, { { 400, 0, 0 } }, { { 300, 100, 0 } }, { { 320, 20, height } } });
  block.Cells.push_back({ { first, first + 1, first + 2, first + 3 } });
  return ConnectCells(block.Points, block.Cells);
}

/** The block with a flat cell on a triangle at its rim. The apex is beyond the rim, so that no
 * other cells fill the space, and perhaps a corner of a cell above. */
TetrahedralMesh BlockWithSpike(bool isPinched)
{
  TetrahedralMesh block = Block();
  const auto apex = static_cast<Id>(block.Points.size());
  block.Points.push_back(Apex);
  block.Cells.push_back({ { apex, At(block, { { 0, 0, 0 } }), At(block, { { 100, 0, 0 } }),
    At(block, { { 100, 100, 0 } }) } });
  if (isPinched)
  {
    block.Points.insert(
      block.Points.end(), { { { 40, 30, 50 } }, { { 80, 20, 50 } }, { { 60, 60, 50 } } });
    block.Cells.push_back({ { apex, apex + 1, apex + 2, apex + 3 } });
  }
  return ConnectCells(block.Points, block.Cells);
}

/** A cube in which a triangle replaces a corner. */
TetrahedralMesh CubeWithTinyTriangle(double edge, double cut)
{
  std::vector<Point> points = { { { cut, 0, 0 } }, { { 0, cut, 0 } }, { { 0, 0, cut } } };
  for (int k = 1; k < 8; ++k)
  {
    points.push_back({ { k & 1 ? edge : 0, k & 2 ? edge : 0, k & 4 ? edge : 0 } });
  }
  Monitor monitor;
  return ConnectCells(points, DelaunayOfPoints(points, 100, monitor).Cells);
}

/** A layer of stacked flat cells near z = 0, all between the points of a grid. */
TetrahedralMesh FlatLayer()
{
  const double low = std::ldexp(1, -76);
  std::vector<Point> points;
  for (int x = 0; x < 7; ++x)
  {
    for (int y = 0; y < 7; ++y)
    {
      points.push_back({ { 10.0 * x, 10.0 * y + x, low * (x * x + y * y + 1) } });
    }
  }
  Monitor monitor;
  return ConnectCells(points, DelaunayOfPoints(points, 100, monitor).Cells);
}

RefinedMesh Refined(const TetrahedralMesh& mesh, bool mends)
{
  RefinementParameters parameters;
  parameters.MendsSurface = [mends](const RefinedMesh&) { return mends; };
  Monitor monitor;
  return RefineTetrahedra(mesh, {}, parameters, monitor);
}

/** MendRefusedCells alone. */
struct MendingOf
{
  explicit MendingOf(const TetrahedralMesh& input)
    : Facets(FacetsOf(input, {}, {}))
    , Mesh(MakeRefinable(input, {}, this->Facets))
  {
    SurfaceBound bound(this->Mesh, this->Facets, SurfaceTreatment::Remeshed, 1e-6);
    const std::vector<char> locked;
    RefinableSurface surface(this->Mesh, this->Facets, locked, SurfaceTreatment::Remeshed, 30);
    Monitor monitor;
    this->Changes =
      MendRefusedCells(this->Mesh, surface, bound, 1e-6, true, monitor, { Stages::Refining, 0, 1 });
  }

  template <class Predicate>
  Id Count(const Predicate& isCounted) const
  {
    Id count = 0;
    for (Id cell = 0; cell < this->Mesh.NumberOfCells(); ++cell)
    {
      count += !this->Mesh.IsDead(cell) && isCounted(this->Mesh.Cell(cell).Corners) ? 1 : 0;
    }
    return count;
  }

  Id CountCells() const
  {
    return this->Count([](const Tetrahedron&) { return true; });
  }

  Id CountRefusedCells() const
  {
    return this->Count([this](const Tetrahedron& corners)
      { return IsRefused(CornersOf(this->Mesh.Points, corners)); });
  }

  std::vector<FacetOfInput> Facets;
  RefinableMesh Mesh;
  Id Changes;
};

std::ptrdiff_t CountRefused(const RefinedMesh& mesh)
{
  return std::count_if(mesh.Cells.begin(), mesh.Cells.end(),
    [&mesh](const Tetrahedron& cell) { return IsRefused(CornersOf(mesh.Points, cell)); });
}
} // namespace

TEST(MendRefusedCells, CornersOfAFlatPartMoveAsLittleAsSuffices)
{
  const TetrahedralMesh block = BlockAndFlatCell();
  EXPECT_EQ(CountRefused(Refined(block, false)), 1);
  const RefinedMesh mended = Refined(block, true);
  EXPECT_EQ(CountRefused(mended), 0);
  ExpectRemeshingLaws(block, {}, mended, 1e-6);
}

TEST(MendRefusedCells, CellsGetThickerThatASolverAcceptsButWithoutDigits)
{
  const TetrahedralMesh block = BlockAndFlatCell(1e-12);
  const RefinedMesh kept = Refined(block, false);
  EXPECT_EQ(CountRefused(kept), 0);
  Monitor monitor;
  const auto flat = [&monitor](const RefinedMesh& mesh)
  {
    return FitnessForSolver(
      mesh.Points, mesh.Cells, {}, {}, {}, monitor, { Stages::Refining, 0, 1 })
      .NearlyFlatCells;
  };
  EXPECT_EQ(flat(kept), 1);
  const RefinedMesh mended = Refined(block, true);
  EXPECT_EQ(flat(mended), 0);
  ExpectRemeshingLaws(block, {}, mended, 1e-6);
}

TEST(MendRefusedCells, AFlatSpikeGoesThoughItsApexMayBeACornerOfOtherCells)
{
  for (const bool isPinched : { false, true })
  {
    const TetrahedralMesh block = BlockWithSpike(isPinched);
    MendingOf mending(block);
    EXPECT_EQ(mending.Changes, 1);
    const Id apex = At(block, Apex);
    EXPECT_EQ(mending.Mesh.Points[apex], Apex);
    EXPECT_EQ(mending.Mesh.CellAt(apex) != None, isPinched);
    EXPECT_EQ(mending.CountCells(), block.NumberOfCells() - 1);
    EXPECT_EQ(mending.CountRefusedCells(), 0);
  }
}

TEST(MendRefusedCells, ALowStepIsContracted)
{
  TetrahedralMesh block = EvenGrid(2);
  block = Part(block, Cubes(block, [](int x, int, int z) { return x == 0 || z == 0; }));
  for (Point& p : block.Points)
  {
    p[2] = p[2] == Size ? Low : p[2] - 100;
  }
  MendingOf mending(block);
  EXPECT_GT(mending.Changes, 0);
  EXPECT_EQ(mending.CountRefusedCells(), 0);
  Id count = 0;
  for (Id p = 0; p < static_cast<Id>(block.Points.size()); ++p)
  {
    count += mending.Mesh.CellAt(p) != None && std::abs(mending.Mesh.Points[p][2]) < 1e-6 ? 1 : 0;
  }
  EXPECT_LT(count, 15) << "as many as before";
}

TEST(MendRefusedCells, StackedFlatCellsNearZeroAreStretchedTogether)
{
  const TetrahedralMesh layer = FlatLayer();
  MendingOf mending(layer);
  EXPECT_GT(mending.CountCells(), 100);
  EXPECT_EQ(mending.CountRefusedCells(), 0);
  EXPECT_GT(mending.Changes, 0);
  for (const Point& place : mending.Mesh.Points)
  {
    EXPECT_LE(std::abs(place[2]), 1e-6);
  }
}

TEST(MendRefusedCells, APieceLowerThanTheToleranceMayTurnWhereAreasHaveABudget)
{
  const double cut = 1e-7;
  const TetrahedralMesh cube = CubeWithTinyTriangle(1, cut);
  const std::vector<FacetOfInput> facets = FacetsOf(cube, {}, {});
  const RefinableMesh mesh = MakeRefinable(cube, {}, facets);
  std::vector<SurfacePiece> gone;
  std::vector<SurfacePiece> moved;
  for (const SurfacePiece& piece : PiecesOf(mesh))
  {
    const auto at =
      std::find(piece.Corners.begin(), piece.Corners.end(), 0) - piece.Corners.begin();
    if (at < 3)
    {
      gone.push_back(piece);
      moved.push_back(piece);
      moved.back().Places[at] = { { -cut, 0, 0 } };
    }
  }
  for (const bool hasBudget : { false, true })
  {
    SurfaceBudget budget(mesh, facets);
    SurfaceBound bound(
      mesh, facets, SurfaceTreatment::Remeshed, 10 * cut, hasBudget ? &budget : nullptr);
    EXPECT_EQ(bound.AllowsMove(gone, moved), hasBudget);
    EXPECT_FALSE(bound.AllowsEach(gone, gone, moved));
  }
}

TEST(MendRefusedCells, InnerCellsAtATinyTriangleAreLargeEnough)
{
  const TetrahedralMesh cube = CubeWithTinyTriangle(1e-2, 1e-7);
  const RefinedMesh refined = Refined(cube, false);
  EXPECT_EQ(CountRefused(refined), 0);
  ExpectRefinementLaws(cube, {}, refined);
}

TEST(MendRefusedCells, NothingIsMendedWhereTheSolidIsTooSmallForAnySolver)
{
  const double scale = std::ldexp(1, -20);
  const TetrahedralMesh cube = CubeWithTinyTriangle(1, 1e-2);
  TetrahedralMesh small = cube;
  for (Point& p : small.Points)
  {
    p = { { scale * p[0], scale * p[1], scale * p[2] } };
  }
  const RefinedMesh refined = Refined(small, false);
  EXPECT_GT(CountRefused(refined), 0);
  EXPECT_EQ(refined.Cells, Refined(cube, false).Cells);
}
