// SPDX-License-Identifier: GPL-3.0-or-later
#include "Layers/PlanarLayers.h"

#include "Common/Error.h"
#include "Common/PointPredicates.h"
#include "Planar/PlanarOutputs.h"
#include "Planar/SegmentTriangles.h"
#include "Refine/RefineTriangles.h"
#include "Support/PlanarLaws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace
{
using namespace testplanar;

/** Triangles with a label on each edge that constrains them. */
struct Sheet
{
  insideout::Plane Plane;
  std::vector<PlanarPoint> Points;
  PlanarMesh Mesh;
};

/** Refined triangles inside a curve; labels are those of its segments. Without a length these
 * stay. Points where the inside touches itself may be split. */
Sheet SheetOf(const SegmentSoup& soup, const std::vector<Id>& labels, double edgeLength,
  bool splitsPoints = false)
{
  Monitor monitor;
  PlanarHull hull = MeshPlanarHull(soup, FindPlane(soup.Points), {}, monitor);
  const auto inside =
    SegmentTriangles(hull.Curve, hull.Mesh, hull.Plane, hull.W, {}, {}, {}, monitor).Inside;
  if (splitsPoints)
  {
    SplitPoints(hull.Curve, hull.Mesh, inside, monitor, { "", 0, 1 });
  }
  RefinementParameters parameters;
  parameters.Surface = edgeLength > 0 ? SurfaceTreatment::Split : SurfaceTreatment::Kept;
  parameters.Sizes.EdgeLength = edgeLength;
  const RefinedTriangles refined =
    RefineTriangles(hull.Curve, hull.Mesh, inside, hull.Plane, parameters, monitor);
  Sheet sheet{ hull.Plane, refined.Curve.Points, refined.Mesh };
  for (std::size_t c = 0; c < sheet.Mesh.Cells.size(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      Id& segment = sheet.Mesh.Segments[c][k];
      segment = segment != None              ? labels[SourceOfSegment(refined.Curve, segment, 1)]
        : sheet.Mesh.Neighbors[c][k] == None ? 0
                                             : None;
    }
  }
  return sheet;
}

std::vector<Id> EdgesWith(const Sheet& sheet, const std::set<Id>& labels)
{
  std::vector<Id> wall;
  for (Id edge = 0; edge < 3 * sheet.Mesh.NumberOfCells(); ++edge)
  {
    if (sheet.Mesh.Neighbors[edge / 3][edge % 3] == None &&
      labels.count(sheet.Mesh.Segments[edge / 3][edge % 3]) > 0)
    {
      wall.push_back(edge);
    }
  }
  return wall;
}

PlanarLayeredMesh Layered(
  const Sheet& sheet, const std::vector<Id>& wall, int layers, double first, double growth = 1.2)
{
  Monitor monitor;
  const LayerParameters parameters{ layers, std::ldexp(first, -sheet.Plane.Exponent), growth };
  return MakePlanarLayers(sheet.Points, sheet.Mesh, wall, sheet.Plane, parameters, monitor);
}

double ValueOf(const PlanarLayeredMesh& mesh, const std::string& name)
{
  for (const auto& [found, value] : mesh.Statistics)
  {
    if (found == name)
    {
      return value;
    }
  }
  ADD_FAILURE() << "no statistic " << name;
  return 0;
}

double AreaOfCells(const std::vector<PlanarPoint>& points,
  const std::vector<std::vector<Id>>& cells, const PlanarMetric& metric)
{
  double area = 0;
  for (const std::vector<Id>& cell : cells)
  {
    for (std::size_t k = 2; k < cell.size(); ++k)
    {
      area += AreaOf(points[cell[0]], points[cell[k - 1]], points[cell[k]], metric);
    }
  }
  return area;
}

template <typename Cells>
std::vector<std::vector<Id>> ListsOf(const Cells& cells)
{
  std::vector<std::vector<Id>> lists;
  for (const auto& cell : cells)
  {
    lists.emplace_back(cell.begin(), cell.end());
  }
  return lists;
}

std::vector<std::vector<Id>> CellsOf(const PlanarLayeredMesh& mesh)
{
  std::vector<std::vector<Id>> cells = ListsOf(mesh.Triangles);
  const std::vector<std::vector<Id>> quads = ListsOf(mesh.Quads);
  cells.insert(cells.end(), quads.begin(), quads.end());
  return cells;
}

/** The broken laws of layers in a plane, empty for none. */
std::string Broken(const Sheet& sheet, const std::vector<Id>& wall, const PlanarLayeredMesh& made)
{
  std::string broken;
  const std::vector<std::vector<Id>> cells = CellsOf(made);
  std::map<Segment, int> edges;
  for (const std::vector<Id>& cell : cells)
  {
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
      const Id a = cell[k], b = cell[(k + 1) % cell.size()], c = cell[(k + 2) % cell.size()];
      if (Orient2D(made.Points[a], made.Points[b], made.Points[c]) <= 0)
      {
        broken += "a cell is not positive; ";
      }
      edges[{ { a, b } }] += 1;
    }
  }
  std::set<Segment> boundary;
  for (const auto& [ends, count] : edges)
  {
    broken += count > 1 ? "an edge has two cells on one side; " : "";
    if (edges.count({ { ends[1], ends[0] } }) == 0)
    {
      boundary.insert(ends);
    }
  }
  std::set<Segment> told;
  for (const PlanarLayeredMesh::BoundaryEdge& edge : made.Boundary)
  {
    told.insert(edge.Ends);
    broken += sheet.Mesh.Neighbors[edge.Edge / 3][edge.Edge % 3] != None
      ? "an edge of the boundary is from within; "
      : "";
  }
  broken += told != boundary || told.size() != made.Boundary.size() ? "another boundary; " : "";

  std::set<std::pair<PlanarPoint, PlanarPoint>> places;
  for (const Segment& ends : boundary)
  {
    places.insert({ made.Points[ends[0]], made.Points[ends[1]] });
  }
  for (const Id edge : wall)
  {
    const Segment ends = EdgeOf(sheet.Mesh.Cells[edge / 3], edge % 3);
    broken += places.count({ sheet.Points[ends[0]], sheet.Points[ends[1]] }) == 0
      ? "an edge of the wall is gone; "
      : "";
  }
  const double before = AreaOfCells(sheet.Points, ListsOf(sheet.Mesh.Cells), sheet.Plane.Metric);
  const double after = AreaOfCells(made.Points, cells, sheet.Plane.Metric);
  broken += std::abs(after - before) > 1e-13 * before ? "another area; " : "";
  for (std::size_t p = 0; p < made.Points.size(); ++p)
  {
    const Id original = made.OriginalPoints[p];
    broken += original != None && made.Points[p] != sheet.Points[original]
      ? "a point of the input has moved; "
      : "";
  }
  std::set<Id> used;
  for (const std::vector<Id>& cell : cells)
  {
    used.insert(cell.begin(), cell.end());
  }
  broken += used.size() != made.Points.size() ? "a point is of no cell; " : "";
  broken += made.Layers.size() != cells.size() || made.OriginalCells.size() != cells.size() ||
      made.CellsOfPoints.size() != made.Points.size()
    ? "a list is too short; "
    : "";
  return broken;
}

