// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/BoundaryLayers.h"

#include "Common/PointPredicates.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "GraphCut/ConnectCells.h"
#include "Layers/LayerColumns.h"
#include "Layers/LayerParameters.h"
#include "Quality/QualityOfMesh.h"
#include "Refine/RefineTetrahedra.h"
#include "Support/AllowedThreads.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

using namespace insideout;

namespace
{
/** A face of a cell by its corners, which run counter-clockwise seen from outside. */
using Face = std::vector<Id>;

void AppendFaces(const Tetrahedron& c, std::vector<Face>& faces)
{
  for (int k = 0; k < 4; ++k)
  {
    const Triangle face = FaceOf(c, k);
    faces.emplace_back(face.begin(), face.end());
  }
}

void AppendFaces(const Pyramid& c, std::vector<Face>& faces)
{
  faces.push_back({ c[0], c[3], c[2], c[1] });
  for (int k = 0; k < 4; ++k)
  {
    faces.push_back({ c[k], c[(k + 1) % 4], c[4] });
  }
}

void AppendFaces(const Prism& c, std::vector<Face>& faces)
{
  faces.push_back({ c[0], c[1], c[2] });
  faces.push_back({ c[3], c[5], c[4] });
  for (int k = 0; k < 3; ++k)
  {
    faces.push_back({ c[k], c[k + 3], c[(k + 1) % 3 + 3], c[(k + 1) % 3] });
  }
}

template <typename Cells>
void AppendCells(const Cells& cells, std::vector<std::vector<Face>>& faces)
{
  for (const auto& cell : cells)
  {
    faces.emplace_back();
    AppendFaces(cell, faces.back());
  }
}

/** The faces of each cell, in the order of LayeredMesh::Layers. */
std::vector<std::vector<Face>> FacesOfCells(const LayeredMesh& mesh)
{
  std::vector<std::vector<Face>> faces;
  AppendCells(mesh.Tetrahedra, faces);
  AppendCells(mesh.Pyramids, faces);
  AppendCells(mesh.Prisms, faces);
  return faces;
}

/** The volume that faces enclose, where quads are bilinear: the mean of both ways to cut them. */
double VolumeOf(const std::vector<Point>& points, const std::vector<Face>& faces)
{
  const Point& origin = points[faces.front().front()];
  const auto cone = [&](Id a, Id b, Id c)
  {
    return Determinant(Difference(points[a], origin), Difference(points[b], origin),
             Difference(points[c], origin)) /
      6;
  };
  double volume = 0;
  for (const Face& f : faces)
  {
    volume += f.size() == 3 ? cone(f[0], f[1], f[2])
                            : (cone(f[0], f[1], f[2]) + cone(f[0], f[2], f[3]) +
                                cone(f[0], f[1], f[3]) + cone(f[1], f[2], f[3])) /
        2;
  }
  return volume;
}

/** Faces by their corners: those of one cell, and between regions. */
std::vector<Face> Surface(
  const std::vector<std::vector<Face>>& cells, const std::vector<Id>& regions)
{
  std::map<Face, std::vector<std::size_t>> cellsOf;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (Face face : cells[c])
    {
      std::sort(face.begin(), face.end());
      cellsOf[face].push_back(c);
    }
  }
  std::vector<Face> surface;
  for (const auto& [face, around] : cellsOf)
  {
    EXPECT_LE(around.size(), 2U);
    if (around.size() == 1 || (!regions.empty() && regions[around[0]] != regions[around[1]]))
    {
      surface.push_back(face);
    }
  }
  return surface;
}

/** The surface that there should be: that of the mesh before, where its points are now, and the
 * layers' sides. */
