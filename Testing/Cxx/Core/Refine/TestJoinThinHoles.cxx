// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/JoinThinHoles.h"

#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Refine/MakeRefinable.h"
#include "Support/RefinementLaws.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace insideout;
using testtetrahedra::EvenGrid;

namespace
{
constexpr Id Surface = 5;
constexpr Id Hole = 7;

/** A cube of 600 whose grid has a row of width 1, from y = 300 on. */
TetrahedralMesh CubeWithThinRow()
{
  TetrahedralMesh cube = EvenGrid(6);
  for (Point& p : cube.Points)
  {
    p[1] = p[1] == 400 ? 301 : p[1];
  }
  return ConnectCells(cube.Points, cube.Cells);
}

using Places = std::array<Point, 3>;

bool AreAll(const Places& places, const std::function<bool(const Point&)>& isThere)
{
  return std::all_of(places.begin(), places.end(), isThere);
}

/** Parameters of a surface to be remeshed, in which some faces close holes. */
RefinementParameters WithHoles(
  const TetrahedralMesh& mesh, const std::function<bool(const Places&)>& isHole)
{
  RefinementParameters parameters;
  parameters.Surface = SurfaceTreatment::Remeshed;
  parameters.LabelOfHoles = Hole;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    std::array<Id, 4> labels;
    for (int k = 0; k < 4; ++k)
    {
      labels[k] = isHole(CornersOf(mesh.Points, FaceOf(cell, k))) ? Hole : Surface;
    }
    parameters.Labels.push_back(labels);
  }
  return parameters;
}

/** Whether a face is in the thin row on top of that cube. */
bool IsInRow(const Places& places)
{
  return AreAll(places, [](const Point& p) { return p[2] == 600 && p[1] >= 300 && p[1] <= 301; });
}

/** The number of facets that close holes, before and after thin ones are joined. */
std::array<std::ptrdiff_t, 2> FacetsOfHoles(
  const TetrahedralMesh& mesh, const RefinementParameters& parameters, double distance)
{
  const std::vector<Id> regions(mesh.Cells.size(), 0);
  std::vector<FacetOfInput> facets = FacetsOf(mesh, regions, parameters.Labels);
  const auto count = [&]
  {
    return std::count_if(
      facets.begin(), facets.end(), [](const FacetOfInput& facet) { return facet.Label == 1; });
  };
  const std::ptrdiff_t before = count();
  JoinThinHoles(regions, parameters, distance, facets);
  return { { before, count() } };
}
} // namespace

TEST(JoinThinHoles, JoinsHolesWithinADistanceOfTheRestAlone)
{
  const TetrahedralMesh cube = CubeWithThinRow();
  const RefinementParameters strip = WithHoles(cube, IsInRow);
  using Counts = std::array<std::ptrdiff_t, 2>;
  EXPECT_EQ(FacetsOfHoles(cube, strip, 1.01), (Counts{ { 12, 0 } }));
  EXPECT_EQ(FacetsOfHoles(cube, strip, 0.49), (Counts{ { 12, 12 } }));

  const RefinementParameters both = WithHoles(cube,
    [](const Places& places)
    {
      return IsInRow(places) ||
        AreAll(places,
          [](const Point& p) { return p[2] == 600 && p[1] <= 100 && p[0] >= 200 && p[0] <= 400; });
    });
  EXPECT_EQ(FacetsOfHoles(cube, both, 2), (Counts{ { 16, 4 } }));

  RefinementParameters named = strip;
  named.LabelOfHoles = None; // a tag of the user's
  EXPECT_EQ(FacetsOfHoles(cube, named, 2), (Counts{ { 12, 12 } }));
}

TEST(JoinThinHoles, JoinsHolesToFacetsBetweenTheSameRegions)
{
  // The strip is the border between two regions: on either side it joins its own.
  const TetrahedralMesh cube = CubeWithThinRow();
  const RefinementParameters strip = WithHoles(cube, IsInRow);
  std::vector<Id> regions;
  for (const Tetrahedron& cell : cube.Cells)
  {
    const auto p = CornersOf(cube.Points, cell);
    regions.push_back(std::min({ p[0][0], p[1][0], p[2][0], p[3][0] }) < 300 ? 0 : 1);
  }
  std::vector<FacetOfInput> facets = FacetsOf(cube, regions, strip.Labels);
  const auto regionOf = [&](const FacetOfInput& facet) { return regions[facet.Faces[0] / 4]; };
  JoinThinHoles(regions, strip, 2, facets);
  std::array<Id, 2> labels = { { None, None } };
  for (const FacetOfInput& facet : facets)
  {
    if (facet.Faces[1] == None)
    {
      Id& label = labels[regionOf(facet)];
      label = label == None ? facet.Label : label;
      EXPECT_EQ(facet.Label, label);
    }
  }
  EXPECT_NE(labels[0], labels[1]);
}

TEST(RemeshedSurface, HasLongEdgesWherePartsDoNotQuiteMeet)
{
  // Holes of width 1, one in every other column.
  TetrahedralMesh fine = EvenGrid(12);
  for (Point& p : fine.Points)
  {
    p[1] = p[1] == 700 ? 601 : p[1];
  }
  fine = ConnectCells(fine.Points, fine.Cells);
  RefinementParameters parameters = WithHoles(fine,
    [](const Places& places)
    {
      const double x = (places[0][0] + places[1][0] + places[2][0]) / 3;
      return std::fmod(x, 200) < 100 &&
        AreAll(places, [](const Point& p) { return p[2] == 1200 && p[1] >= 600 && p[1] <= 601; });
    });
  parameters.SurfaceTolerance = 2;
  parameters.Sizes.EdgeLength = 400;
  Monitor monitor;
  std::array<std::size_t, 2> points;
  for (int i = 0; i < 2; ++i)
  {
    parameters.LabelOfHoles = i == 0 ? None : Hole;
    const RefinedMesh refined = RefineTetrahedra(fine, {}, parameters, monitor);
    testmeshes::ExpectRemeshingLaws(fine, {}, refined, 2);
    points[i] = refined.Points.size();
  }
  EXPECT_LT(3 * points[1], points[0]);
}
