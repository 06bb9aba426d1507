// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SurfaceOfExpression.h"
#include "Measure.h"
#include "UnionByCgal.h"

#include <cmath>
#include <cstdlib>

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr Limit Target = AtMost(1.0); ///< our union over CGAL's, of the same clean pair
constexpr int Runs = 5;

/** A sphere with bumps, of about so many triangles, turned and moved: closed and without crossings.
 */
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

Union UnionByUs(const TriangleSoup& a, const TriangleSoup& b)
{
  std::vector<Body> bodies;
  bodies.push_back(MakeBody("A", a, 0, 0));
  bodies.push_back(
    MakeBody("B", b, static_cast<Id>(a.Points.size()), static_cast<Id>(a.Triangles.size())));
  Monitor monitor;
  Stopwatch stopwatch;
  const ResolvedBodies resolved = ResolveBodies(std::move(bodies), {}, monitor);
  const auto surface = SurfaceOfExpression(resolved, { SetOperation::Union, 2 }, monitor);
  return { stopwatch.Lap(), surface ? surface->Boundary.size() : 0 };
}

/** Of a pair of so many triangles in all. */
void Measure(int triangles)
{
  const TriangleSoup a = BumpySphere(triangles / 2, 0, 0);
  const TriangleSoup b = BumpySphere(triangles / 2, 0.7, 0.6);
  const std::size_t size = a.Triangles.size() + b.Triangles.size();
  const std::string name = "boolean/" + std::to_string(triangles);
  const auto byCgal = UnionByCgal(a, b);
  const Union ours = UnionByUs(a, b);
  const Union theirs = byCgal();
  std::printf("%s: %zu facets of ours, %zu of CGAL's\n", name.c_str(), ours.Facets, theirs.Facets);
  std::array<std::vector<double>, 2> seconds;
  for (int run = 0; run < Runs; ++run)
  {
    seconds[0].push_back(UnionByUs(a, b).Seconds);
    seconds[1].push_back(byCgal().Seconds);
  }
  const std::array<double, 2> medians = { Median(seconds[0]), Median(seconds[1]) };
  PrintSeconds(name, size, "union", "corefine_and_compute_union", medians);
  PrintRatio(name, medians[0] / medians[1], Target);
}
} // namespace

/** BenchmarkBoolean [TRIANGLES...]: the union of two clean surfaces, of so many triangles together,
 * against CGAL's. Lines as in Measure.h. */
int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    Measure(std::atoi(argv[i]));
  }
  if (argc == 1)
  {
    Measure(64618);
    Measure(1000000);
  }
  return 0;
}
