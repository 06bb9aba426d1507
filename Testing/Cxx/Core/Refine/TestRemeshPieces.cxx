// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RemeshPieces.h"

#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/FillBetweenPieces.h"
#include "Refine/MakeRefinable.h"
#include "Refine/RefineTetrahedra.h"
#include "Refine/SurfaceMesh.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

using namespace insideout;
using testtetrahedra::EvenGrid;

namespace
{
constexpr ProgressRange Anywhere = { "", 0, 1 };

/** A cylinder of radius 100 and height 300 from x = 0 on, with sides and caps of needles. */
TetrahedralMesh CylinderOfNeedles(int sides)
{
  std::vector<Point> points = { { { 0, 0, 0 } }, { { 300, 0, 0 } } };
  for (int i = 0; i < 2 * sides; ++i)
  {
    const double turn = 2 * std::acos(-1.0) * (i % sides) / sides;
    points.push_back({ { i < sides ? 0.0 : 300.0, 100 * std::cos(turn), 100 * std::sin(turn) } });
  }
  std::vector<Tetrahedron> cells;
  for (Id i = 0; i < sides; ++i)
  {
    const Id a = 2 + i;
    const Id b = 2 + (i + 1) % sides;
    cells.push_back({ { 0, a, b, 1 } });
    cells.push_back({ { 1, a, b, a + sides } });
    cells.push_back({ { 1, b, b + sides, a + sides } });
  }
  for (Tetrahedron& cell : cells)
  {
    if (Orient3D(points, cell) < 0)
    {
      std::swap(cell[0], cell[1]);
    }
  }
  return ConnectCells(points, cells);
}

/** Pieces by their sorted corners, and their facets. */
std::map<Triangle, Id> Named(const std::vector<SurfacePiece>& pieces)
{
  std::map<Triangle, Id> named;
  for (const SurfacePiece& piece : pieces)
  {
    named.emplace(SortedTriangle(piece.Corners).Points, piece.Facet);
  }
  return named;
}

std::map<Id, double> VolumesOfRegions(const RefinableMesh& mesh)
{
  std::map<Id, double> volumes;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    if (!mesh.IsDead(c))
    {
      const auto p = CornersOf(mesh.Points, mesh.Cell(c).Corners);
      EXPECT_GT(Orient3D(mesh.Points, mesh.Cell(c).Corners), 0);
      volumes[mesh.Cell(c).Region] +=
        Determinant(Difference(p[1], p[0]), Difference(p[2], p[0]), Difference(p[3], p[0])) / 6;
    }
  }
  return volumes;
}

/** A cube with a fold of its top, from one of its edges to its center. */
RefinableMesh CubeWithFold(double slope, std::vector<FacetOfInput>& facets)
{
  TetrahedralMesh cube = EvenGrid(6);
  for (Point& p : cube.Points)
  {
    const double across = std::max(0.0, 100 - std::abs(p[1] - 300));
    p[2] += p[2] == 600 && p[0] < 300 ? slope * across : 0;
  }
  cube = ConnectCells(cube.Points, cube.Cells);
  facets = FacetsOf(cube, {}, {});
  return MakeRefinable(cube, {}, facets);
}

/** The number of edges along the fold that are ridges. */
int RidgesAlongFold(double slope)
{
  std::vector<FacetOfInput> facets;
  RefinableMesh mesh = CubeWithFold(slope, facets);
  const RefinableSurface surface(mesh, facets, {}, SurfaceTreatment::Remeshed, 30);
  int count = 0;
  for (const Edge& ends : SurfaceMesh(PiecesOf(mesh)).Edges())
  {
    const bool isAlong = std::all_of(ends.begin(), ends.end(),
      [&](Id p) { return mesh.Points[p][1] == 300 && mesh.Points[p][2] > 600; });
    count += isAlong && surface.IsRidge(ends[0], ends[1]) ? 1 : 0;
  }
  return count;
}
} // namespace

