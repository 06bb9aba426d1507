// SPDX-License-Identifier: GPL-3.0-or-later
#include "Clouds/PointCloud.h"

#include "Clouds/AreasOfPoints.h"
#include "Common/Error.h"
#include "Support/Clouds.h"
#include "Support/StopAtEveryReport.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace
{
using namespace insideout;
using testmeshes::Lattice;
using testmeshes::Sphere;

PointCloud Checked(const PointCloud& cloud)
{
  Monitor silent;
  return CheckedCloud(cloud, silent, { "", 0, 1 });
}

double TotalArea(const PointCloud& cloud)
{
  const std::vector<double> areas = Checked(cloud).Areas;
  return std::accumulate(areas.begin(), areas.end(), 0.0);
}

void ExpectError(const PointCloud& cloud, ErrorCode code, const std::string& words)
{
  try
  {
    Checked(cloud);
    ADD_FAILURE() << "no error: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code);
    EXPECT_EQ(error.what(), words);
  }
}

TEST(AreasOfPoints, AreThoseOfASquareAndOfItsRim)
{
  const int perSide = 9;
  const std::vector<double> areas = Checked(Lattice(perSide, 0, 1)).Areas;
  for (int i = 0; i < perSide * perSide; ++i)
  {
    const auto isOnRim = [](int x) { return x == 0 || x == perSide - 1; };
    const double expected = (isOnRim(i % perSide) ? 0.5 : 1) * (isOnRim(i / perSide) ? 0.5 : 1);
    EXPECT_NEAR(areas[i], expected, 1e-12) << i;
  }
}

TEST(AreasOfPoints, SumToThatOfASphereOfAnySize)
{
  for (const double radius : { 1e-100, 1.0, 1e120 })
  {
    const double expected = 4 * Pi * radius * radius;
    EXPECT_NEAR(TotalArea(Sphere(2000, radius)), expected, 0.01 * expected);
  }
}

TEST(AreasOfPoints, DoNotSeeTheOtherSideOfAThinWall)
{
  PointCloud wall = Lattice(9, 0, 1);
  const PointCloud other = Lattice(9, -0.01, -1);
  wall.Points.insert(wall.Points.end(), other.Points.begin(), other.Points.end());
  wall.Normals.insert(wall.Normals.end(), other.Normals.begin(), other.Normals.end());
  EXPECT_NEAR(TotalArea(wall), 2 * 64, 1e-9);
}

TEST(AreasOfPoints, AreSharedByPointsInOnePlace)
{
  PointCloud cloud = Lattice(9, 0, 1);
  for (int copy = 0; copy < 100; ++copy)
  {
    cloud.Points.push_back(cloud.Points[40]);
    cloud.Normals.push_back(cloud.Normals[40]);
  }
  const std::vector<double> areas = Checked(cloud).Areas;
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 64, 1e-9);
  EXPECT_NEAR(areas[40], 1.0 / 101, 1e-12);
  EXPECT_NEAR(areas.back(), 1.0 / 101, 1e-12);
}

TEST(AreasOfPoints, AreTheSameForAnyOrderOfPoints)
{
  PointCloud cloud = Sphere(500, 1);
  const std::vector<double> areas = Checked(cloud).Areas;
  std::reverse(cloud.Points.begin(), cloud.Points.end());
  std::reverse(cloud.Normals.begin(), cloud.Normals.end());
  std::vector<double> reversed = Checked(cloud).Areas;
  std::reverse(reversed.begin(), reversed.end());
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    EXPECT_NEAR(reversed[i], areas[i], 1e-12 * areas[i]);
  }
}

TEST(AreasOfPoints, CanBeStoppedAtEachReport)
{
  const PointCloud sphere = Sphere(300, 1);
  EXPECT_GE(testmeshes::StopAtEveryReport([&](Monitor& monitor, const ProgressRange& progress)
              { AreasOfPoints(sphere.Points, sphere.Normals, monitor, progress); }),
    1);
}

TEST(CheckedCloud, MakesNormalsOfLengthOne)
{
  PointCloud cloud = Lattice(3, 0, 1);
  cloud.Normals[0] = { 0, 3e300, 4e300 };
  cloud.Normals[1] = { 0, 0, -1e-310 };
  const PointCloud checked = Checked(cloud);
  EXPECT_NEAR(checked.Normals[0][1], 0.6, 1e-15);
  EXPECT_NEAR(checked.Normals[0][2], 0.8, 1e-15);
  EXPECT_EQ(checked.Normals[1], (Point{ 0, 0, -1 }));
}

TEST(CheckedCloud, KeepsAreasThatAreGiven)
{
  PointCloud cloud = Lattice(3, 0, 1);
  cloud.Areas.assign(9, 7);
  cloud.Areas[4] = 0;
  EXPECT_EQ(Checked(cloud).Areas, cloud.Areas);
}

TEST(CheckedCloud, NamesThePointThatIsWrong)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExpectError({}, ErrorCode::EmptySurface, "the cloud has no points");
  PointCloud cloud = Lattice(3, 0, 1);
  cloud.Points[5][1] = nan;
  ExpectError(cloud, ErrorCode::PointNotFinite, "point 5 of the cloud is not finite");
  cloud = Lattice(3, 0, 1);
  cloud.Normals[6] = { 0, 0, 0 };
  ExpectError(cloud, ErrorCode::InvalidParameter, "point 6 of the cloud has a normal of length 0");
  cloud.Normals[6] = { 0, nan, 1 };
  ExpectError(
    cloud, ErrorCode::InvalidParameter, "point 6 of the cloud has a normal that is not finite");
  cloud = Lattice(3, 0, 1);
  cloud.Areas.assign(9, 1);
  cloud.Areas[8] = -2;
  ExpectError(cloud, ErrorCode::InvalidParameter,
    "point 8 of the cloud has the area -2.000000; areas are finite and at least 0");
  cloud.Areas[8] = nan;
  ExpectError(cloud, ErrorCode::InvalidParameter,
    "point 8 of the cloud has the area nan; areas are finite and at least 0");
  cloud = Lattice(1, 0, 1);
  ExpectError(cloud, ErrorCode::AllDegenerate,
    "no point of the cloud has an area: they are given as 0, or all points are in a line");
}

TEST(SeemsInsideOut, IsSaidOfClosedCloudsOnly)
{
  PointCloud sphere = Checked(Sphere(500, 1));
  EXPECT_FALSE(SeemsInsideOut(sphere));
  for (Point& normal : sphere.Normals)
  {
    normal = { -normal[0], -normal[1], -normal[2] };
  }
  EXPECT_TRUE(SeemsInsideOut(sphere));
  EXPECT_FALSE(SeemsInsideOut(Checked(Lattice(9, 0, 1))));
  EXPECT_FALSE(SeemsInsideOut(Checked(Lattice(9, 0, -1))));
}
} // namespace