/** A channel with a round obstacle; labels 0 walls, 1 inlet and outlet, 2 the obstacle. */
SegmentSoup Channel(std::vector<Id>& labels, double radius, double y)
{
  SegmentSoup soup;
  soup.Points = { { 0, 0, 0 }, { 8, 0, 0 }, { 8, 2, 0 }, { 0, 2, 0 } };
  soup.Segments = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
  labels = { 0, 1, 0, 1 };
  constexpr int sides = 40;
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2 * std::acos(-1) * i / sides;
    soup.Points.push_back({ 2 + radius * std::cos(angle), y + radius * std::sin(angle), 0 });
    soup.Segments.push_back({ 4 + (i + 1) % sides, 4 + i });
    labels.push_back(2);
  }
  return soup;
}

TEST(PlanarLayers, HaveFullHeightInAChannelAndGoOnAlongInletAndOutlet)
{
  std::vector<Id> labels;
  const Sheet sheet = SheetOf(Channel(labels, 0.4, 1), labels, 0.2);
  const std::vector<Id> wall = EdgesWith(sheet, { 0, 2 });
  const PlanarLayeredMesh made = Layered(sheet, wall, 4, 0.02);
  EXPECT_EQ(Broken(sheet, wall, made), "");
  EXPECT_EQ(ValueOf(made, "FullHeightShare"), 1);
  EXPECT_EQ(ValueOf(made, "BarePoints"), 0);
  EXPECT_EQ(made.Quads.size(), 4 * wall.size());
  EXPECT_EQ(ValueOf(made, "LayerTriangles"), 0);
  EXPECT_GT(ValueOf(made, "MinAngle"), 15);
  const double all = 0.02 * (1 + 1.2 + 1.44 + 1.728);
  double least = 1;
  double most = 0;
  for (const Quad& quad : made.Quads)
  {
    const double height = sheet.Plane.Metric.Distance(made.Points[quad[0]], made.Points[quad[3]]);
    least = std::min(least, std::ldexp(height, sheet.Plane.Exponent));
    most = std::max(most, std::ldexp(height, sheet.Plane.Exponent));
  }
  EXPECT_NEAR(least, 0.02, 1e-4); // at 40 sides directions are 4.5 degrees off a normal
  EXPECT_NEAR(most, 0.02 * 1.728, 2e-4);
  // The layers' sides are on inlet and outlet, and their points there are gone.
  std::vector<double> heights;
  for (const PlanarPoint& p : made.Points)
  {
    if (p[0] == 0)
    {
      heights.push_back(std::ldexp(p[1], sheet.Plane.Exponent));
    }
  }
  std::sort(heights.begin(), heights.end());
  ASSERT_GT(heights.size(), 10u);
  EXPECT_NEAR(heights[4], all, 1e-12);
  EXPECT_GT(heights[5], all + 0.04);
}