TEST(RemeshedSurface, OfNeedlesHasRegularTriangles)
{
  // The cells are those that come of its surface: flat ones between needles.
  const TetrahedralMesh wedges = CylinderOfNeedles(240);
  const std::vector<FacetOfInput> sides = FacetsOf(wedges, {}, {});
  RefinableMesh filled = MakeRefinable(wedges, {}, sides);
  const SizingParameters lengths;
  SizingField sizes(filled, lengths);
  Monitor monitor;
  ASSERT_TRUE(FillBetweenPieces(filled, PiecesOf(filled), sides, {}, sizes, monitor, Anywhere));
  std::vector<Tetrahedron> cells;
  for (Id c = 0; c < filled.NumberOfCells(); ++c)
  {
    cells.push_back(filled.Cell(c).Corners);
  }
  const TetrahedralMesh cylinder = ConnectCells(filled.Points, cells);
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.SurfaceTolerance = 3;
  parameters.Sizes.EdgeLength = 40;
  const RefinedMesh refined = RefineTetrahedra(cylinder, {}, parameters, monitor);
  testmeshes::ExpectRemeshingLaws(cylinder, {}, refined, 3);
  const TetrahedralMesh after = ConnectCells(refined.Points, refined.Cells);
  const RefinableMesh mesh = MakeRefinable(after, {}, FacetsOf(after, {}, {}));
  const std::vector<SurfacePiece> pieces = PiecesOf(mesh);
  const auto low = std::count_if(pieces.begin(), pieces.end(),
    [](const SurfacePiece& piece) { return LowestOf({ piece }) < 0.25; });
  EXPECT_LT(static_cast<double>(low), 0.02 * static_cast<double>(pieces.size()));
  EXPECT_LT(pieces.size(), 420U); // equilateral ones of this length are 363
  const double least = std::sin(20 * std::acos(-1.0) / 180);
  const std::vector<double> sines = testmeshes::LeastSines(refined.Points, refined.Cells);
  const auto flat =
    std::count_if(sines.begin(), sines.end(), [&](double sine) { return sine < least; });
  EXPECT_LT(static_cast<double>(flat), 0.02 * static_cast<double>(sines.size()));
}

TEST(RidgesOfASurface, EndWhereSharpEdgesDo)
{
  EXPECT_EQ(RidgesAlongFold(std::tan(0.17)), 0); // 20 degrees between normals
  EXPECT_EQ(RidgesAlongFold(std::tan(0.35)), 0); // 40 degrees, but its end is free
  EXPECT_EQ(RidgesAlongFold(std::tan(0.70)), 2); // 80 degrees
}

class CellsBetweenPieces : public testing::TestWithParam<unsigned>
{
};

TEST_P(CellsBetweenPieces, HaveTheRegionsAndFacetsOfThoseBefore)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 3);
  const std::vector<int> labels = testtetrahedra::RandomLabels(grid, GetParam());
  std::vector<Id> regions;
  for (const int label : labels)
  {
    regions.push_back(label + 3);
  }
  const std::vector<FacetOfInput> facets = FacetsOf(grid, regions, {});
  RefinableMesh mesh = MakeRefinable(grid, regions, facets);
  const std::map<Id, double> volumes = VolumesOfRegions(mesh);
  const std::vector<SurfacePiece> pieces = PiecesOf(mesh);
  const SizingParameters lengths;
  SizingField sizes(mesh, lengths);
  Monitor monitor;
  ASSERT_TRUE(FillBetweenPieces(mesh, pieces, facets, regions, sizes, monitor, Anywhere));
  EXPECT_EQ(Named(PiecesOf(mesh)), Named(pieces));
  const std::map<Id, double> now = VolumesOfRegions(mesh);
  ASSERT_EQ(now.size(), volumes.size());
  for (const auto& [region, volume] : volumes)
  {
    EXPECT_NEAR(now.at(region) / volume, 1, 1e-9);
  }
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    EXPECT_EQ(regions[mesh.Cell(c).Parent], mesh.Cell(c).Region);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, CellsBetweenPieces, testing::Range(0U, 6U));

TEST(CellsBetweenPieces, AreNotMadeWhereASurfaceIsOpenOrCrossesItself)
{
  const TetrahedralMesh grid = EvenGrid(2);
  const std::vector<FacetOfInput> facets = FacetsOf(grid, {}, {});
  RefinableMesh mesh = MakeRefinable(grid, {}, facets);
  const std::vector<SurfacePiece> whole = PiecesOf(mesh);
  const Id cells = mesh.NumberOfCells();
  const SizingParameters lengths;
  SizingField sizes(mesh, lengths);
  Monitor monitor;
  const auto isFilled = [&](const std::vector<SurfacePiece>& pieces)
  { return FillBetweenPieces(mesh, pieces, facets, {}, sizes, monitor, Anywhere); };
  const std::vector<SurfacePiece> open(whole.begin() + 1, whole.end());
  EXPECT_FALSE(isFilled(open));
  std::vector<SurfacePiece> turned = whole;
  std::swap(turned[3].Corners[0], turned[3].Corners[1]);
  EXPECT_FALSE(isFilled(turned));
  std::vector<SurfacePiece> crossing = whole;
  const Triangle& far = whole.back().Corners;
  crossing.push_back({ { { whole[0].Corners[0], whole[5].Corners[1], far[2] } }, {}, 0 });
  EXPECT_FALSE(isFilled(crossing));
  EXPECT_FALSE(isFilled({ whole.front() })) << "in a plane";
  EXPECT_EQ(mesh.NumberOfCells(), cells);
  EXPECT_EQ(Named(PiecesOf(mesh)), Named(whole));
  EXPECT_TRUE(isFilled(whole));
}

