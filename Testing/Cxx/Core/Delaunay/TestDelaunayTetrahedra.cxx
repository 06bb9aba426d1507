// SPDX-License-Identifier: GPL-3.0-or-later
#include "Delaunay/DelaunayTetrahedra.h"

#include "Common/PointPredicates.h"
#include "Common/Team.h"
#include "Delaunay/InsertionOrder.h"
#include "Delaunay/PerturbedSphere.h"
#include "Mesh/MeshCell.h"
#include "Support/AllowedThreads.h"
#include "Support/StopAtEveryReport.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace insideout;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalDelaunay = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel>>>;

constexpr ProgressRange Inserting = { "inserting", 0, 1 };

constexpr int Kinds = 9;

/** Points of one of the kinds, most of which are on common spheres and planes. */
std::vector<Point> PointsOfKind(int kind, unsigned seed, int count)
{
  std::mt19937 random(seed);
  const auto whole = [&](unsigned below) { return static_cast<double>(random() % below); };
  const auto share = [&] { return random() / 4294967296.0; };
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < count)
  {
    const double angle = whole(12) * 0.5235987755982988;
    const double north = share() * 2 - 1;
    const double east = share() * 6.283185307179586;
    const double across = std::sqrt(1 - north * north);
    const std::array<Point, Kinds> kinds = { {
      { { whole(7), whole(7), whole(7) } },                            // a grid, often taken twice
      { { share(), share(), share() } },                               // anywhere
      { { std::cos(angle), std::sin(angle), whole(10) } },             // a prism
      { { across * std::cos(east), across * std::sin(east), north } }, // a ball
      { { whole(30), whole(30), random() % 40 ? 0.0 : 1.0 } },         // most of them in a plane
      { { share() * 1e-70, share() * 1e-60, share() * 1e-65 } },       // tiny
      { { 1 + share() * 0x1p-40, 2 + share() * 0x1p-40, whole(2) } },  // far away
      { { share() * 1e100, share() * 1e120, share() * 1e110 } },       // huge
      { { share() * (whole(9) + 1e-9), whole(2) * 1e-9,
        share() * (whole(2) + 1e-12) } }, // of all sizes
    } };
    points.push_back(kinds[static_cast<std::size_t>(kind)]);
  }
  return points;
}

DelaunayTetrahedra DelaunayOf(const std::vector<Point>& points)
{
  Monitor monitor;
  return DelaunayTetrahedra(points, MostNumberedCells, monitor, Inserting);
}

/** Cells by their points, ascending. */
std::vector<Tetrahedron> Sorted(std::vector<Tetrahedron> cells)
{
  for (Tetrahedron& cell : cells)
  {
    std::sort(cell.begin(), cell.end());
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

std::vector<Tetrahedron> CellsByCgal(const std::vector<Point>& points)
{
  CgalDelaunay delaunay;
  delaunay.infinite_vertex()->info() = static_cast<Id>(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    const std::size_t before = delaunay.number_of_vertices();
    const auto vertex = delaunay.insert(Kernel::Point_3(points[p][0], points[p][1], points[p][2]));
    if (delaunay.number_of_vertices() > before)
    {
      vertex->info() = static_cast<Id>(p);
    }
  }
  std::vector<Tetrahedron> cells;
  for (const auto cell : delaunay.all_cell_handles())
  {
    cells.push_back({ { cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
      cell->vertex(3)->info() } });
  }
  return Sorted(std::move(cells));
}

/** Expect positive cells that know their neighbors. @return their corners */
std::vector<Tetrahedron> ExpectSoundCells(
  const std::vector<Point>& points, const DelaunayTetrahedra& delaunay)
{
  const Id infinite = static_cast<Id>(points.size());
  std::vector<Tetrahedron> cells;
  for (Id id = 0; id < delaunay.NumberOfCells(); ++id)
  {
    const DelaunayTetrahedra::Cell cell = delaunay.At(id);
    cells.push_back(cell.Corners);
    if (cell.Corners[3] != infinite)
    {
      EXPECT_EQ(Orient3D(points, cell.Corners), 1);
    }
    for (int k = 0; k < 4; ++k)
    {
      const DelaunayTetrahedra::Cell neighbor = delaunay.At(cell.Neighbors[k]);
      const auto back = std::find(neighbor.Neighbors.begin(), neighbor.Neighbors.end(), id);
      EXPECT_NE(back, neighbor.Neighbors.end());
      Triangle face = FaceAcross(cell.Corners, k);
      std::sort(face.begin(), face.end());
      bool isShared = false;
      for (int j = 0; j < 4; ++j)
      {
        Triangle other = FaceAcross(neighbor.Corners, j);
        std::sort(other.begin(), other.end());
        isShared = isShared || (other == face && neighbor.Neighbors[j] == id);
      }
      EXPECT_TRUE(isShared);
    }
  }
  return cells;
}

/** Points on two lines that pass each other: each pair of neighbors on one has a cell with each
 * pair on the other. */
std::vector<Point> TwoLines(int count)
{
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ { static_cast<double>(i), 0, 0 } });
    points.push_back({ { 0, static_cast<double>(i), 1000 } });
  }
  return points;
}
} // namespace