std::vector<Face> ExpectedSurface(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const std::vector<Id>& wall, const LayeredMesh& layered)
{
  std::vector<Id> outer(mesh.Points.size(), None); // the point in the same place
  for (std::size_t p = 0; p < layered.Points.size(); ++p)
  {
    if (layered.OriginalPoints[p] != None)
    {
      outer[layered.OriginalPoints[p]] = static_cast<Id>(p);
    }
  }
  std::vector<std::vector<Face>> before;
  AppendCells(mesh.Cells, before);
  std::set<Face> wallFaces;
  for (const Id face : wall)
  {
    const Triangle corners = FaceOf(mesh.Cells[face / 4], face % 4);
    Face sorted(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    wallFaces.insert(sorted);
  }
  std::vector<Face> surface;
  for (const Face& face : Surface(before, regions))
  {
    const bool isOfWall = wallFaces.count(face) > 0;
    Face now;
    for (const Id p : face)
    {
      now.push_back(isOfWall ? outer[p] : layered.PointsBeside[p]);
    }
    surface.push_back(now);
  }
  for (const LayerSide& side : layered.Sides)
  {
    surface.emplace_back(
      side.Corners.begin(), side.Corners.end() - (side.Corners[3] == None ? 1 : 0));
  }
  for (Face& face : surface)
  {
    std::sort(face.begin(), face.end());
  }
  std::sort(surface.begin(), surface.end());
  return surface;
}

double StatisticOf(const LayeredMesh& mesh, const std::string& name)
{
  for (const auto& [other, value] : mesh.Statistics)
  {
    if (other == name)
    {
      return value;
    }
  }
  ADD_FAILURE() << name;
  return 0;
}

std::vector<Id> Boundary(const TetrahedralMesh& mesh)
{
  std::vector<Id> faces;
  for (Id c = 0; c < mesh.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[c][k] == None)
      {
        faces.push_back(4 * c + k);
      }
    }
  }
  return faces;
}

/** The least cosine of the angle by which triangles behind the layers are tilted. */
double LeastCosineOfTilt(const LayeredMesh& layered)
{
  const auto layers = static_cast<std::size_t>(StatisticOf(layered, "Layers"));
  double least = 1;
  for (std::size_t first = 0; first + layers <= layered.Prisms.size(); first += layers)
  {
    const Prism& outer = layered.Prisms[first];
    const Prism& inner = layered.Prisms[first + layers - 1];
    const auto normal = [&](const Prism& prism, int k)
    {
      return NormalOf(
        layered.Points[prism[k]], layered.Points[prism[k + 1]], layered.Points[prism[k + 2]]);
    };
    const Point u = normal(outer, 0);
    const Point v = normal(inner, 3);
    least = std::min(least, Dot(u, v) / (Length(u) * Length(v)));
  }
  return least;
}

