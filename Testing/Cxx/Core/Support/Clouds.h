// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Clouds/PointCloud.h"
#include "WindingNumber/Pi.h"

#include <cmath>

/** Point clouds that tests are made of. */
namespace testmeshes
{
using namespace insideout;

/** Points all over the sphere of this radius around the origin, along a spiral (Saff and Kuijlaars
 * 1997), with normals outward and no areas. */
inline PointCloud Sphere(int count, double radius)
{
  PointCloud cloud;
  double longitude = 0;
  for (int i = 0; i < count; ++i)
  {
    const double z = -1 + (2.0 * i + 1) / count;
    const double across = std::sqrt(1 - z * z);
    longitude += 3.6 / std::sqrt(static_cast<double>(count)) / across;
    const Point normal = { across * std::cos(longitude), across * std::sin(longitude), z };
    cloud.Points.push_back({ radius * normal[0], radius * normal[1], radius * normal[2] });
    cloud.Normals.push_back(normal);
  }
  return cloud;
}

/** The points of a square lattice in the plane z = height, `perSide` by `perSide`, a unit apart. */
inline PointCloud Lattice(int perSide, double height, double up)
{
  PointCloud cloud;
  for (int i = 0; i < perSide * perSide; ++i)
  {
    cloud.Points.push_back(
      { static_cast<double>(i % perSide), static_cast<double>(i / perSide), height });
    cloud.Normals.push_back({ 0, 0, up });
  }
  return cloud;
}
} // namespace testmeshes
