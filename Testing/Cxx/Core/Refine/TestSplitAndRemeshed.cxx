// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefineTetrahedra.h"

#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/MakeRefinable.h"
#include "Refine/RemeshSurface.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

using namespace insideout;
using testmeshes::ExpectRemeshingLaws;
using testmeshes::ExpectSplitLaws;
using testmeshes::ShareOfGoodEdges;
using testtetrahedra::EvenGrid;
using testtetrahedra::Part;

namespace
{
RefinedMesh Refined(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const RefinementParameters& parameters)
{
  Monitor monitor;
  return RefineTetrahedra(mesh, regions, parameters, monitor);
}

RefinementParameters Split()
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Split;
  return parameters;
}

RefinementParameters Remeshed(double tolerance, double edgeLength)
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.SurfaceTolerance = tolerance;
  parameters.Sizes.EdgeLength = edgeLength;
  return parameters;
}

double StatisticOf(const RefinedMesh& refined, const std::string& name)
{
  const auto found = std::find_if(refined.Statistics.begin(), refined.Statistics.end(),
    [&](const auto& entry) { return entry.first == name; });
  EXPECT_NE(found, refined.Statistics.end()) << name;
  return found == refined.Statistics.end() ? -1 : found->second;
}

/** A cylinder of radius 1 and many sides, with a triangle from the center of each rim to each. */
TetrahedralMesh Cylinder(int sides, double height)
{
  std::vector<Point> points = { { { 0, 0, 0 } }, { { 0, 0, height } } };
  std::vector<Tetrahedron> cells;
  for (int k = 0; k < sides; ++k)
  {
    const double angle = k * 2 * std::acos(-1.0) / sides;
    points.push_back({ { std::cos(angle), std::sin(angle), 0 } });
    points.push_back({ { std::cos(angle), std::sin(angle), height } });
    const Id low = 2 + 2 * k;
    const Id next = 2 + 2 * ((k + 1) % sides);
    cells.push_back({ { 0, low, next, next + 1 } });
    cells.push_back({ { 0, low, next + 1, low + 1 } });
    cells.push_back({ { 0, low + 1, next + 1, 1 } });
  }
  return ConnectCells(points, cells);
}

/** A ball of radius 1, made of a cube whose points are drawn to spheres. */
TetrahedralMesh Ball(int size)
{
  TetrahedralMesh grid = EvenGrid(size);
  for (Point& p : grid.Points)
  {
    for (double& x : p)
    {
      x = x / (50 * size) - 1;
    }
    const double most = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    const double length = Length(p);
    for (double& x : p)
    {
      x = length > 0 ? x * most / length : 0;
    }
  }
  return ConnectCells(grid.Points, grid.Cells);
}
} // namespace

class SplitAndRemeshed : public testing::TestWithParam<unsigned>
{
};

TEST_P(SplitAndRemeshed, KeepTheirLawsOnAnySolid)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 4);
  const TetrahedralMesh part = Part(grid, testtetrahedra::RandomInside(grid, GetParam()));
  ExpectSplitLaws(part, {}, Refined(part, {}, Split()));
  ExpectRemeshingLaws(part, {}, Refined(part, {}, Remeshed(8, 0)), 8);
}

TEST_P(SplitAndRemeshed, KeepTheirLawsBetweenRegions)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 3);
  const std::vector<int> labels = testtetrahedra::RandomLabels(grid, GetParam());
  const std::vector<Id> regions(labels.begin(), labels.end());
  ExpectSplitLaws(grid, regions, Refined(grid, regions, Split()));
  ExpectRemeshingLaws(grid, regions, Refined(grid, regions, Remeshed(8, 120)), 8);
}

TEST_P(SplitAndRemeshed, KeepTheirLawsOnSmoothRegions)
{
  // A ball in two halves: the disk between them is an interface that is remeshed as well.
  const TetrahedralMesh ball = Ball(4);
  std::vector<Id> regions;
  for (const Tetrahedron& cell : ball.Cells)
  {
    double x = 0;
    for (const Id corner : cell)
    {
      x += ball.Points[corner][GetParam() % 3];
    }
    regions.push_back(x > 0 ? 1 : 0);
  }
  const double length = 0.2 + 0.1 * (GetParam() % 4);
  ExpectRemeshingLaws(ball, regions, Refined(ball, regions, Remeshed(0.04, length)), 0.04);
  ExpectSplitLaws(ball, regions, Refined(ball, regions, Split()));
}

