// SPDX-License-Identifier: GPL-3.0-or-later
#include "Quality/QualityOfMesh.h"

#include "Common/Vectors.h"
#include "Support/AllowedThreads.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestTetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;

constexpr ProgressRange Whole = { "test", 0, 1 };

MeshQuality QualityOf(const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  Monitor silent;
  return QualityOfMesh(points, cells, silent, Whole);
}

std::vector<SharpEdge> SharpEdges(
  const std::vector<Point>& points, const std::vector<Tetrahedron>& cells, double limit)
{
  Monitor silent;
  return SharpBoundaryEdges(
    cells, QualityOfCells(points, cells, silent, Whole), points.size(), limit);
}

/** Cells around the z axis, each from one of these directions to the next, in degrees. */
struct Wedge
{
  std::vector<Point> Points = { { 0, 0, 0 }, { 0, 0, 1 } };
  std::vector<Tetrahedron> Cells;

  explicit Wedge(const std::vector<double>& directions) { this->Add(directions); }

  void Add(const std::vector<double>& directions)
  {
    const Id first = static_cast<Id>(this->Points.size());
    for (const double direction : directions)
    {
      const double angle = direction * M_PI / 180;
      this->Points.push_back({ { std::cos(angle), std::sin(angle), 0 } });
    }
    for (Id k = first; k + 1 < static_cast<Id>(this->Points.size()); ++k)
    {
      this->Cells.push_back({ { 0, k, k + 1, 1 } });
    }
  }
};

/** The angles at edges of the boundary by their ends, all that are there added up. */
std::map<Edge, double> AnglesAtBoundary(
  const std::vector<Point>& points, const std::vector<Tetrahedron>& cells)
{
  std::map<Triangle, int> faces;
  for (const Tetrahedron& cell : cells)
  {
    for (int k = 0; k < 4; ++k)
    {
      Triangle face = FaceOf(cell, k);
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
  }
  std::map<Edge, double> angles;
  for (const auto& [face, count] : faces)
  {
    for (int k = 0; count == 1 && k < 3; ++k)
    {
      angles[EdgeBetween(face[k], face[(k + 1) % 3])] = 0;
    }
  }
  for (const Tetrahedron& cell : cells)
  {
    const CellQuality quality = QualityOfCell(points, cell);
    for (std::size_t e = 0; e < TetrahedronEdges.size(); ++e)
    {
      const auto found =
        angles.find(EdgeBetween(cell[TetrahedronEdges[e][0]], cell[TetrahedronEdges[e][1]]));
      if (found != angles.end())
      {
        found->second += quality.DihedralAngles[e];
      }
    }
  }
  return angles;
}
} // namespace

TEST(QualityOfMesh, SumsUpTheCells)
{
  TetrahedralMesh mesh = Grid(3, 5);
  testtetrahedra::Squeeze(mesh, 1, 0.1);
  const MeshQuality found = QualityOf(mesh.Points, mesh.Cells);

  std::vector<double> angles;
  std::vector<double> ratios;
  std::vector<double> meanRatios;
  std::array<std::int64_t, 36> histogram = {};
  Id under10 = 0;
  Id under5 = 0;
  for (const Tetrahedron& cell : mesh.Cells)
  {
    const CellQuality quality = QualityOfCell(mesh.Points, cell);
    angles.insert(angles.end(), quality.DihedralAngles.begin(), quality.DihedralAngles.end());
    ratios.push_back(quality.RadiusEdgeRatio);
    meanRatios.push_back(quality.MeanRatio);
    under10 += quality.MinDihedralAngle() < 10;
    under5 += quality.MinDihedralAngle() < 5;
  }
  for (const double angle : angles)
  {
    ++histogram[static_cast<std::size_t>(angle / 5)];
  }
  std::sort(angles.begin(), angles.end());
  std::sort(ratios.begin(), ratios.end());
  std::sort(meanRatios.begin(), meanRatios.end());
  EXPECT_EQ(found.Cells, static_cast<Id>(mesh.Cells.size()));
  EXPECT_EQ(found.Histogram, histogram);
  EXPECT_EQ(found.MinDihedralAngle, angles.front());
  ASSERT_EQ(angles.size(), 4500u);
  EXPECT_EQ(found.DihedralAngle1Percent, angles[44]) << "45 of 4,500 are no greater";
  EXPECT_EQ(found.MaxDihedralAngle, angles.back());
  EXPECT_EQ(found.RadiusEdgeRatio99Percent, ratios[742]) << "743 of 750 are no greater";
  EXPECT_EQ(found.MaxRadiusEdgeRatio, ratios.back());
  EXPECT_EQ(found.MinMeanRatio, meanRatios.front());
  EXPECT_NEAR(found.AverageMeanRatio,
    std::accumulate(meanRatios.begin(), meanRatios.end(), 0.0) / 750, 1e-14);
  EXPECT_EQ(found.CellsUnder10Degrees, under10);
  EXPECT_EQ(found.CellsUnder5Degrees, under5);
  EXPECT_GT(under5, 0);
  EXPECT_GT(under10, under5);
}

