// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SizesByRules.h"

#include "Common/NearestPoint.h"
#include "Common/ScaledPoints.h"
#include "Common/SortedTriangle.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/MakeRefinable.h"
#include "Refine/SizeSources.h"
#include "Refine/SurfaceCurvature.h"
#include "Refine/WallThickness.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <limits>
#include <map>
#include <random>
#include <sstream>

using namespace insideout;

namespace
{
const double Pi = std::acos(-1.0);
constexpr double Infinite = std::numeric_limits<double>::infinity();

/** A box from 0 to these sizes, of this number of cubes along each axis. */
TetrahedralMesh BoxOf(const Point& sizes, int cubes)
{
  TetrahedralMesh grid = testtetrahedra::EvenGrid(cubes);
  for (Point& p : grid.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] *= sizes[axis] / 100 / cubes;
    }
  }
  return ConnectCells(grid.Points, grid.Cells);
}

/** The ball of radius 1: cells from its center to the pieces of an octahedron, projected. */
TetrahedralMesh Ball(int halvings)
{
  std::vector<Point> points = { { { 0, 0, 0 } } };
  std::map<Point, Id> numbers;
  const auto number = [&](const Point& p)
  {
    const double length = Length(p);
    const Point at = { { p[0] / length, p[1] / length, p[2] / length } };
    const auto [found, isNew] = numbers.insert({ at, static_cast<Id>(points.size()) });
    if (isNew)
    {
      points.push_back(at);
    }
    return found->second;
  };
  std::vector<Tetrahedron> cells;
  const std::function<void(const std::array<Point, 3>&, int)> add =
    [&](const std::array<Point, 3>& t, int depth)
  {
    if (depth == 0)
    {
      cells.push_back({ { 0, number(t[0]), number(t[1]), number(t[2]) } });
      return;
    }
    const std::array<Point, 3> m = { { Midpoint(t[0], t[1]), Midpoint(t[1], t[2]),
      Midpoint(t[2], t[0]) } };
    add({ { t[0], m[0], m[2] } }, depth - 1);
    add({ { m[0], t[1], m[1] } }, depth - 1);
    add({ { m[2], m[1], t[2] } }, depth - 1);
    add(m, depth - 1);
  };
  for (int octant = 0; octant < 8; ++octant)
  {
    const double x = (octant & 1) != 0 ? -1 : 1;
    const double y = (octant & 2) != 0 ? -1 : 1;
    const double z = (octant & 4) != 0 ? -1 : 1;
    const Point a = { { x, 0, 0 } };
    const Point b = { { 0, y, 0 } };
    const Point c = { { 0, 0, z } };
    x* y* z > 0 ? add({ { a, b, c } }, halvings) : add({ { a, c, b } }, halvings);
  }
  return ConnectCells(points, cells);
}

/** Edges of the boundary and between regions, each once. */
std::vector<std::array<Point, 2>> SurfaceEdges(const RefinedMesh& refined)
{
  std::map<Edge, std::array<Point, 2>> edges;
  for (std::size_t c = 0; c < refined.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Triangle f = FaceOf(refined.Cells[c], k);
      for (int i = 0; i < 3 && refined.OriginalFaces[c][k] != None; ++i)
      {
        const Edge edge = EdgeBetween(f[i], f[(i + 1) % 3]);
        edges[edge] = { { refined.Points[edge[0]], refined.Points[edge[1]] } };
      }
    }
  }
  std::vector<std::array<Point, 2>> all;
  std::transform(edges.begin(), edges.end(), std::back_inserter(all),
    [](const auto& one) { return one.second; });
  return all;
}

/** The mean length of the edges both ends of which are chosen. */
template <class Chosen>
double MeanLength(const RefinedMesh& refined, const Chosen& isChosen)
{
  double sum = 0;
  int count = 0;
  for (const auto& [a, b] : SurfaceEdges(refined))
  {
    if (isChosen(a) && isChosen(b))
    {
      sum += Distance(a, b);
      ++count;
    }
  }
  return sum / count;
}

RefinedMesh Refined(const TetrahedralMesh& mesh, const std::string& rules,
  RefinementParameters parameters = {}, const std::vector<Id>& regions = {})
{
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.Sizes.Rules = ReadSizeRules(rules);
  for (SizeRule& rule : parameters.Sizes.Rules)
  {
    rule.Label = rule.What == SizeRule::Kind::Tag ? 7 : None;
  }
  Monitor monitor;
  return RefineTetrahedra(mesh, regions, parameters, monitor);
}