TEST_P(SplitAndRemeshed, TakeWhatIsSqueezed)
{
  for (const double factor : { 1.0 / 900, 1e-9 }) // not rounded to a file's digits
  {
    TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 3);
    testtetrahedra::Squeeze(grid, 1, factor);
    ExpectSplitLaws(grid, {}, Refined(grid, {}, Split()));
  }
  TetrahedralMesh plate = testtetrahedra::Grid(GetParam(), 3);
  testtetrahedra::Squeeze(plate, 1, 0.01);
  ExpectRemeshingLaws(plate, {}, Refined(plate, {}, Remeshed(0.2, 0)), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SplitAndRemeshed, testing::Range(0U, 3U));

TEST(RemeshedSurface, HasFewThinTrianglesBesideEdgesThatStayShort)
{
  const TetrahedralMesh disc = Cylinder(60, 1); // none of its rims may go
  const RefinedMesh refined = Refined(disc, {}, Remeshed(1e-4, 0));
  const TetrahedralMesh after = ConnectCells(refined.Points, refined.Cells);
  int thin = 0;
  int all = 0;
  for (std::size_t c = 0; c < after.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (after.Neighbors[c][k] == None)
      {
        const auto [a, b, d] = CornersOf(after.Points, FaceOf(after.Cells[c], k));
        const double longest = std::max({ Distance(a, b), Distance(b, d), Distance(d, a) });
        thin += Length(NormalOf(a, b, d)) < 0.25 * longest * longest ? 1 : 0;
        ++all;
      }
    }
  }
  EXPECT_LT(thin, 0.1 * all);
}

TEST(RemeshedSurface, HasFewThinCellsAlongAFineCylinder)
{
  const TetrahedralMesh cylinder = Cylinder(60, 4);
  const RefinedMesh refined = Refined(cylinder, {}, Remeshed(1e-3, 0));
  const std::vector<double> sines = testmeshes::LeastSines(refined.Points, refined.Cells);
  EXPECT_GT(sines[sines.size() / 20], std::sin(26 * std::acos(-1.0) / 180));
}

TEST(RemeshedSurface, HasEdgesAsLongAsAskedFor)
{
  const TetrahedralMesh ball = Ball(12); // edges of about 0.15
  for (const double length : { 0.1, 0.25 })
  {
    const RefinedMesh refined = Refined(ball, {}, Remeshed(0.05, length));
    const TetrahedralMesh after = ConnectCells(refined.Points, refined.Cells);
    int good = 0;
    int all = 0;
    for (std::size_t c = 0; c < after.Cells.size(); ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        const Triangle f = FaceOf(after.Cells[c], k);
        for (int i = 0; i < 3 && after.Neighbors[c][k] == None; ++i)
        {
          const double ratio = Distance(after.Points[f[i]], after.Points[f[(i + 1) % 3]]) / length;
          good += ratio > 1 / 1.4 && ratio < 1.4 ? 1 : 0;
          ++all;
        }
      }
    }
    EXPECT_GT(good, 0.9 * all) << length;
    EXPECT_LE(StatisticOf(refined, "SurfaceDistance"), 0.05);
    EXPECT_LE(StatisticOf(refined, "InputDistance"), 0.05);
    EXPECT_EQ(StatisticOf(refined, "KeptFacets"), 0);
  }
}

TEST(RemeshedSurface, OfACubeHasEdgesAsLongAsAskedForInFewCells)
{
  // gmsh 4.8 makes 36,842 tetrahedra at this length, a twentieth of the edge.
  const double length = 5;
  const RefinedMesh refined = Refined(EvenGrid(1), {}, Remeshed(0, length));
  std::set<std::pair<Id, Id>> edges;
  for (const Tetrahedron& cell : refined.Cells)
  {
    for (const auto& [i, j] : TetrahedronEdges)
    {
      edges.insert(std::minmax(cell[i], cell[j]));
    }
  }
  std::size_t good = 0;
  double longest = 0;
  for (const auto& [p, q] : edges)
  {
    const double ratio = Distance(refined.Points[p], refined.Points[q]) / length;
    good += ratio > 1 / 1.4 && ratio < 1.4 ? 1 : 0;
    longest = std::max(longest, ratio);
  }
  EXPECT_LT(refined.Cells.size(), 1.3 * 36842);
  EXPECT_GT(static_cast<double>(good), 0.9 * static_cast<double>(edges.size()));
  EXPECT_LT(longest, 2);
}