/** Expect what MakeBoundaryLayers promises. */
void ExpectLaws(const TetrahedralMesh& mesh, const std::vector<Id>& regions,
  const LayeredMesh& layered, std::vector<Id> wall = {})
{
  wall = wall.empty() ? Boundary(mesh) : wall;
  const std::vector<Point>& points = layered.Points;
  EXPECT_TRUE(std::all_of(layered.Tetrahedra.begin(), layered.Tetrahedra.end(),
    [&](const Tetrahedron& cell) { return Orient3D(points, cell) > 0; }));
  const auto isPositive = [&](const auto& cell) { return Orient(points, cell) > 0; };
  EXPECT_TRUE(std::all_of(layered.Prisms.begin(), layered.Prisms.end(), isPositive));
  EXPECT_TRUE(std::all_of(layered.Pyramids.begin(), layered.Pyramids.end(), isPositive));
  EXPECT_GE(LeastCosineOfTilt(layered), 0.5 - 1e-9);

  const std::vector<std::vector<Face>> cells = FacesOfCells(layered);
  ASSERT_EQ(layered.Layers.size(), cells.size());
  ASSERT_EQ(layered.OriginalCells.size(), cells.size());
  std::vector<Id> regionsAfter;
  double volume = 0;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    const double part = VolumeOf(points, cells[c]);
    EXPECT_GT(part, 0) << c;
    volume += part;
    if (!regions.empty())
    {
      regionsAfter.push_back(regions[layered.OriginalCells[c]]);
    }
  }
  std::vector<std::vector<Face>> before;
  AppendCells(mesh.Cells, before);
  double volumeBefore = 0;
  for (const auto& cell : before)
  {
    volumeBefore += VolumeOf(mesh.Points, cell);
  }
  EXPECT_NEAR(volume, volumeBefore, 1e-9 * volumeBefore);
  EXPECT_EQ(Surface(cells, regionsAfter), ExpectedSurface(mesh, regions, wall, layered));
  // Beside the wall points stay in the planes of their facets.
  for (const Id face : Boundary(mesh))
  {
    const Triangle corners = FaceOf(mesh.Cells[face / 4], face % 4);
    const auto plane = CornersOf(mesh.Points, corners);
    const Point normal = NormalOf(plane[0], plane[1], plane[2]);
    for (const Id corner : corners)
    {
      const Point& place = points[layered.PointsBeside[corner]];
      const bool isOfWall = std::find(wall.begin(), wall.end(), face) != wall.end();
      EXPECT_TRUE(
        isOfWall || std::abs(Dot(Difference(place, plane[0]), normal)) <= 1e-9 * Length(normal))
        << face;
    }
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const Id original = layered.OriginalPoints[p];
    EXPECT_TRUE(original == None || points[p] == mesh.Points[original]) << p;
  }
  EXPECT_EQ(StatisticOf(layered, "Prisms"), static_cast<double>(layered.Prisms.size()));
}

LayeredMesh Layered(const TetrahedralMesh& mesh, const LayerParameters& parameters,
  const std::vector<Id>& regions = {}, std::vector<Id> wall = {})
{
  Monitor monitor;
  wall = wall.empty() ? Boundary(mesh) : wall;
  return MakeBoundaryLayers(mesh, regions, wall, {}, parameters, monitor);
}

/** A refined cube of edge 400. */
TetrahedralMesh Cube()
{
  Monitor monitor;
  const RefinedMesh refined =
    RefineTetrahedra(testtetrahedra::EvenGrid(4), {}, RefinementParameters(), monitor);
  return ConnectCells(refined.Points, refined.Cells);
}

std::string MessageOf(const TetrahedralMesh& mesh, const LayerParameters& parameters,
  const std::vector<Id>& regions = {}, const std::vector<Id>& wall = {})
{
  try
  {
    Layered(mesh, parameters, regions, wall);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}
} // namespace

class LayersOfRandomMeshes : public testing::TestWithParam<unsigned>
{
};

TEST_P(LayersOfRandomMeshes, FillTheSolidBehindItsSurface)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 4);
  const TetrahedralMesh part =
    testtetrahedra::Part(grid, testtetrahedra::RandomInside(grid, GetParam()));
  for (const double height : { 0.5, 10.0, 1e4 })
  {
    ExpectLaws(part, {}, Layered(part, { 3, height, 1.2 }));
  }
}

TEST_P(LayersOfRandomMeshes, EndAtTheRestOfTheBoundaryAndAtRegions)
{
  const TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 4);
  std::vector<Id> regions;
  for (const int inside : testtetrahedra::RandomInside(grid, GetParam()))
  {
    regions.push_back(inside);
  }
  std::vector<Id> wall = Boundary(grid);
  std::mt19937 random(GetParam());
  std::shuffle(wall.begin(), wall.end(), random);
  wall.resize(wall.size() / 2);
  ExpectLaws(grid, regions, Layered(grid, { 2, 3, 1.5 }, regions, wall), wall);
  ExpectLaws(grid, {}, Layered(grid, { 2, 3, 1.5 }, {}, wall), wall);
}