bool IsBelow(const Point& p)
{
  return p[2] == 0;
}

/** Labels of a box: 7 below, else 0. */
std::vector<std::array<Id, 4>> LabelBelow(const TetrahedralMesh& mesh)
{
  std::vector<std::array<Id, 4>> labels;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    labels.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      const Triangle f = FaceOf(cell, k);
      const bool isBelow =
        std::all_of(f.begin(), f.end(), [&](Id p) { return IsBelow(mesh.Points[p]); });
      labels.back()[k] = isBelow ? 7 : 0;
    }
  }
  return labels;
}

/** Volume of the regular tetrahedron of this edge. */
double RegularVolume(double edge)
{
  return edge * edge * edge / (6 * std::sqrt(2.0));
}
} // namespace

TEST(SizeSources, HaveTheLeastLengthGrowingWithTheDistance)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto place = [&] { return Point{ { uniform(random), uniform(random), uniform(random) } }; };
  std::vector<SizeSource> sources;
  for (int i = 0; i < 100; ++i)
  {
    const Point a = place();
    const double length = std::exp(-8 * uniform(random));
    const double reach = i % 3 == 0 ? 0.1 * uniform(random) : 0;
    sources.push_back(
      { { { a, i % 2 == 0 ? a : place(), i % 4 < 2 ? a : place() } }, length, reach });
  }
  constexpr double Grading = 0.35;
  const SizeSources lengths(sources, Grading);
  Point before = place();
  for (int i = 0; i < 1000; ++i)
  {
    const Point p = place();
    double least = Infinite;
    for (const SizeSource& source : sources)
    {
      const double distance = Distance(NearestPointOf(source.Corners, p), p);
      least = std::min(least, source.Length + Grading * std::max(0.0, distance - source.Reach));
    }
    EXPECT_EQ(lengths.LengthAt(p), least);
    EXPECT_LE(std::abs(lengths.LengthAt(p) - lengths.LengthAt(before)),
      Grading * Distance(p, before) * (1 + 1e-9));
    before = p;
  }
  EXPECT_EQ(SizeSources({}, Grading).LengthAt(before), Infinite);
}

TEST(SurfaceCurvature, IsThatOfABallAndOfATubeAndNoneOfABox)
{
  const TetrahedralMesh ball = Ball(3);
  for (const double radius : RadiiOfCurvature(ball, FacetsOf(ball, {}, {}), 30))
  {
    EXPECT_NEAR(radius, 1, 0.25);
  }
  // A tube of one long quad for each of 30 sides, two triangles each.
  TetrahedralMesh tube;
  constexpr int Sides = 30;
  for (int side = 0; side < Sides; ++side)
  {
    const double angle = 2 * Pi * side / Sides;
    tube.Points.push_back({ { 2 * std::cos(angle), 2 * std::sin(angle), 0 } });
    tube.Points.push_back({ { 2 * std::cos(angle), 2 * std::sin(angle), 9 } });
  }
  tube.Points.push_back({ { 0, 0, 0 } });
  tube.Points.push_back({ { 0, 0, 9 } });
  std::vector<Tetrahedron> cells;
  for (Id side = 0; side < Sides; ++side)
  {
    const Id a = 2 * side;
    const Id b = 2 * ((side + 1) % Sides);
    const Id low = 2 * Sides;
    cells.push_back({ { low, a, b, low + 1 } });
    cells.push_back({ { a, b, low + 1, a + 1 } });
    cells.push_back({ { b, a + 1, b + 1, low + 1 } });
  }
  tube = ConnectCells(tube.Points, cells);
  const std::vector<FacetOfInput> facets = FacetsOf(tube, {}, {});
  const std::vector<double> radii = RadiiOfCurvature(tube, facets, 30);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const std::array<Point, 3>& c = facets[f].Corners;
    const bool isRound = !(c[0][2] == c[1][2] && c[1][2] == c[2][2]);
    EXPECT_NEAR(std::min(radii[f], 100.0), isRound ? 2 : 100, 0.02);
  }
  const TetrahedralMesh box = BoxOf({ { 1, 2, 3 } }, 2);
  for (const double radius : RadiiOfCurvature(box, FacetsOf(box, {}, {}), 91))
  {
    EXPECT_TRUE(radius == Infinite || radius < 3);
  }
  for (const double radius : RadiiOfCurvature(box, FacetsOf(box, {}, {}), 30))
  {
    EXPECT_EQ(radius, Infinite);
  }
}