TEST(RemeshedSurface, GetsFewTrianglesWhereLongEdgesAreAskedFor)
{
  TetrahedralMesh lens = Ball(16);
  testtetrahedra::Squeeze(lens, 2, 0.1);
  const auto countFaces = [](const TetrahedralMesh& mesh)
  {
    std::ptrdiff_t count = 0;
    for (const auto& neighbors : mesh.Neighbors)
    {
      count += std::count(neighbors.begin(), neighbors.end(), None);
    }
    return count;
  };
  const RefinedMesh refined = Refined(lens, {}, Remeshed(0.05, 0.6));
  const std::ptrdiff_t after = countFaces(ConnectCells(refined.Points, refined.Cells));
  EXPECT_LE(10 * after, countFaces(lens));
}

TEST(RemeshedSurface, FollowsALinearFieldAtPointsAndAnywhere)
{
  const TetrahedralMesh cube = EvenGrid(5);
  const auto wanted = [](const Point& p) { return 40 + p[0] / 10; };
  RefinementParameters atPoints = Remeshed(5, 0);
  for (const Point& p : cube.Points)
  {
    atPoints.Sizes.Lengths.push_back(wanted(p));
  }
  RefinementParameters anywhere = Remeshed(5, 0);
  anywhere.Sizes.LengthAt = wanted;
  for (const RefinementParameters& parameters : { atPoints, anywhere })
  {
    const RefinedMesh refined = Refined(cube, {}, parameters);
    ExpectRemeshingLaws(cube, {}, refined, 5);
    EXPECT_GT(ShareOfGoodEdges(refined, wanted), 0.9);
  }
}

TEST(RemeshedSurface, FollowsLengthsOfInnerPoints)
{
  const TetrahedralMesh cube = EvenGrid(4);
  const auto isInside = [](const Point& p, double rim)
  { return std::all_of(p.begin(), p.end(), [&](double x) { return x > rim && x < 400 - rim; }); };
  RefinementParameters parameters = Remeshed(5, 0);
  for (const Point& p : cube.Points)
  {
    parameters.Sizes.Lengths.push_back(isInside(p, 0) ? 30 : 100);
  }
  const RefinedMesh refined = Refined(cube, {}, parameters);
  // The surface's lengths alone leave some eight points there.
  EXPECT_GT(std::count_if(refined.Points.begin(), refined.Points.end(),
              [&](const Point& p) { return isInside(p, 100); }),
    150);
}

TEST(RemeshedSurface, KeepsTheEdgesOfACubeAndThoseBetweenLabels)
{
  const TetrahedralMesh cube = EvenGrid(5);
  RefinementParameters parameters = Remeshed(40, 70);
  parameters.Labels.assign(cube.Cells.size(), { { 0, 0, 0, 0 } });
  for (std::size_t c = 0; c < cube.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto [a, b, d] = CornersOf(cube.Points, FaceOf(cube.Cells[c], k));
      parameters.Labels[c][k] = a[0] + b[0] + d[0] < 3 * 200 ? 0 : 1;
    }
  }
  const RefinedMesh refined = Refined(cube, {}, parameters);
  double volume = 0;
  for (const Tetrahedron& cell : refined.Cells)
  {
    const auto [p, q, r, s] = CornersOf(refined.Points, cell);
    volume += Determinant(Difference(q, p), Difference(r, p), Difference(s, p)) / 6;
  }
  EXPECT_NEAR(volume / 1.25e8, 1, 1e-12); // all corners and edges are there
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (const Id original = refined.OriginalFaces[c][k]; original != None)
      {
        const auto [a, b, d] = CornersOf(refined.Points, FaceOf(refined.Cells[c], k));
        const bool isLow = std::max({ a[0], b[0], d[0] }) <= 200;
        EXPECT_TRUE(isLow || std::min({ a[0], b[0], d[0] }) >= 200);
        EXPECT_EQ(parameters.Labels[original / 4][original % 4], isLow ? 0 : 1);
      }
    }
  }
}

TEST(RemeshedSurface, HasLongEdgesOnRidgesBetweenWideAndNarrowSides)
{
  // A plate, whose rim has triangles far smaller than those of its faces.
  TetrahedralMesh plate = EvenGrid(8);
  for (Point& p : plate.Points)
  {
    p[2] /= 40;
  }
  plate = ConnectCells(plate.Points, plate.Cells);
  const RefinedMesh refined = Refined(plate, {}, Remeshed(1, 400));
  ExpectRemeshingLaws(plate, {}, refined, 1);
  const auto onRidge = [](const Point& p) {
    return (p[0] == 0 || p[0] == 800) + (p[1] == 0 || p[1] == 800) + (p[2] == 0 || p[2] == 20) > 1;
  };
  const auto count = [&](const std::vector<Point>& points)
  { return std::count_if(points.begin(), points.end(), onRidge); };
  EXPECT_LT(3 * count(refined.Points), count(plate.Points));
}