TEST(DelaunayTetrahedra, AreThoseOfCgal)
{
  for (int kind = 0; kind < Kinds; ++kind)
  {
    for (unsigned seed = 1; seed <= 8; ++seed)
    {
      const std::vector<Point> points = PointsOfKind(kind, seed, 10 + 40 * static_cast<int>(seed));
      EXPECT_EQ(Sorted(ExpectSoundCells(points, DelaunayOf(points))), CellsByCgal(points))
        << "kind " << kind << ", seed " << seed;
    }
  }
}

TEST(DelaunayTetrahedra, AreThoseOfCgalWhereAPointHasCellsWithHundreds)
{
  const std::vector<Point> points = TwoLines(200);
  EXPECT_EQ(Sorted(ExpectSoundCells(points, DelaunayOf(points))), CellsByCgal(points));
}

TEST(DelaunayTetrahedra, AreTheSameOnOneThreadAndOnMany)
{
  for (int kind = 0; kind < Kinds; ++kind)
  {
    const std::vector<Point> points = PointsOfKind(kind, 5, 800);
    const DelaunayTetrahedra alone = [&]
    {
      const testthreads::Allowed one(1);
      return DelaunayOf(points);
    }();
    for (int run = 0; run < 2; ++run)
    {
      const WholeTeams teams;
      const testthreads::Allowed many(8);
      const DelaunayTetrahedra together = DelaunayOf(points);
      EXPECT_EQ(together.FirstInPlace(), alone.FirstInPlace());
      ASSERT_EQ(together.NumberOfCells(), alone.NumberOfCells());
      for (Id cell = 0; cell < alone.NumberOfCells(); ++cell)
      {
        ASSERT_EQ(together.At(cell).Corners, alone.At(cell).Corners);
        ASSERT_EQ(together.At(cell).Neighbors, alone.At(cell).Neighbors);
      }
    }
  }
}

TEST(DelaunayTetrahedra, UseTheFirstPointInEachPlace)
{
  const std::vector<Point> points = PointsOfKind(0, 1, 900);
  std::map<Point, Id> first;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    first.insert({ points[p], static_cast<Id>(p) });
  }
  const DelaunayTetrahedra delaunay = DelaunayOf(points);
  std::vector<bool> isUsed(points.size() + 1, false);
  for (const Tetrahedron& cell : ExpectSoundCells(points, delaunay))
  {
    for (const Id corner : cell)
    {
      isUsed[static_cast<std::size_t>(corner)] = true;
    }
  }
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    EXPECT_EQ(delaunay.FirstInPlace()[p], first.at(points[p]));
    EXPECT_EQ(isUsed[p], first.at(points[p]) == static_cast<Id>(p));
  }
}

TEST(DelaunayTetrahedra, SayHowFarTheyAreAndStopWhenAsked)
{
  const testthreads::Allowed one(1);
  const std::vector<Point> points = PointsOfKind(1, 1, 2000);
  const int reports =
    testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
      { DelaunayTetrahedra(points, MostNumberedCells, monitor, range); });
  EXPECT_GT(reports, 15);
}

TEST(DelaunayTetrahedra, OfPointsThatSpanNoSpaceAreAnError)
{
  std::vector<std::vector<Point>> flat = { {}, { { { 1, 2, 3 } } }, TwoLines(2), {}, {} };
  flat[2].resize(3);
  for (int i = 0; i < 50; ++i)
  {
    flat[3].push_back({ { double(i % 7), double(i % 5), double(i % 7 + i % 5) } });
    flat[4].push_back({ { double(i % 9), double(i % 9), double(i % 9) } });
  }
  for (const std::vector<Point>& points : flat)
  {
    try
    {
      DelaunayOf(points);
      FAIL() << "no error for " << points.size() << " points";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Planar);
    }
  }
}