TEST(WallThickness, IsTheWayToTheOtherSide)
{
  const TetrahedralMesh slab = BoxOf({ { 1, 1, 0.1 } }, 2);
  Monitor monitor;
  const std::vector<FacetOfInput> facets = FacetsOf(slab, {}, {});
  const std::vector<WallPart> walls =
    WallsOf(MakeRefinable(slab, {}, facets), monitor, { "", 0, 0 });
  int across = 0;
  for (const WallPart& wall : walls)
  {
    EXPECT_NEAR(wall.Thickness, wall.Thickness < 0.5 ? 0.1 : 1, 1e-12);
    for (const Point& corner : wall.Middle)
    {
      if (wall.Thickness < 0.5)
      {
        EXPECT_NEAR(corner[2], 0.05, 1e-12);
      }
    }
    across += wall.Thickness < 0.5 ? 1 : 0;
  }
  EXPECT_GE(across, 2 * 100); // parts no larger than the slab is thick, on both sides
}

TEST(WallThickness, SplitsFacetsOfThinSheetsIntoALimitedNumberOfParts)
{
  const TetrahedralMesh sheet = BoxOf({ { 10, 10, 1e-9 } }, 10);
  Monitor monitor;
  const std::vector<WallPart> walls =
    WallsOf(MakeRefinable(sheet, {}, FacetsOf(sheet, {}, {})), monitor, { "", 0, 0 });
  EXPECT_LE(walls.size(), 200000u);
  const auto isThin = [](const WallPart& wall)
  { return std::abs(wall.Thickness / 1e-9 - 1) < 1e-6; };
  EXPECT_GE(std::count_if(walls.begin(), walls.end(), isThin), 400);
}

TEST(SizesByRules, CurvatureGivesEdgesPerTurn)
{
  RefinementParameters parameters;
  parameters.SurfaceTolerance = 0.1; // of edges that long
  for (const double edges : { 12.0, 20.0 })
  {
    const TetrahedralMesh ball = Ball(3);
    const RefinedMesh refined = Refined(ball, "curvature=" + std::to_string(edges), parameters);
    testmeshes::ExpectRemeshingLaws(ball, {}, refined, parameters.SurfaceTolerance);
    const double mean = MeanLength(refined, [](const Point&) { return true; });
    EXPECT_GT(mean, 2 * Pi / edges / 1.3);
    EXPECT_LT(mean, 2 * Pi / edges * 1.3);
  }
}

TEST(SizesByRules, GapGivesCellsAcross)
{
  const TetrahedralMesh slab = BoxOf({ { 0.6, 0.6, 0.2 } }, 1);
  for (const int cells : { 2, 3 })
  {
    const RefinedMesh refined = Refined(slab, "gap=" + std::to_string(cells));
    testmeshes::ExpectRemeshingLaws(slab, {}, refined, 1e-3);
    const double expected = 0.072 / RegularVolume(0.2 / cells);
    EXPECT_GT(static_cast<double>(refined.Cells.size()), expected / 2);
    EXPECT_LT(static_cast<double>(refined.Cells.size()), expected * 2);
  }
}

TEST(SizesByRules, TagsHoldOnTheirFacetsAndSizesGrowFromThere)
{
  const TetrahedralMesh cube = BoxOf({ { 1, 1, 1 } }, 1);
  RefinementParameters parameters;
  parameters.Labels = LabelBelow(cube);
  const RefinedMesh refined = Refined(cube, "tag below=0.1", parameters);
  testmeshes::ExpectRemeshingLaws(cube, {}, refined, 1e-3);
  for (const auto& [a, b] : SurfaceEdges(refined))
  {
    if (IsBelow(a) && IsBelow(b))
    {
      EXPECT_LT(Distance(a, b), 0.2);
      EXPECT_GT(Distance(a, b), 0.05);
    }
  }
  EXPECT_GT(MeanLength(refined, [](const Point& p) { return p[2] == 1; }), 0.25);
}