TEST(PlanarLayers, KeepTheLawsOnRandomWalksWithAnyWall)
{
  int quads = 0;
  int bare = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const SegmentSoup soup = RandomWalk(seed, 9, 10 + static_cast<int>(seed) / 2, true);
    std::mt19937 random(seed);
    std::vector<Id> labels;
    for (std::size_t s = 0; s < soup.Segments.size(); ++s)
    {
      labels.push_back(static_cast<Id>(random() % 3));
    }
    const Sheet sheet = SheetOf(soup, labels, seed % 2 == 0 ? 0.7 : 0, seed % 4 > 1);
    if (sheet.Mesh.Cells.empty())
    {
      continue;
    }
    const std::vector<Id> wall =
      EdgesWith(sheet, seed % 3 == 0 ? std::set<Id>{ 0, 1, 2 } : std::set<Id>{ 0 });
    const PlanarLayeredMesh made =
      Layered(sheet, wall, 1 + static_cast<int>(seed % 4), 0.01 * (1 + seed % 17), 1.3);
    EXPECT_EQ(Broken(sheet, wall, made), "") << "seed " << seed;
    quads += static_cast<int>(made.Quads.size());
    bare += static_cast<int>(ValueOf(made, "BarePoints"));
  }
  EXPECT_GT(quads, 1000);
  EXPECT_GT(bare, 10);
}

/** The wall's edges are long: no direction from its points meets the obstacle, which is within the
 * layers of the requested height or crosses their border. */
TEST(PlanarLayers, NeitherContainNorCrossWhatLiesBetweenPointsOfTheWall)
{
  std::vector<Id> labels;
  for (const double y : { 0.5, 0.28, 0.15, 0.06, 0.02, 0.011 })
  {
    const Sheet sheet = SheetOf(Channel(labels, 0.01, y), labels, 0);
    const std::vector<Id> wall = EdgesWith(sheet, { 0 });
    ASSERT_EQ(wall.size(), 2u);
    const PlanarLayeredMesh made = Layered(sheet, wall, 3, 0.1, 1);
    EXPECT_EQ(Broken(sheet, wall, made), "") << y;
    EXPECT_EQ(ValueOf(made, "NarrowPoints"), 0) << y;
    EXPECT_EQ(ValueOf(made, "ReducedPoints") + ValueOf(made, "BarePoints"), y > 0.31 ? 0 : 2) << y;
  }
}

TEST(PlanarLayers, TakeAThirdOfAGapEach)
{
  std::vector<Id> labels;
  const Sheet sheet = SheetOf(Channel(labels, 0.9, 1), labels, 0.05); // gaps of 0.1
  const std::vector<Id> wall = EdgesWith(sheet, { 0, 2 });
  const PlanarLayeredMesh made = Layered(sheet, wall, 2, 0.05, 1);
  EXPECT_EQ(Broken(sheet, wall, made), "");
  EXPECT_GT(ValueOf(made, "NarrowPoints"), 5);
  EXPECT_GT(ValueOf(made, "FullHeightShare"), 0.5);
  double highest = 0; // of two layers in the gap above the obstacle
  for (const Quad& quad : made.Quads)
  {
    const double x = std::ldexp(made.Points[quad[0]][0], sheet.Plane.Exponent);
    const double height = sheet.Plane.Metric.Distance(made.Points[quad[0]], made.Points[quad[3]]);
    highest = std::abs(x - 2) < 0.02 ? std::max(highest, std::ldexp(height, sheet.Plane.Exponent))
                                     : highest;
  }
  EXPECT_NEAR(highest, 0.1 / 3 / 2, 0.002);
}