TEST(DelaunayTetrahedra, AreNoMoreThanAllowed)
{
  const std::vector<Point> points = TwoLines(300);
  const std::size_t count = CellsByCgal(points).size();
  Monitor monitor;
  try
  {
    DelaunayTetrahedra(points, count / 2, monitor, Inserting);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::TooLarge);
    EXPECT_NE(std::string(error.what()).find(std::to_string(count / 2)), std::string::npos);
  }
  EXPECT_EQ(static_cast<std::size_t>(
              DelaunayTetrahedra(points, 2 * count, monitor, Inserting).NumberOfCells()),
    count);
}

TEST(DelaunayTetrahedra, AreNotTooManyWhereThePointsAreButFewPlaces)
{
  std::vector<Point> points;
  for (int i = 0; i < 5000; ++i)
  {
    points.push_back({ { double(i % 2), double(i / 2 % 2), double(i / 4 % 2) } });
  }
  Monitor monitor;
  const DelaunayTetrahedra delaunay(points, 300, monitor, Inserting);
  EXPECT_EQ(Sorted(ExpectSoundCells(points, delaunay)), CellsByCgal(points));
  for (std::size_t most = 0; most < 12; ++most)
  {
    EXPECT_THROW(DelaunayTetrahedra(points, most, monitor, Inserting), Error);
  }
}

TEST(DelaunayTetrahedra, StopWhereNearlyAllPointsArePostponed)
{
  // Eight cells per point are too few here.
  const testthreads::Allowed one(1);
  const std::vector<Point> points = TwoLines(500);
  EXPECT_GT(testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
              { DelaunayTetrahedra(points, MostNumberedCells, monitor, range); }),
    20);
}

TEST(PerturbedSphere, IsThatOfCgalUnlessAPointIsOnIt)
{
  int onSphere = 0;
  for (int kind = 0; kind < Kinds; ++kind)
  {
    const std::vector<Point> points = PointsOfKind(kind, 2, 400);
    std::mt19937 random(9);
    for (int run = 0; run < 3000; ++run)
    {
      std::array<Point, 5> p;
      for (Point& point : p)
      {
        point = points[random() % points.size()];
      }
      if (Orient3D(p[0], p[1], p[2], p[3]) < 0)
      {
        std::swap(p[0], p[1]);
      }
      const auto at = [&](int k) { return Kernel::Point_3(p[k][0], p[k][1], p[k][2]); };
      const auto corners = p.begin() + 4;
      if (Orient3D(p[0], p[1], p[2], p[3]) == 0 || std::find(p.begin(), corners, p[4]) != corners)
      {
        continue;
      }
      const auto side = CGAL::side_of_oriented_sphere(at(0), at(1), at(2), at(3), at(4));
      onSphere += side == 0 ? 1 : 0;
      if (side != 0)
      {
        ASSERT_EQ(IsInSphere(p[0], p[1], p[2], p[3], p[4]), side > 0);
      }
    }
  }
  EXPECT_GT(onSphere, 20);
}

TEST(InsertionOrder, HasRoundsOfNearbyPointsFromEverywhere)
{
  const std::size_t count = 60000;
  const std::vector<Point> points = PointsOfKind(1, 3, static_cast<int>(count));
  const InsertionOrder order = OrderOfInsertion(points);
  std::vector<Id> sorted = order.Points;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t p = 0; p < count; ++p)
  {
    ASSERT_EQ(sorted[p], static_cast<Id>(p));
  }
  ASSERT_EQ(order.Rounds.back(), count);
  std::size_t begin = 0;
  for (const std::size_t end : order.Rounds)
  {
    // A step is about as long as a box with one point.
    double steps = 0;
    for (std::size_t i = begin + 1; i < end; ++i)
    {
      const Point& a = points[static_cast<std::size_t>(order.Points[i - 1])];
      const Point& b = points[static_cast<std::size_t>(order.Points[i])];
      steps += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    const double inRound = static_cast<double>(end - begin);
    EXPECT_LT(steps, 1.5 * std::pow(inRound, 2.0 / 3));
    begin = end;
  }
}
