// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * BenchmarkManifold [SURFACE...]: union, intersection and difference of two bumpy spheres, as in
 * BenchmarkBoolean, and of each surface with itself, turned and moved, against manifold's, by
 * turns. Ours begins with triangles as they come, manifold's with surfaces that it has taken; how
 * long taking lasts is told, too, and which surfaces it refuses. All seconds are processor time.
 */
#include "BooleanByManifold.h"
#include "BumpySphere.h"
#include "Common/Box.h"
#include "Measure.h"
#include "Support/ReadTriangles.h"

#include <cmath>
#include <map>

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr int Runs = 5;
constexpr double Apart = 1e-6; ///< of both volumes, from which on results differ
const std::map<SetOperation, std::string> Names = { { SetOperation::Union, "union" },
  { SetOperation::Intersection, "intersection" }, { SetOperation::Difference, "difference" } };

/** The ratios of all surfaces that both take. */
struct Ratios
{
  std::vector<double> Ready; ///< ours over manifold's operation
  std::vector<double> Whole; ///< ours over manifold's operation and taking
  int Pairs = 0;
  int Differing = 0; ///< operations
  std::map<std::string, int> Refusals;
};

/** Turned around its middle and moved by a tenth of its diagonal. */
TriangleSoup Moved(TriangleSoup soup)
{
  const Box box = BoundingBox(soup.Points);
  const double diagonal = std::hypot(box.Extent(0), box.Extent(1), box.Extent(2));
  const double angle = 0.7;
  for (Point& p : soup.Points)
  {
    const double x = p[0] - (box.Low[0] + box.High[0]) / 2;
    const double z = p[2] - (box.Low[2] + box.High[2]) / 2;
    p[0] += x * (std::cos(angle) - 1) - z * std::sin(angle) + 0.1 * diagonal;
    p[2] += x * std::sin(angle) + z * (std::cos(angle) - 1);
  }
  return soup;
}

void Measure(const std::string& name, const TriangleSoup& a, const TriangleSoup& b, Ratios& ratios)
{
  const ManifoldPair taken = TakeByManifold(a, b);
  ++ratios.Pairs;
  if (!taken.Refusal.empty())
  {
    ++ratios.Refusals[taken.Refusal];
    std::printf("%s: manifold says %s\n", name.c_str(), taken.Refusal.c_str());
    std::fflush(stdout);
    return;
  }
  const Made either = BooleanByUs(a, b, SetOperation::Union);
  if (either.Facets == 0)
  {
    std::printf("%s: is not closed, ours would need tetrahedra\n", name.c_str());
    return;
  }
  const double whole = either.Volume + BooleanByUs(a, b, SetOperation::Intersection).Volume;
  for (const auto& [operation, word] : Names)
  {
    const double apart =
      std::abs(BooleanByUs(a, b, operation).Volume - taken.Make(operation).Volume) / whole;
    ratios.Differing += apart > Apart;
    std::array<std::vector<double>, 3> seconds;
    for (int run = 0; run < Runs; ++run)
    {
      seconds[0].push_back(BooleanByUs(a, b, operation).ProcessorSeconds);
      seconds[1].push_back(taken.Make(operation).ProcessorSeconds);
      seconds[2].push_back(TakeByManifold(a, b).Seconds);
    }
    const double our = Median(seconds[0]);
    const double their = Median(seconds[1]);
    const double taking = Median(seconds[2]);
    ratios.Ready.push_back(our / their);
    ratios.Whole.push_back(our / (their + taking));
    std::printf("%-28s %9zu facets   %-12s %8.4f s   manifold %8.4f s, and %8.4f s to take both   "
                "volumes apart by %.1e\n",
      name.c_str(), a.Triangles.size() + b.Triangles.size(), word.c_str(), our, their, taking,
      apart);
    std::fflush(stdout);
  }
}
} // namespace

int main(int argc, char** argv)
{
  Ratios ratios;
  for (int i = 1; i < argc; ++i)
  {
    const TriangleSoup soup = testmeshes::ReadTriangles(argv[i]);
    Measure(StemOf(argv[i]), soup, Moved(soup), ratios);
  }
  for (const int triangles : { 64618, 1000000 })
  {
    if (argc == 1)
    {
      Measure("boolean/" + std::to_string(triangles), BumpySphere(triangles / 2, 0, 0),
        BumpySphere(triangles / 2, 0.7, 0.6), ratios);
    }
  }
  if (!ratios.Ready.empty())
  {
    std::printf("%d surfaces, %zu operations on what both take: ours takes %.2f times manifold's "
                "in the median, %.2f times what it takes with taking both; %d results differ\n",
      ratios.Pairs, ratios.Ready.size(), Median(ratios.Ready), Median(ratios.Whole),
      ratios.Differing);
  }
  for (const auto& [refusal, count] : ratios.Refusals)
  {
    std::printf("%d: manifold says %s\n", count, refusal.c_str());
  }
  return 0;
}
