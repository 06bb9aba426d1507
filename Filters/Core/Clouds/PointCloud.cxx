// SPDX-License-Identifier: GPL-3.0-or-later
#include "Clouds/PointCloud.h"

#include "Clouds/AreasOfPoints.h"
#include "Common/Error.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace insideout
{
namespace
{
// Scans with holes of moderate size are below this, single views and open sheets above.
constexpr double MostOfOpenArea = 0.1;

std::string NameOf(std::size_t point)
{
  return "point " + std::to_string(point) + " of the cloud ";
}

/** A normal of any length; zero for a zero vector. */
Point UnitVector(const Point& normal, std::size_t point)
{
  if (!IsFinite(normal))
  {
    throw Error(ErrorCode::InvalidParameter, NameOf(point) + "has a normal that is not finite");
  }
  const double largest =
    std::max({ std::abs(normal[0]), std::abs(normal[1]), std::abs(normal[2]) });
  if (largest == 0)
  {
    throw Error(ErrorCode::InvalidParameter, NameOf(point) + "has a normal of length 0");
  }
  const Point scaled = { normal[0] / largest, normal[1] / largest, normal[2] / largest };
  const double length = Length(scaled);
  return { scaled[0] / length, scaled[1] / length, scaled[2] / length };
}
} // namespace

PointCloud CheckedCloud(PointCloud cloud, Monitor& monitor, const ProgressRange& progress)
{
  if (cloud.Points.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the cloud has no points");
  }
  for (std::size_t i = 0; i < cloud.Points.size(); ++i)
  {
    if (!IsFinite(cloud.Points[i]))
    {
      throw Error(ErrorCode::PointNotFinite, NameOf(i) + "is not finite");
    }
    cloud.Normals[i] = UnitVector(cloud.Normals[i], i);
  }
  if (cloud.Areas.empty())
  {
    cloud.Areas = AreasOfPoints(cloud.Points, cloud.Normals, monitor, progress);
  }
  for (std::size_t i = 0; i < cloud.Points.size(); ++i)
  {
    if (!(cloud.Areas[i] >= 0 && std::isfinite(cloud.Areas[i])))
    {
      throw Error(ErrorCode::InvalidParameter,
        NameOf(i) + "has the area " + std::to_string(cloud.Areas[i]) +
          "; areas are finite and at least 0");
    }
  }
  if (std::all_of(cloud.Areas.begin(), cloud.Areas.end(), [](double area) { return area == 0; }))
  {
    throw Error(ErrorCode::AllDegenerate,
      "no point of the cloud has an area: they are given as 0, or all points are in a line");
  }
  return cloud;
}

bool SeemsInsideOut(const PointCloud& cloud)
{
  double area = 0;
  Point vectorArea = { 0, 0, 0 };
  double volume = 0;
  for (std::size_t i = 0; i < cloud.Points.size(); ++i)
  {
    area += cloud.Areas[i];
    for (int axis = 0; axis < 3; ++axis)
    {
      vectorArea[axis] += cloud.Areas[i] * cloud.Normals[i][axis];
    }
    volume += cloud.Areas[i] * Dot(cloud.Normals[i], Difference(cloud.Points[i], cloud.Points[0]));
  }
  return Length(vectorArea) <= MostOfOpenArea * area && volume < 0;
}
} // namespace insideout
