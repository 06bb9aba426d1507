// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Error.h"
#include "Measure.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/ReadTriangles.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Validate/CountedChain.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <map>

using namespace insideout;
using namespace benchmark;

namespace
{
/** Seconds of the exact engine over those of the Delaunay tetrahedralization of its points. */
const std::map<std::string, Limit> Targets = {
  { "Beast", AtMost(2) },
  { "AlienSpaceObject", AtMost(6) },
  { "ROBOTIS-OP3-Common_op3_description_ll4", AtMost(40) },
  { "PX4-SITL_gazebo-classic_omnicopter", AtMost(40) },
};
constexpr Limit OfAnyOther = AtMost(25);
constexpr Limit OfTheMedian = AtMost(3);

/** Work that takes longer is timed once. */
constexpr double LongSeconds = 1;

struct Ratio
{
  double Value = 0;
  double SteinerShare = 0; ///< Steiner points over points
};

/** CGAL's, of the same points in the order in which its users have them. */
void Delaunay(const std::vector<Point>& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> sites;
  sites.reserve(points.size());
  for (const Point& p : points)
  {
    sites.emplace_back(p[0], p[1], p[2]);
  }
  CGAL::Delaunay_triangulation_3<Kernel>(sites.begin(), sites.end());
}

Ratio Measure(const std::string& path)
{
  const std::string name = StemOf(path);
  Monitor monitor;
  const FacetComplex surface = ResolveSelfIntersections(
    CountFacets(testmeshes::ReadTriangles(path), {}, monitor).Surface, monitor)
                                 .Surface;
  Tetrahedralization found;
  const auto engine = [&] {
    found = ConstrainedDelaunay(surface, { 0, 0, TetrahedralizationEngine::Exact }, monitor);
  };
  const auto limit = [&surface] { Delaunay(surface.Points); };
  std::array<double, 2> seconds = { { SecondsOf(engine), SecondsOf(limit) } };
  if (seconds[0] < LongSeconds)
  {
    seconds = MedianSeconds(engine, limit);
  }
  PrintSeconds("limit/" + name, surface.Facets.size(), "exact", "Delaunay", seconds);
  std::printf("%s: %zu points, %d Steiner points (%d on the surface), %zu facets lost\n",
    name.c_str(), surface.Points.size(), found.Mesh.NumberOfSteinerPoints,
    found.Mesh.NumberOfSurfaceSteinerPoints, found.Mesh.LostFacets.size());
  const auto target = Targets.find(name);
  const Ratio ratio = { seconds[0] / seconds[1],
    static_cast<double>(found.Mesh.NumberOfSteinerPoints) /
      static_cast<double>(surface.Points.size()) };
  PrintRatio("limit/" + name, ratio.Value, target == Targets.end() ? OfAnyOther : target->second);
  return ratio;
}
} // namespace

/**
 * BenchmarkDelaunayLimit SURFACE...: the exact engine on resolved surfaces against what it cannot
 * do without, the Delaunay tetrahedralization of the points; with the Steiner points that it takes.
 * Lines as in Measure.h, and the median of all; a surface that cannot be read is named and passed
 * over.
 */
int main(int argc, char** argv)
{
  std::vector<double> ratios;
  std::vector<double> shares;
  for (int i = 1; i < argc; ++i)
  {
    try
    {
      const Ratio ratio = Measure(argv[i]);
      ratios.push_back(ratio.Value);
      shares.push_back(ratio.SteinerShare);
    }
    catch (const Error& error)
    {
      std::printf("%s: %s\n", argv[i], error.what());
    }
  }
  if (!ratios.empty())
  {
    std::sort(shares.begin(), shares.end());
    std::printf("Steiner points of all points: %.4f %% at the median, %.4f %% at nine in ten\n",
      100 * shares[shares.size() / 2], 100 * shares[shares.size() * 9 / 10]);
    PrintRatio("limit/median", Median(ratios), OfTheMedian);
  }
  return 0;
}