/** A line within the solid that counts for nothing, from the wall on: heights end at it. */
TEST(PlanarLayers, EndAtLinesWithin)
{
  SegmentSoup soup = Lines({ { 0, 0 }, { 4, 0 }, { 4, 2 }, { 0, 2 }, { 1, 0 }, { 1, 1 } },
    { { 0, 4, 1, 2, 3, 0 }, { 4, 5 } });
  soup.NonParticipating.assign(soup.Segments.size(), 0);
  soup.NonParticipating.back() = 1;
  const std::vector<Id> labels = { 0, 0, 0, 0, 0, 1 };
  const Sheet sheet = SheetOf(soup, labels, 0.2);
  const std::vector<Id> wall = EdgesWith(sheet, { 0 });
  const PlanarLayeredMesh made = Layered(sheet, wall, 3, 0.02);
  EXPECT_EQ(Broken(sheet, wall, made), "");
  EXPECT_EQ(ValueOf(made, "BarePoints"), 1);
  EXPECT_EQ(ValueOf(made, "LayerTriangles"), 2 * 3);
  // Its edges are edges of cells still.
  const double x = std::ldexp(1, -sheet.Plane.Exponent);
  double length = 0;
  for (const std::vector<Id>& cell : CellsOf(made))
  {
    for (std::size_t k = 0; k < cell.size(); ++k)
    {
      const PlanarPoint& a = made.Points[cell[k]];
      const PlanarPoint& b = made.Points[cell[(k + 1) % cell.size()]];
      length += a[0] == x && b[0] == x && a[1] < b[1] ? b[1] - a[1] : 0;
    }
  }
  EXPECT_EQ(std::ldexp(length, sheet.Plane.Exponent), 1);
}

TEST(PlanarLayers, AreTheSameInATiltedPlaneByItsMetric)
{
  std::vector<Id> labels;
  SegmentSoup soup = Channel(labels, 0.4, 1);
  for (Point& p : soup.Points)
  {
    p = { { p[0] * 0.6, p[1], p[0] * 0.8 } };
  }
  const Sheet sheet = SheetOf(soup, labels, 0.2);
  ASSERT_FALSE(sheet.Plane.Metric.IsPerpendicular());
  const std::vector<Id> wall = EdgesWith(sheet, { 0, 2 });
  const PlanarLayeredMesh made = Layered(sheet, wall, 4, 0.02);
  EXPECT_EQ(Broken(sheet, wall, made), "");
  EXPECT_EQ(ValueOf(made, "FullHeightShare"), 1);
}

TEST(PlanarLayers, RefuseHeightsThatAreNone)
{
  std::vector<Id> labels;
  const Sheet sheet = SheetOf(Channel(labels, 0.4, 1), labels, 0);
  const std::vector<Id> wall = EdgesWith(sheet, { 0 });
  for (const double height : { 0.0, -1.0, std::nan("") })
  {
    EXPECT_THROW(Layered(sheet, wall, 2, height), Error) << height;
  }
  EXPECT_THROW(Layered(sheet, wall, 0, 0.1), Error);
  EXPECT_THROW(Layered(sheet, wall, 400, 0.1, 10), Error);
}

TEST(PlanarLayers, RefuseTrianglesThatOverlap)
{
  std::vector<Id> labels;
  Sheet sheet = SheetOf(Channel(labels, 0.4, 1), labels, 0);
  const std::vector<Id> wall = EdgesWith(sheet, { 2 });
  const Id first = static_cast<Id>(sheet.Points.size());
  for (const Point& p : { Point{ 6, 1, 0 }, Point{ 7, 1, 0 }, Point{ 6, 1.5, 0 } })
  {
    sheet.Points.push_back(sheet.Plane.Project(p));
  }
  sheet.Mesh.Cells.push_back({ { first, first + 1, first + 2 } });
  sheet.Mesh.Neighbors.push_back({ { None, None, None } });
  sheet.Mesh.Segments.push_back({ { 0, 0, 0 } });
  try
  {
    Layered(sheet, wall, 2, 0.02);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::SelfIntersecting);
    EXPECT_NE(std::string(error.what()).find("triangles overlap at point "), std::string::npos)
      << error.what();
  }
}

TEST(PlanarLayers, EndWhereTheMonitorSaysSo)
{
  struct Stopping : Monitor
  {
    bool Continue(const char*, double) override { return --this->Left > 0; }
    int Left;
    explicit Stopping(int left)
      : Left(left)
    {
    }
  };
  std::vector<Id> labels;
  const Sheet sheet = SheetOf(Channel(labels, 0.4, 1), labels, 0.2);
  const std::vector<Id> wall = EdgesWith(sheet, { 0 });
  for (const int left : { 1, 2, 4, 8 })
  {
    Stopping monitor(left);
    EXPECT_THROW(
      MakePlanarLayers(sheet.Points, sheet.Mesh, wall, sheet.Plane, { 2, 0.001, 1 }, monitor),
      Error);
  }
}
} // namespace