TEST(SizesByRules, TheLeastLengthCounts)
{
  const TetrahedralMesh cube = BoxOf({ { 1, 1, 1 } }, 2);
  RefinementParameters parameters;
  parameters.Sizes.EdgeLength = 0.2;
  const auto above = [](const Point& p) { return p[2] == 1; };
  const RefinedMesh refined =
    Refined(cube, "point 0 0 0=0.05; point 0 0 0=3; point 1 0 0 0.2=0.07", parameters);
  EXPECT_NEAR(MeanLength(refined, above), 0.2, 0.06);
  const auto within = [](const Point& center, double radius)
  { return [=](const Point& p) { return Distance(p, center) < radius; }; };
  EXPECT_NEAR(MeanLength(refined, within({ { 0, 0, 0 } }, 0.1)), 0.06, 0.02);
  EXPECT_NEAR(MeanLength(refined, within({ { 1, 0, 0 } }, 0.2)), 0.07, 0.02);
}

TEST(SizesByRules, RegionsHaveTheirLengthAndPassItOn)
{
  const TetrahedralMesh box = BoxOf({ { 1, 1, 2 } }, 2);
  std::vector<Id> regions;
  RefinementParameters parameters;
  for (const Tetrahedron& cell : box.Cells)
  {
    double height = 0;
    for (const Id p : cell)
    {
      height += box.Points[p][2] / 4;
    }
    regions.push_back(height < 1 ? 5 : 3);
    parameters.Sizes.LengthOfCell.push_back(height < 1 ? 0.15 : Infinite);
  }
  const RefinedMesh refined = Refined(box, "region low=0.15", parameters, regions);
  EXPECT_NEAR(MeanLength(refined, [](const Point& p) { return p[2] <= 1; }), 0.15, 0.04);
  EXPECT_GT(MeanLength(refined, [](const Point& p) { return p[2] == 2; }), 0.3);
}

TEST(SizesByRules, ShorterEdgesOfTheSurfaceStayWithoutCurvature)
{
  const TetrahedralMesh cube = BoxOf({ { 1, 1, 1 } }, 4);
  const auto high = [](const Point& p) { return p[2] == 1; };
  const double local = MeanLength(Refined(cube, "point 0 0 0=0.1"), high);
  EXPECT_NEAR(local, 0.28, 0.05);
  EXPECT_GT(MeanLength(Refined(cube, "point 0 0 0=0.1; curvature=6"), high), 1.2 * local);
}

TEST(SizesByRules, DoNotDependOnTheUnit)
{
  const TetrahedralMesh cube = BoxOf({ { 1, 1, 1 } }, 1);
  TetrahedralMesh huge = cube;
  huge.Points = ScaledPoints(cube.Points, 200);
  RefinementParameters parameters;
  parameters.Labels = LabelBelow(cube);
  const auto rules = [](double unit)
  {
    const auto text = [unit](double length)
    {
      std::ostringstream words;
      words << std::setprecision(17) << length * unit;
      return words.str();
    };
    return "tag below=" + text(0.25) + "; gap=3; point 0 0 " + text(1) + " " + text(0.125) + "=" +
      text(0.125);
  };
  const RefinedMesh refined = Refined(cube, rules(1), parameters);
  const RefinedMesh other = Refined(huge, rules(std::ldexp(1, 200)), parameters);
  EXPECT_GT(refined.Cells.size(), 100u);
  EXPECT_EQ(other.Cells, refined.Cells);
  EXPECT_EQ(other.LengthsByRules.front(), std::ldexp(refined.LengthsByRules.front(), 200));
}

TEST(SizesByRules, EstimatesFollowThem)
{
  const TetrahedralMesh cube = BoxOf({ { 1, 1, 1 } }, 1);
  RefinementParameters parameters;
  parameters.MaximumCells = 5000;
  const auto cells = Refined(cube, "point 0.5 0.5 0.5 0.1=0.04", parameters).Cells.size();
  EXPECT_LT(cells, 5000u);
  EXPECT_GT(cells, 1000u);
  EXPECT_THROW(Refined(cube, "point 0.5 0.5 0.5 0.1=0.02", parameters), Error);
  EXPECT_THROW(Refined(cube, "gap=60", parameters), Error);
}
