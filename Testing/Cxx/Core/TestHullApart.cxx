// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Stages.h"
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Output/BoundaryTriangles.h"
#include "Output/MassProperties.h"
#include "Output/Outliers.h"
#include "Output/Regions.h"
#include "Output/Topology.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"
#include "WindingNumber/SurfaceWindingNumber.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

// A hull for each part instead of one for all: the same solid.

namespace
{
using namespace insideout;
using testmeshes::Join;

constexpr ProgressRange Progress = { Stages::Extracting, 0, 1 };

struct Solid
{
  HullMesh Hull;
  std::vector<unsigned char> Inside;
  Id Parts = 0; ///< as the statistic says
};

Solid MakeSolid(const TriangleSoup& soup, bool apart)
{
  HullMeshParameters parameters;
  parameters.PartsApart = apart;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  Monitor silent;
  Solid solid;
  solid.Hull = MeshHull(soup, parameters, silent);
  solid.Inside = SegmentMesh(solid.Hull.Mesh, solid.Hull.W, {}, {}, {}, silent).Inside;
  for (const auto& [name, value] : solid.Hull.Statistics)
  {
    solid.Parts = name == "PartsApart" ? static_cast<Id>(value) : solid.Parts;
  }
  return solid;
}

/** A triangle that begins with its lowest point, and the input triangle that it lies on. */
using Face = std::pair<std::array<Point, 3>, Id>;

std::vector<Face> BoundaryOf(const Solid& solid)
{
  Monitor silent;
  const TetrahedralMesh& mesh = solid.Hull.Mesh;
  std::vector<Face> faces;
  for (const BoundaryTriangle& triangle : BoundaryTriangles(solid.Hull.Surface, mesh,
         BoundaryFaces(mesh, solid.Inside, silent, Progress), silent, Progress))
  {
    Face face;
    for (int k = 0; k < 3; ++k)
    {
      face.first[k] = mesh.Points[triangle.Corners[k]];
    }
    std::rotate(
      face.first.begin(), std::min_element(face.first.begin(), face.first.end()), face.first.end());
    face.second = triangle.Source;
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/** Volume and center of each region, by the place of the center. */
std::vector<std::array<double, 4>> RegionsOf(const Solid& solid)
{
  Monitor silent;
  std::vector<std::array<double, 4>> regions;
  for (const MassProperties& mass :
    MeasureRegions(solid.Hull.Mesh, FindRegions(solid.Hull.Mesh, solid.Inside, silent, Progress)))
  {
    regions.push_back(
      { mass.CenterOfMass[0], mass.CenterOfMass[1], mass.CenterOfMass[2], mass.Volume });
  }
  std::sort(regions.begin(), regions.end());
  return regions;
}

std::vector<std::pair<Id, OutlierReason>> OutliersOf(const Solid& solid)
{
  Monitor silent;
  std::vector<std::pair<Id, OutlierReason>> outliers;
  for (const OutlierPiece& piece :
    OutlierPieces(solid.Hull.Surface, solid.Hull.Mesh, solid.Inside, silent, Progress))
  {
    outliers.emplace_back(SourceOfFacet(solid.Hull.Surface, piece.Facet, 1), piece.Reason);
  }
  std::sort(outliers.begin(), outliers.end());
  return outliers;
}

Statistics TopologyOf(const Solid& solid)
{
  Monitor silent;
  Statistics statistics;
  AppendTopology(
    FindTopology(solid.Hull.Mesh, solid.Inside,
      BoundaryFaces(solid.Hull.Mesh, solid.Inside, silent, Progress), silent, Progress),
    statistics);
  return statistics;
}

/** @param[in] parts how many there are at least */
void ExpectTheSameSolid(const TriangleSoup& soup, Id parts)
{
  const Solid whole = MakeSolid(soup, false);
  const Solid apart = MakeSolid(soup, true);
  EXPECT_GE(apart.Parts, parts);
  EXPECT_LE(apart.Hull.Mesh.NumberOfCells(), whole.Hull.Mesh.NumberOfCells());
  ASSERT_EQ(whole.Hull.Mesh.NumberOfSurfaceSteinerPoints, 0) << "choose another surface";
  ASSERT_EQ(apart.Hull.Mesh.NumberOfSurfaceSteinerPoints, 0) << "choose another surface";
  const std::vector<Face> boundary = BoundaryOf(whole);
  EXPECT_FALSE(boundary.empty());
  EXPECT_EQ(BoundaryOf(apart), boundary);
  EXPECT_EQ(OutliersOf(apart), OutliersOf(whole));
  EXPECT_EQ(TopologyOf(apart), TopologyOf(whole));
  const auto regions = RegionsOf(whole);
  const auto found = RegionsOf(apart);
  ASSERT_EQ(found.size(), regions.size());
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    for (int k = 0; k < 4; ++k)
    {
      EXPECT_NEAR(found[r][k], regions[r][k], 1e-9) << "region " << r;
    }
  }
}

TriangleSoup Moved(TriangleSoup soup, const Point& by, double factor)
{
  for (Point& p : soup.Points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      p[axis] = by[axis] + factor * p[axis];
    }
  }
  return soup;
}

/** Boxes that cross, touch and hold each other, in clusters that do not meet. */
TriangleSoup Clusters(unsigned seed, int perAxis)
{
  TriangleSoup all;
  for (int i = 0; i < perAxis * perAxis * perAxis; ++i)
  {
    const Point place = { 16.0 * (i % perAxis), 16.0 * (i / perAxis % perAxis),
      16.0 * (i / perAxis / perAxis) };
    all = Join(std::move(all), Moved(testmeshes::GridBoxes(seed + i, 3 + i % 3), place, 1));
  }
  return all;
}

TriangleSoup OpenBox(const Point& low, double size)
{
  TriangleSoup box = Moved(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }), low, size);
  box.Triangles.erase(box.Triangles.begin() + 1);
  return box;
}
} // namespace