TEST(SurfaceMesh, KnowsWhatIsAtPointsAndEdgesAfterAnyChanges)
{
  std::mt19937 random(7);
  const auto piece = [&]
  {
    const Id a = random() % 8;
    return SurfacePiece{ { { a, static_cast<Id>(8 + random() % 8), static_cast<Id>(16 + a) } }, {},
      static_cast<Id>(random() % 100) };
  };
  SurfaceMesh mesh({ piece(), piece() });
  for (int change = 0; change < 300; ++change)
  {
    std::vector<Id> gone;
    for (Id p = 0; p < mesh.NumberOfPieces(); ++p)
    {
      if (!mesh.IsRemoved(p) && random() % 4 == 0)
      {
        gone.push_back(p);
      }
    }
    mesh.Replace(gone, std::vector<SurfacePiece>(random() % 4, piece()));
    std::vector<Edge> edges;
    std::size_t there = 0;
    for (Id p = 0; p < mesh.NumberOfPieces(); ++p)
    {
      if (mesh.IsRemoved(p))
      {
        continue;
      }
      ++there;
      const Triangle& corners = mesh.Piece(p).Corners;
      for (int i = 0; i < 3; ++i)
      {
        const std::vector<Id>& at = mesh.At(corners[i]);
        EXPECT_EQ(std::count(at.begin(), at.end(), p), 1);
        const std::vector<Id> atEdge = mesh.AtEdge(corners[i], corners[(i + 1) % 3]);
        EXPECT_EQ(std::count(atEdge.begin(), atEdge.end(), p), 1);
        edges.push_back(EdgeBetween(corners[i], corners[(i + 1) % 3]));
      }
    }
    SortUniquely(edges);
    EXPECT_EQ(mesh.Edges(), edges);
    EXPECT_EQ(mesh.All().size(), there);
    std::size_t corners = 0;
    for (Id p = 0; p < 30; ++p)
    {
      corners += mesh.At(p).size();
    }
    EXPECT_EQ(corners, 3 * there);
  }
}

TEST(RemeshedSurface, HasLongEdgesOnBordersThatBendByLessThanTheTolerance)
{
  // Two labels, whose border has a corner at each of its points.
  TetrahedralMesh cube = EvenGrid(16);
  for (Point& p : cube.Points)
  {
    const bool isOdd = std::fmod((p[1] + p[2]) / 100, 2) == 1;
    p[0] = p[0] != 800 ? p[0] : isOdd ? 785 : 815;
  }
  cube = ConnectCells(cube.Points, cube.Cells);
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.SurfaceTolerance = 40;
  parameters.FeatureAngle = 20;
  parameters.Sizes.EdgeLength = 800;
  for (const Tetrahedron& cell : cube.Cells)
  {
    std::array<Id, 4> labels;
    for (int k = 0; k < 4; ++k)
    {
      const auto p = CornersOf(cube.Points, FaceOf(cell, k));
      labels[k] = std::min({ p[0][0], p[1][0], p[2][0] }) < 750 ? 0 : 1;
    }
    parameters.Labels.push_back(labels);
  }
  Monitor monitor;
  const RefinedMesh refined = RefineTetrahedra(cube, {}, parameters, monitor);
  testmeshes::ExpectRemeshingLaws(cube, {}, refined, 40);
  std::array<double, 2> areas = { { 0, 0 } };
  std::set<Id> onBorder;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (const Id face = refined.OriginalFaces[c][k]; face != None)
      {
        const Triangle corners = FaceOf(refined.Cells[c], k);
        const auto [a, b, d] = CornersOf(refined.Points, corners);
        areas[parameters.Labels[face / 4][face % 4]] += Length(NormalOf(a, b, d)) / 2;
        for (const Id p : corners)
        {
          if (std::abs(refined.Points[p][0] - 800) < 60)
          {
            onBorder.insert(p);
          }
        }
      }
    }
  }
  EXPECT_LT(onBorder.size(), 24U); // of 64
  EXPECT_NEAR(areas[0] / (3 * 1600 * 1600), 1, 0.05);
  EXPECT_NEAR(areas[1] / (3 * 1600 * 1600), 1, 0.05);
}
