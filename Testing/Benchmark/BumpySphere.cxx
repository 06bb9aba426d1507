// SPDX-License-Identifier: GPL-3.0-or-later
#include "BumpySphere.h"

#include <cmath>

using namespace insideout;

namespace benchmark
{
TriangleSoup BumpySphere(int triangles, double angle, double offset)
{
  const double pi = std::acos(-1.0);
  const int rings = static_cast<int>(std::lround(std::sqrt(triangles / 4.0)));
  const int around = static_cast<int>(std::lround(triangles / 2.0 / rings));
  TriangleSoup sphere;
  const auto add = [&](double latitude, double longitude)
  {
    const double radius = 1 + 0.05 * std::sin(9 * latitude) * std::sin(7 * longitude);
    const double x = radius * std::sin(latitude) * std::cos(longitude);
    const double y = radius * std::sin(latitude) * std::sin(longitude);
    const double z = radius * std::cos(latitude);
    sphere.Points.push_back({ { x * std::cos(angle) - z * std::sin(angle) + offset, y + offset / 2,
      x * std::sin(angle) + z * std::cos(angle) } });
  };
  add(0, 0);
  for (int ring = 1; ring <= rings; ++ring)
  {
    for (int k = 0; k < around; ++k)
    {
      add(pi * ring / (rings + 1), 2 * pi * k / around);
    }
  }
  add(pi, 0);
  const Id last = static_cast<Id>(sphere.Points.size()) - 1;
  const auto at = [&](int ring, int k) { return 1 + ring * around + k % around; };
  for (int k = 0; k < around; ++k)
  {
    sphere.Triangles.push_back({ { 0, at(0, k), at(0, k + 1) } });
    for (int ring = 0; ring + 1 < rings; ++ring)
    {
      sphere.Triangles.push_back({ { at(ring, k), at(ring + 1, k), at(ring + 1, k + 1) } });
      sphere.Triangles.push_back({ { at(ring, k), at(ring + 1, k + 1), at(ring, k + 1) } });
    }
    sphere.Triangles.push_back({ { last, at(rings - 1, k + 1), at(rings - 1, k) } });
  }
  return sphere;
}
} // namespace benchmark