TEST_P(LayersOfRandomMeshes, TakeCellsThatAreAllButFlat)
{
  TetrahedralMesh grid = testtetrahedra::Grid(GetParam(), 4);
  ASSERT_GT(testtetrahedra::Flatten(grid, GetParam()), 0);
  ExpectLaws(grid, {}, Layered(grid, { 3, 5, 1.2 }));
}

INSTANTIATE_TEST_SUITE_P(Seeds, LayersOfRandomMeshes, testing::Range(0U, 4U));

TEST(BoundaryLayers, HaveFullHeightInACube)
{
  const TetrahedralMesh cube = Cube();
  const LayeredMesh layered = Layered(cube, { 4, 5, 1.2 });
  ExpectLaws(cube, {}, layered);
  const auto wall = Boundary(cube).size();
  EXPECT_EQ(layered.Prisms.size(), 4 * wall);
  EXPECT_EQ(StatisticOf(layered, "FullHeightShare"), 1);
  EXPECT_EQ(StatisticOf(layered, "MeanHeightShare"), 1);
  EXPECT_EQ(StatisticOf(layered, "ReducedPoints"), 0);
  // The first layer is as high as asked for at each plane of the cube.
  for (std::size_t p = 0; p < layered.Prisms.size(); p += 4)
  {
    const Prism& prism = layered.Prisms[p];
    for (int k = 0; k < 3; ++k)
    {
      const Point& outer = layered.Points[prism[k]];
      const Point& inner = layered.Points[prism[k + 3]];
      for (int axis = 0; axis < 3; ++axis)
      {
        if (outer[axis] == 0)
        {
          EXPECT_GE(inner[axis], 4.9);
          EXPECT_LE(inner[axis], 7.6);
        }
      }
    }
  }
}

TEST(BoundaryLayers, LeaveGoodCellsBehindThickLayers)
{
  // Layers of six tenths of a cube's half width, twice to three times as long as edges are. Where
  // the last ones end is chance.
  double sum = 0;
  const std::vector<double> lengths = { 60, 55, 50, 45, 40 };
  for (const double length : lengths)
  {
    Monitor monitor;
    RefinementParameters parameters;
    parameters.Sizes.EdgeLength = length;
    parameters.Surface = SurfaceTreatment::Remeshed;
    const RefinedMesh refined =
      RefineTetrahedra(testtetrahedra::EvenGrid(4), {}, parameters, monitor);
    const TetrahedralMesh cube = ConnectCells(refined.Points, refined.Cells);
    const LayeredMesh layered = Layered(cube, { 5, 16, 1.2 });
    ExpectLaws(cube, {}, layered);
    EXPECT_GT(StatisticOf(layered, "MeanHeightShare"), 0.8);
    const MeshQuality quality =
      QualityOfMesh(layered.Points, layered.Tetrahedra, monitor, { "measuring", 0, 1 });
    EXPECT_GT(quality.DihedralAngle1Percent, 12) << length;
    sum += quality.DihedralAngle1Percent;
  }
  EXPECT_GT(sum / static_cast<double>(lengths.size()), 18);
}

TEST(BoundaryLayers, LeaveAThirdOfAGap)
{
  const TetrahedralMesh grid = testtetrahedra::EvenGrid(4);
  const TetrahedralMesh plate =
    testtetrahedra::Part(grid, testtetrahedra::Cubes(grid, [](int, int, int z) { return z == 0; }));
  const LayeredMesh layered = Layered(plate, { 1, 1000, 1 });
  ExpectLaws(plate, {}, layered);
  EXPECT_EQ(StatisticOf(layered, "FullHeightShare"), 0);
  EXPECT_EQ(StatisticOf(layered, "NarrowPoints"), StatisticOf(layered, "WallPoints"));
  EXPECT_EQ(StatisticOf(Layered(plate, { 1, 10, 1 }), "NarrowPoints"), 0);
  EXPECT_GT(layered.Prisms.size(), 0U);
  for (const Prism& prism : layered.Prisms)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_LE(std::abs(layered.Points[prism[k]][2] - layered.Points[prism[k + 3]][2]), 34);
    }
  }
}