TEST(RemeshedSurface, KeepsTheSmallestLabels)
{
  // A square in the interior of a cube's side, smaller than the tolerance, whose corners are smooth
  // enough.
  const TetrahedralMesh cube = EvenGrid(6);
  RefinementParameters parameters = Remeshed(1000, 1000);
  parameters.FeatureAngle = 100;
  parameters.Labels.assign(cube.Cells.size(), { { 0, 0, 0, 0 } });
  for (std::size_t c = 0; c < cube.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto places = CornersOf(cube.Points, FaceOf(cube.Cells[c], k));
      const bool isAmid = std::all_of(places.begin(), places.end(),
        [](const Point& p)
        { return p[2] == 0 && std::abs(p[0] - 300) <= 100 && std::abs(p[1] - 300) <= 100; });
      parameters.Labels[c][k] = isAmid ? 1 : 0;
    }
  }
  const RefinedMesh refined = Refined(cube, {}, parameters);
  ExpectRemeshingLaws(cube, {}, refined, 1000);
  EXPECT_LE(StatisticOf(refined, "InputDistance"), 1000);
}

TEST(SplitSurface, HasNoLongEdgesWhereShortOnesAreAskedFor)
{
  const TetrahedralMesh cube = EvenGrid(1);
  RefinementParameters parameters = Split();
  parameters.Sizes.EdgeLength = 20;
  const RefinedMesh refined = Refined(cube, {}, parameters);
  ExpectSplitLaws(cube, {}, refined);
  double longest = 0;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto [a, b, d] = CornersOf(refined.Points, FaceOf(refined.Cells[c], k));
      if (refined.OriginalFaces[c][k] != None)
      {
        longest = std::max({ longest, Distance(a, b), Distance(b, d), Distance(d, a) });
      }
    }
  }
  EXPECT_LT(longest, 1.4 * 20);
  EXPECT_GT(StatisticOf(refined, "SurfacePoints"), 6 * 20);
}

namespace
{
/** A bar of 1 : 1 : 20 whose sides are two needles each, turned, so that its points are rounded. */
TetrahedralMesh TurnedBar()
{
  TetrahedralMesh bar = EvenGrid(1);
  testtetrahedra::Squeeze(bar, 0, 20);
  for (Point& p : bar.Points)
  {
    p = { { 0.6 * p[0] - 0.8 * p[1] + 0.1, 0.8 * p[0] + 0.6 * p[1], p[2] } };
  }
  return bar;
}

/** Six times the volume. */
double VolumeOf(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  double sum = 0;
  for (const Tetrahedron& cell : cells)
  {
    const auto [a, b, c, d] = CornersOf(points, cell);
    sum += Determinant(Difference(b, a), Difference(c, a), Difference(d, a));
  }
  return sum;
}

/** The refined mesh if facets do not join. */
RefinedMesh SplitApart(const TetrahedralMesh& mesh)
{
  RefinementParameters apart = Split();
  apart.Attributes.resize(mesh.Cells.size());
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    const Id first = static_cast<Id>(4 * c);
    apart.Attributes[c] = { { first, first + 1, first + 2, first + 3 } };
  }
  return Refined(mesh, {}, apart);
}
} // namespace

TEST(SplitSurface, TakesNeedlesInAPlaneForOneFacet)
{
  TetrahedralMesh bar = EvenGrid(1);
  testtetrahedra::Squeeze(bar, 0, 20);
  for (const TetrahedralMesh& mesh : { bar, TurnedBar() })
  {
    const RefinedMesh refined = Refined(mesh, {}, Split());
    ExpectSplitLaws(mesh, {}, refined);
    const RefinedMesh single = SplitApart(mesh);
    EXPECT_LT(refined.Cells.size(), single.Cells.size());
    EXPECT_GT(testmeshes::LeastSines(refined.Points, refined.Cells).front(),
      testmeshes::LeastSines(single.Points, single.Cells).front());
  }
}

