// SPDX-License-Identifier: GPL-3.0-or-later
#include "Measure.h"
#include "Planar/PlanarHull.h"
#include "Planar/ResolveSegments.h"
#include "Planar/SegmentTriangles.h"
#include "Planar/TriangulateHull.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>
#include <random>

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr Limit Growth = { Limit::Side::AtMost, 2 }; // of the seconds per segment
constexpr Limit Cgal = { Limit::Side::AtMost, 0.5 };
constexpr int CornersOfRing = 20;

/** Closed rings in random places of a square, as in a map: one crossing for about five segments. */
SegmentSoup Rings(int segments)
{
  std::mt19937 random(1);
  const auto uniform = [&]() { return random() / 4294967296.0; };
  const int rings = segments / CornersOfRing;
  const double size = 0.6 / std::sqrt(rings);
  SegmentSoup soup;
  for (Id ring = 0; ring < rings; ++ring)
  {
    const double x = uniform();
    const double y = uniform();
    for (Id k = 0; k < CornersOfRing; ++k)
    {
      const double angle = 2 * std::acos(-1) * k / CornersOfRing;
      const double radius = size * (0.5 + 0.5 * uniform());
      soup.Points.push_back({ { x + radius * std::cos(angle), y + radius * std::sin(angle), 0 } });
      const Id first = ring * CornersOfRing;
      soup.Segments.push_back({ { first + k, first + (k + 1) % CornersOfRing } });
    }
  }
  return soup;
}

/** Short segments in random places of a square: two open ends each. */
SegmentSoup OpenSegments(int count)
{
  std::mt19937 random(1);
  const auto uniform = [&]() { return random() / 4294967296.0; };
  const double size = 0.5 / std::sqrt(count);
  SegmentSoup soup;
  for (Id i = 0; i < count; ++i)
  {
    const double x = uniform();
    const double y = uniform();
    const double angle = 2 * std::acos(-1) * uniform();
    soup.Points.push_back({ { x, y, 0 } });
    soup.Points.push_back({ { x + size * std::cos(angle), y + size * std::sin(angle), 0 } });
    soup.Segments.push_back({ { 2 * i, 2 * i + 1 } });
  }
  return soup;
}

/** All stages. */
void Mesh(const SegmentSoup& soup)
{
  Monitor monitor;
  const PlanarHull hull = MeshPlanarHull(soup, FindPlane(soup.Points), {}, monitor);
  SegmentTriangles(hull.Curve, hull.Mesh, hull.Plane, hull.W, {}, {}, {}, monitor);
}

/** The stages that CGAL has, too. */
void Triangulate(const SegmentSoup& soup)
{
  Monitor monitor;
  const Plane plane = FindPlane(soup.Points);
  const CountedCurve counted = CountSegments(soup, plane, {}, monitor);
  TriangulateHull(ResolveSegments(counted.Curve, monitor).Curve, plane.Metric, monitor);
}

/** As its users call it: points sorted along a curve, then the segments between them. */
void TriangulateByCgal(const SegmentSoup& soup)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default,
    CGAL::Exact_intersections_tag>;
  CGAL::Constrained_triangulation_plus_2<Triangulation> triangulation;
  std::vector<Kernel::Point_2> points;
  for (const Point& p : soup.Points)
  {
    points.emplace_back(p[0], p[1]);
  }
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  for (const Segment& segment : soup.Segments)
  {
    segments.emplace_back(segment[0], segment[1]);
  }
  triangulation.insert_constraints(points.begin(), points.end(), segments.begin(), segments.end());
}
} // namespace

/** BenchmarkPlanar: a million segments against 10,000, 100,000 against CGAL, and 200,000 open ends
 * against 20,000. Lines as in Measure.h. */
int main()
{
  const SegmentSoup few = Rings(10000);
  const SegmentSoup some = Rings(100000);
  const SegmentSoup many = Rings(1000000);
  const auto compared = MedianSeconds([&] { Triangulate(some); }, [&] { TriangulateByCgal(some); });
  PrintSeconds("planar/cgal", some.Segments.size(), "ours", "CGAL", compared);
  PrintRatio("planar/cgal", compared[0] / compared[1], Cgal);
  const auto seconds = MedianSeconds([&] { Mesh(many); }, [&] { Mesh(few); });
  PrintSeconds("planar/growth", many.Segments.size(), "a million", "10,000", seconds);
  PrintRatio("planar/growth", seconds[0] / (100 * seconds[1]), Growth);
  const SegmentSoup fewOpen = OpenSegments(10000);
  const SegmentSoup manyOpen = OpenSegments(100000);
  const auto open = MedianSeconds([&] { Mesh(manyOpen); }, [&] { Mesh(fewOpen); });
  PrintSeconds("planar/open", manyOpen.Segments.size(), "100,000", "10,000", open);
  PrintRatio("planar/open", open[0] / (10 * open[1]), Growth);
  return 0;
}