namespace
{
/** The faces of a cube's boundary whose corners are all such. */
template <class IsOf>
std::vector<Id> FacesWhere(const TetrahedralMesh& mesh, const IsOf& isOf)
{
  std::vector<Id> faces;
  for (const Id face : Boundary(mesh))
  {
    const auto corners = CornersOf(mesh.Points, FaceOf(mesh.Cells[face / 4], face % 4));
    if (std::all_of(corners.begin(), corners.end(), isOf))
    {
      faces.push_back(face);
    }
  }
  return faces;
}
} // namespace

TEST(BoundaryLayers, GoOnAlongPlanes)
{
  // At the bottom of a cube, beside four planes, two of which meet at its corners.
  const TetrahedralMesh cube = Cube();
  const std::vector<Id> bottom = FacesWhere(cube, [](const Point& p) { return p[2] == 0; });
  const LayeredMesh layered = Layered(cube, { 3, 5, 1.2 }, {}, bottom);
  ExpectLaws(cube, {}, layered, bottom);
  EXPECT_EQ(layered.Prisms.size(), 3 * bottom.size());
  EXPECT_EQ(layered.Pyramids.size(), 0U);
  EXPECT_EQ(StatisticOf(layered, "FullHeightShare"), 1);
  EXPECT_EQ(StatisticOf(layered, "BarePoints"), 0);
  EXPECT_EQ(StatisticOf(layered, "EndPoints"), 0);
  ASSERT_GT(layered.Sides.size(), 0U);
  for (const LayerSide& side : layered.Sides)
  {
    ASSERT_NE(side.Corners[3], None);
    const auto beside = CornersOf(cube.Points, FaceOf(cube.Cells[side.Face / 4], side.Face % 4));
    const Point normal = NormalOf(beside[0], beside[1], beside[2]);
    const std::vector<Point>& points = layered.Points;
    const Point ofSide =
      NormalOf(points[side.Corners[0]], points[side.Corners[1]], points[side.Corners[2]]);
    EXPECT_NEAR(Dot(normal, ofSide), Length(normal) * Length(ofSide), 1e-9 * Length(normal));
  }
}

TEST(BoundaryLayers, EndInPyramidsAndTetrahedra)
{
  // On one half of a plane: beside it the rest of this plane, which leaves no way in.
  const TetrahedralMesh cube = Cube();
  const std::vector<Id> wall =
    FacesWhere(cube, [](const Point& p) { return p[2] == 0 && p[0] <= 200; });
  const LayeredMesh layered = Layered(cube, { 3, 5, 1.2 }, {}, wall);
  ExpectLaws(cube, {}, layered, wall);
  EXPECT_GT(layered.Prisms.size(), 0U);
  EXPECT_GT(layered.Pyramids.size(), 0U);
  EXPECT_GT(StatisticOf(layered, "LayerTetrahedra"), 0);
  EXPECT_GT(StatisticOf(layered, "BarePoints"), 0);
  EXPECT_EQ(StatisticOf(layered, "EndPoints"), StatisticOf(layered, "BarePoints"));
  EXPECT_LT(StatisticOf(layered, "FullHeightShare"), 1);
}

TEST(BoundaryLayers, EndWhereTagsMeetInAPlane)
{
  const TetrahedralMesh cube = Cube();
  const std::vector<Id> bottom = FacesWhere(cube, [](const Point& p) { return p[2] == 0; });
  std::vector<std::array<Id, 4>> labels(cube.Cells.size(), { { 0, 0, 0, 0 } });
  for (const Id face : FacesWhere(cube, [](const Point& p) { return p[0] == 0 && p[1] <= 200; }))
  {
    labels[face / 4][face % 4] = 1;
  }
  Monitor monitor;
  const LayeredMesh layered = MakeBoundaryLayers(cube, {}, bottom, labels, { 3, 5, 1.2 }, monitor);
  ExpectLaws(cube, {}, layered, bottom);
  EXPECT_EQ(StatisticOf(layered, "BarePoints"), 1);
}

