// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/InsertPoints.h"

#include "Support/FlippableMeshes.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

using namespace insideout;

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel>>>;

/** Many points, of which many are in the same places. */
std::vector<Point> PointsSeveralTimes(unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Point> points = testflips::GridPoints(random, 200, 12);
  for (int k = 0; k < 600; ++k)
  {
    points.push_back(points[random() % points.size()]);
  }
  std::shuffle(points.begin(), points.end(), random);
  return points;
}
} // namespace

TEST(InsertPoints, AVertexHasTheLowestIdOfThePointsInItsPlace)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const std::vector<Point> points = PointsSeveralTimes(seed);
    std::map<Point, Id> lowest;
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      lowest.insert({ points[p], static_cast<Id>(p) });
    }
    Delaunay delaunay;
    InsertPoints(points, delaunay, [](double) {});
    ASSERT_EQ(delaunay.number_of_vertices(), lowest.size());
    for (const auto vertex : delaunay.finite_vertex_handles())
    {
      const auto& p = vertex->point();
      EXPECT_EQ(vertex->info(), lowest.at({ { p.x(), p.y(), p.z() } }));
    }
    EXPECT_TRUE(delaunay.is_valid());
  }
}

TEST(InsertPoints, SaysHowFarItIsAndLetsWhoeverAsksStopIt)
{
  const std::vector<Point> points = PointsSeveralTimes(1);
  std::vector<double> shares;
  Delaunay delaunay;
  InsertPoints(points, delaunay, [&](double share) { shares.push_back(share); });
  ASSERT_EQ(shares.size(), 4u);
  EXPECT_EQ(shares.front(), 0);
  EXPECT_LT(shares.back(), 1);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));

  Delaunay stopped;
  const auto stop = [](double share)
  {
    if (share > 0.5)
    {
      throw std::runtime_error("stopped");
    }
  };
  EXPECT_THROW(InsertPoints(points, stopped, stop), std::runtime_error);
  EXPECT_LT(stopped.number_of_vertices(), delaunay.number_of_vertices());
}

TEST(InsertPoints, OfNoPointsMakesNothing)
{
  Delaunay delaunay;
  InsertPoints({}, delaunay, [](double) {});
  EXPECT_EQ(delaunay.number_of_vertices(), 0u);
}