TEST(HullApart, AClosedSurfaceBecomesTheSameSolid)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    ExpectTheSameSolid(Clusters(100 * seed, 2), 8);
  }
}

TEST(HullApart, CavitiesAndPartsInThemStay)
{
  TriangleSoup shell = testmeshes::Box({ 0, 0, 0 }, { 9, 9, 9 });
  shell = Join(shell, testmeshes::Reversed(testmeshes::Box({ 1, 1, 1 }, { 8, 8, 8 })));
  shell = Join(shell, testmeshes::Box({ 4, 4, 4 }, { 5, 5, 5 }));
  ExpectTheSameSolid(Join(shell, testmeshes::Box({ 20, 0, 0 }, { 21, 1, 1 })), 2);
}

TEST(HullApart, PartsThatAreInsideOutAreTurnedTheSameWay)
{
  ExpectTheSameSolid(Join(testmeshes::Reversed(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 })),
                       testmeshes::Box({ 2, 0, 0 }, { 3, 1, 1 })),
    2);
}

TEST(HullApart, EachCellHasTheWindingNumberOfTheWholeSurface)
{
  TriangleSoup soup = Join(OpenBox({ 0, 0, 0 }, 1), OpenBox({ 4, 0.5, 0 }, 2));
  soup = Join(soup, Moved(testmeshes::TwistedPrism(5, -0.3), { 2.5, 6, 2 }, 1));
  soup = Join(soup, testmeshes::Box({ 2, 0.25, 0.25 }, { 2.5, 0.5, 0.5 }));
  const Solid apart = MakeSolid(soup, true);
  EXPECT_GE(apart.Parts, 2);
  std::vector<Point> centers;
  for (const Tetrahedron& cell : apart.Hull.Mesh.Cells)
  {
    centers.push_back({ 0, 0, 0 });
    for (const Id corner : cell)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        centers.back()[axis] += apart.Hull.Mesh.Points[corner][axis] / 4;
      }
    }
  }
  Monitor silent;
  const std::vector<double> expected =
    SurfaceWindingNumber(apart.Hull.Surface, {}, silent).At(centers, silent);
  ASSERT_EQ(apart.Hull.W.size(), expected.size());
  for (std::size_t cell = 0; cell < expected.size(); ++cell)
  {
    EXPECT_NEAR(apart.Hull.W[cell], expected[cell], 1e-9) << cell;
  }
}

TEST(HullApart, OpenPartsFarFromEachOtherBecomeTheSameSolid)
{
  TriangleSoup soup = Join(OpenBox({ 0, 0, 0 }, 1), OpenBox({ 4, 0.5, 0 }, 2));
  soup = Join(soup, testmeshes::Box({ 0, 9, 0 }, { 1, 10, 1 }));
  ExpectTheSameSolid(soup, 2);
}