TEST(BoundaryLayers, AreTheSameOnAnyNumberOfThreadsAndAtAnySize)
{
  const TetrahedralMesh cube = Cube();
  const LayeredMesh one = [&]
  {
    const testthreads::Allowed allowed(1);
    return Layered(cube, { 3, 20, 1.2 });
  }();
  const testthreads::Allowed allowed(4);
  const LayeredMesh four = Layered(cube, { 3, 20, 1.2 });
  EXPECT_EQ(one.Points, four.Points);
  EXPECT_EQ(one.Tetrahedra, four.Tetrahedra);
  EXPECT_EQ(one.Pyramids, four.Pyramids);
  EXPECT_EQ(one.Prisms, four.Prisms);
  EXPECT_EQ(one.OriginalCells, four.OriginalCells);
  EXPECT_EQ(one.CellsOfPoints, four.CellsOfPoints);
  for (const int exponent : { -600, 600 })
  {
    TetrahedralMesh scaled = cube;
    scaled.Points = ScaledPoints(cube.Points, exponent);
    const LayeredMesh layered = Layered(scaled, { 3, std::ldexp(20, exponent), 1.2 });
    EXPECT_EQ(layered.Prisms.size(), one.Prisms.size());
    EXPECT_EQ(StatisticOf(layered, "FullHeightShare"), StatisticOf(one, "FullHeightShare"));
  }
}

TEST(BoundaryLayers, NameWhatIsWrong)
{
  const TetrahedralMesh grid = testtetrahedra::EvenGrid(1);
  EXPECT_NE(MessageOf(grid, { 0, 1, 1 }).find("layers is 0"), std::string::npos);
  EXPECT_NE(MessageOf(grid, { 1, 0, 1 }).find("height"), std::string::npos);
  EXPECT_NE(MessageOf(grid, { 1, std::nan(""), 1 }).find("height"), std::string::npos);
  EXPECT_NE(MessageOf(grid, { 1, 1, -1 }).find("growth"), std::string::npos);
  Id inner = 0;
  while (grid.Neighbors[inner / 4][inner % 4] == None)
  {
    ++inner;
  }
  const auto messageOf = [&](const std::vector<Id>& regions, const std::vector<Id>& wall) {
    return MessageOf(grid, { 1, 1, 1 }, regions, wall);
  };
  EXPECT_NE(messageOf({}, { inner }).find("between two cells"), std::string::npos);
  EXPECT_NE(messageOf({}, { -1 }).find("face -1 of the wall"), std::string::npos);
  const Id behind = 4 * grid.NumberOfCells();
  EXPECT_NE(messageOf({}, { behind }).find("of the wall is none"), std::string::npos);
  const Id outer = Boundary(grid).front();
  EXPECT_NE(messageOf({}, { outer, outer }).find("twice"), std::string::npos);
  EXPECT_NE(messageOf({ 0 }, { outer }).find("1 regions"), std::string::npos);
  const LayerParameters many = { std::numeric_limits<int>::max(), 1, 1 };
  EXPECT_NE(MessageOf(grid, many).find("layers make"), std::string::npos);
}

TEST(LayerColumns, GrowByTheirFactor)
{
  const std::vector<double> fractions = FractionsOfLayers(3, 2);
  ASSERT_EQ(fractions.size(), 4U);
  EXPECT_EQ(fractions[0], 0);
  EXPECT_DOUBLE_EQ(fractions[1], 1.0 / 7);
  EXPECT_DOUBLE_EQ(fractions[2], 3.0 / 7);
  EXPECT_EQ(fractions[3], 1);
}