TEST(SplitSurface, TakesNeedlesForOneFacetUpToTheDigitsOfAFile)
{
  // The bar is 1,600 long in x; four decimals make eight digits.
  TetrahedralMesh bar = TurnedBar();
  for (std::size_t p = 0; p < bar.Points.size(); ++p)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double off = 0.0004 * static_cast<double>(p * (p + k) % 3); // no side is plane
      bar.Points[p][k] = std::round((bar.Points[p][k] + off) * 1e4) / 1e4;
    }
  }
  const RefinedMesh refined = Refined(bar, {}, Split());
  const RefinedMesh single = SplitApart(bar);
  EXPECT_LT(refined.Cells.size(), single.Cells.size());
  EXPECT_GT(testmeshes::LeastSines(refined.Points, refined.Cells).front(),
    testmeshes::LeastSines(single.Points, single.Cells).front());
  const std::set<Point> there(refined.Points.begin(), refined.Points.end());
  EXPECT_TRUE(std::all_of(bar.Points.begin(), bar.Points.end(),
    [&](const Point& point) { return there.count(point) > 0; }));

  // Coordinates with more digits are taken as they are.
  for (Point& point : bar.Points)
  {
    point[1] += 1e-9 * point[0];
  }
  EXPECT_EQ(Refined(bar, {}, Split()).Cells.size(), SplitApart(bar).Cells.size());
}

TEST_P(SplitAndRemeshed, KeepVolumesWhereFacetsJoinUpToTheDigitsOfAFile)
{
  // A plate whose thickness is 300 units of the last digit.
  TetrahedralMesh plate = testtetrahedra::Grid(GetParam(), 3);
  testtetrahedra::Squeeze(plate, 1, 1e-3);
  const RefinedMesh refined = Refined(plate, {}, Split());
  const double before = VolumeOf(plate.Points, plate.Cells);
  EXPECT_NEAR(VolumeOf(refined.Points, refined.Cells) / before, 1, 1e-6);
}

TEST(SplitSurface, KeepsTheEdgesBetweenAttributes)
{
  const TetrahedralMesh cube = EvenGrid(5);
  RefinementParameters parameters = Split();
  parameters.Attributes.assign(cube.Cells.size(), { { 0, 0, 0, 0 } });
  const auto areasOf = [&](const std::vector<Point>& points, const std::vector<Tetrahedron>& cells,
                         const std::vector<std::array<Id, 4>>& originals)
  {
    std::array<double, 2> areas = { { 0, 0 } };
    for (std::size_t c = 0; c < cells.size(); ++c)
    {
      for (int k = 0; k < 4; ++k)
      {
        if (const Id original = originals[c][k]; original != None)
        {
          const auto [a, b, d] = CornersOf(points, FaceOf(cells[c], k));
          areas[parameters.Attributes[original / 4][original % 4]] += Length(NormalOf(a, b, d));
        }
      }
    }
    return areas;
  };
  std::vector<std::array<Id, 4>> faces(cube.Cells.size(), { { None, None, None, None } });
  for (std::size_t c = 0; c < cube.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const auto [a, b, d] = CornersOf(cube.Points, FaceOf(cube.Cells[c], k));
      parameters.Attributes[c][k] = a[0] + b[1] + d[2] > 700 ? 1 : 0;
      faces[c][k] = cube.Neighbors[c][k] == None ? static_cast<Id>(4 * c) + k : None;
    }
  }
  const RefinedMesh refined = Refined(cube, {}, parameters);
  const auto before = areasOf(cube.Points, cube.Cells, faces);
  const auto after = areasOf(refined.Points, refined.Cells, refined.OriginalFaces);
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_GT(before[i], 0);
    EXPECT_NEAR(after[i] / before[i], 1, 1e-12);
  }
}

TEST(SplitSurface, LeavesLockedFacetsWhole)
{
  const TetrahedralMesh cube = EvenGrid(1);
  const std::vector<FacetOfInput> facets = FacetsOf(cube, {}, {});
  SizingParameters lengths;
  lengths.EdgeLength = 20;
  for (std::size_t kept = 0; kept < facets.size(); ++kept)
  {
    std::vector<char> locked(facets.size(), 0);
    locked[kept] = 1;
    RefinableMesh mesh = MakeRefinable(cube, {}, facets);
    RefinableSurface surface(mesh, facets, locked, SurfaceTreatment::Split, 30);
    SurfaceBound bound(mesh, facets, SurfaceTreatment::Split, 0);
    SizingField sizes(mesh, lengths);
    Monitor monitor;
    RemeshSurface(mesh, surface, bound, sizes, monitor, { "", 0, 1 });
    std::vector<int> pieces(facets.size(), 0);
    for (const SurfacePiece& piece : PiecesOf(mesh))
    {
      ++pieces[piece.Facet];
    }
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      EXPECT_EQ(pieces[f] == 1, f == kept) << "facet " << f << " of " << pieces[f] << " pieces";
    }
  }
}