TEST(QualityOfMesh, IsTheSameForAnyNumberOfThreads)
{
  TetrahedralMesh mesh = Grid(4, 12);
  testtetrahedra::Squeeze(mesh, 2, 0.02);
  std::vector<Statistics> all;
  for (const int threads : { 1, 2, 8 })
  {
    const testthreads::Allowed allowed(threads);
    Statistics figures;
    AppendQuality(QualityOf(mesh.Points, mesh.Cells), figures, "Before");
    all.push_back(figures);
  }
  EXPECT_EQ(all[1], all[0]);
  EXPECT_EQ(all[2], all[0]);
  EXPECT_EQ(all[0].front().first, "BeforeMinDihedralAngle");
  const auto sharp = std::find_if(all[0].begin(), all[0].end(),
    [](const auto& figure) { return figure.first == "BeforeSurfaceEdgesUnder10Degrees"; });
  ASSERT_NE(sharp, all[0].end());
  EXPECT_GT(sharp->second, 0);
}

TEST(QualityOfMesh, CanBeStopped)
{
  const TetrahedralMesh mesh = Grid(1, 3);
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { QualityOfMesh(mesh.Points, mesh.Cells, monitor, range); });
  EXPECT_GT(reports, 2);
}

TEST(QualityOfMesh, OfNothingIsZero)
{
  Statistics figures;
  AppendQuality(QualityOf({}, {}), figures);
  ASSERT_EQ(figures.size(), 11u);
  for (const auto& [name, value] : figures)
  {
    EXPECT_EQ(value, 0) << name;
  }
}

TEST(QualityOfMesh, CountsAFlatCellWithoutLosingTheOthers)
{
  const std::vector<Point> points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } },
    { { 0, 0, 1 } }, { { 1, 1, 0 } } };
  const MeshQuality found = QualityOf(points, { { { 0, 1, 2, 3 } }, { { 1, 2, 0, 4 } } });
  EXPECT_EQ(found.MinDihedralAngle, 0);
  EXPECT_EQ(found.MaxDihedralAngle, 180);
  EXPECT_EQ(found.MinMeanRatio, 0);
  EXPECT_GT(found.AverageMeanRatio, 0.4);
  EXPECT_TRUE(std::isinf(found.MaxRadiusEdgeRatio));
  EXPECT_EQ(std::accumulate(found.Histogram.begin(), found.Histogram.end(), std::int64_t(0)), 12);
  EXPECT_GT(found.Histogram.back(), 0) << "180 degrees are in the last";
}

TEST(SharpBoundaryEdges, AddUpTheCellsBetweenTwoBoundaryFaces)
{
  const Wedge wedge({ 0, 2, 5, 9 });
  const std::vector<SharpEdge> found = SharpEdges(wedge.Points, wedge.Cells, 10);
  const auto axis = std::find_if(found.begin(), found.end(),
    [](const SharpEdge& edge) {
      return edge.Ends == Edge{ { 0, 1 } };
    });
  ASSERT_NE(axis, found.end());
  EXPECT_NEAR(axis->Angle, 9, 1e-12);
  EXPECT_EQ(found.size(), 1u) << "others are about 45 and 90 degrees";
  EXPECT_TRUE(SharpEdges(wedge.Points, wedge.Cells, 8.9).empty());

  const MeshQuality quality = QualityOf(wedge.Points, wedge.Cells);
  EXPECT_EQ(quality.SurfaceEdgesUnder10Degrees, 1);
  EXPECT_EQ(quality.SurfaceEdgesUnder5Degrees, 0);
  EXPECT_EQ(quality.CellsUnder5Degrees, 3);
}

TEST(SharpBoundaryEdges, CountEachWedgeAtAnEdge)
{
  Wedge wedge({ 0, 2, 4 });
  wedge.Add({ 90, 97 });
  wedge.Add({ 180, 250 });
  std::vector<SharpEdge> found = SharpEdges(wedge.Points, wedge.Cells, 10);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].Angle, 4, 1e-12);
  EXPECT_NEAR(found[1].Angle, 7, 1e-12);
}

TEST(SharpBoundaryEdges, AreNotWithinTheSolid)
{
  std::vector<double> around(181);
  for (std::size_t k = 0; k < around.size(); ++k)
  {
    around[k] = 2.0 * static_cast<double>(k);
  }
  Wedge wedge(around);
  // Close the ring: the last direction is the first.
  wedge.Cells.back()[2] = 2;
  for (const SharpEdge& edge : SharpEdges(wedge.Points, wedge.Cells, 10))
  {
    EXPECT_NE(edge.Ends, (Edge{ { 0, 1 } }));
  }
}

TEST(SharpBoundaryEdges, AreThoseOfAllEdgesOfASurfaceOfTwoFacesEach)
{
  const TetrahedralMesh mesh = Grid(11, 3);
  const std::map<Edge, double> expected = AnglesAtBoundary(mesh.Points, mesh.Cells);
  const std::vector<SharpEdge> found = SharpEdges(mesh.Points, mesh.Cells, 179);
  std::size_t count = 0;
  for (const auto& [ends, angle] : expected)
  {
    count += angle < 179;
  }
  EXPECT_EQ(found.size(), count);
  EXPECT_GT(count, 20u);
  for (const SharpEdge& edge : found)
  {
    ASSERT_EQ(expected.count(edge.Ends), 1u);
    EXPECT_NEAR(edge.Angle, expected.at(edge.Ends), 1e-10);
  }
}

TEST(SharpBoundaryEdges, EndWhereCellsDoNotConform)
{
  // Three cells share the face between directions 3 and 6, so that nobody knows which is next.
  Wedge wedge({ 0, 3, 6 });
  wedge.Points.push_back({ { 0.5, 0.5, 0.5 } });
  wedge.Cells.push_back({ { 0, 1, 3, 5 } });
  EXPECT_TRUE(SharpEdges(wedge.Points, wedge.Cells, 10).empty());
}