TEST(SplitSurface, MakesNeedlesOfASurfaceGoodCells)
{
  // Boxes of 1 : 1 : 12, whose sides are two long triangles each.
  TetrahedralMesh bar = EvenGrid(2);
  testtetrahedra::Squeeze(bar, 0, 12);
  const RefinedMesh kept = Refined(bar, {}, {});
  const RefinedMesh split = Refined(bar, {}, Split());
  ExpectSplitLaws(bar, {}, split);
  // The bar's own edges between its long triangles are as sharp as 5 degrees in their plane.
  const std::vector<double> before = testmeshes::LeastSines(kept.Points, kept.Cells);
  const std::vector<double> after = testmeshes::LeastSines(split.Points, split.Cells);
  EXPECT_GT(after.front(), 1.2 * before.front());
  EXPECT_GT(after[after.size() / 20], 1.5 * before[before.size() / 20]);
}

TEST(SplitSurface, HasAHundredthOfItsCellsBelow28DegreesAtMost)
{
  const TetrahedralMesh ball = Ball(6);
  const RefinedMesh refined = Refined(ball, {}, Split());
  const std::vector<double> sines = testmeshes::LeastSines(refined.Points, refined.Cells);
  EXPECT_GT(sines[sines.size() / 100], std::sin(28 * std::acos(-1.0) / 180));
}

TEST(SurfaceTreatments, AreTheSameTwiceAndAtAnySize)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(5, 3);
  for (const RefinementParameters& parameters : { Split(), Remeshed(10, 90) })
  {
    const RefinedMesh first = Refined(grid, {}, parameters);
    const RefinedMesh second = Refined(grid, {}, parameters);
    EXPECT_EQ(first.Points, second.Points);
    EXPECT_EQ(first.Cells, second.Cells);
    EXPECT_EQ(first.OriginalFaces, second.OriginalFaces);
    for (const int exponent : { -900, 300, 900 })
    {
      TetrahedralMesh other = grid;
      other.Points = ScaledPoints(grid.Points, exponent);
      RefinementParameters scaled = parameters;
      scaled.SurfaceTolerance = std::ldexp(parameters.SurfaceTolerance, exponent);
      scaled.Sizes.EdgeLength = std::ldexp(parameters.Sizes.EdgeLength, exponent);
      EXPECT_EQ(Refined(other, {}, scaled).Cells, first.Cells) << exponent;
    }
  }
}

TEST(RemeshedSurface, HasNoFlatTrianglesBesideAnEdgeThatStays)
{
  // Four of the six cells of a cube, so that four facets meet in its diagonal: that stays as it is.
  // Its neighbors may not be halved again and again in its stead.
  const TetrahedralMesh grid = EvenGrid(1);
  std::vector<unsigned char> isTaken(grid.Cells.size(), 0);
  isTaken[0] = 1;
  for (std::size_t c = 1; c < grid.Cells.size(); ++c)
  {
    const Tetrahedron& first = grid.Cells[0];
    const auto shared = std::count_if(grid.Cells[c].begin(), grid.Cells[c].end(),
      [&](Id corner) { return std::find(first.begin(), first.end(), corner) != first.end(); });
    isTaken[c] = shared == 2 ? 1 : 0;
  }
  ASSERT_EQ(std::count(isTaken.begin(), isTaken.end(), 1), 4);
  const TetrahedralMesh four = Part(grid, isTaken);
  const RefinedMesh refined = Refined(four, {}, Remeshed(1, 10));
  ExpectRemeshingLaws(four, {}, refined, 1);
  EXPECT_GT(refined.Cells.size(), 100U);
  const TetrahedralMesh after = ConnectCells(refined.Points, refined.Cells);
  double lowest = 1;
  for (Id c = 0; c < after.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (after.Neighbors[c][k] == None)
      {
        const auto [p, q, r] = CornersOf(after.Points, FaceOf(after.Cells[c], k));
        const double longest = std::max({ Distance(p, q), Distance(q, r), Distance(r, p) });
        lowest = std::min(lowest, Length(NormalOf(p, q, r)) / (longest * longest));
      }
    }
  }
  EXPECT_GT(lowest, 0.01);
}
