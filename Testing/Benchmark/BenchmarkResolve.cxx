// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChangedSurfaces.h"
#include "DetectionByCgal.h"
#include "Measure.h"
#include "Resolve/FindIntersections.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/ReadTriangles.h"
#include "Validate/CountedChain.h"

#include <map>
#include <omp.h>

using namespace insideout;
using namespace benchmark;

namespace
{
/** The whole stage over CGAL's detection alone, for surfaces that have a target. */
const std::map<std::string, Limit> Targets = {
  { "Beast", AtMost(1.5) },
  { "AlienSpaceObject", AtMost(4) },
  { "man", AtMost(4) },
  { "propellerTip", AtMost(4) },
  { "motorBike", AtMost(4) },
};
constexpr Limit ThreadsTarget = AtLeast(1.6); ///< detection on one thread over two
constexpr Limit ScaleTarget = AtMost(1.5);    ///< time per facet, 16 times as many over as given
const char* const ScaledSurface = "Beast";    ///< what these two are measured on

FacetComplex Validated(const TriangleSoup& soup)
{
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

void Resolve(const FacetComplex& surface)
{
  Monitor monitor;
  ResolveSelfIntersections(surface, monitor);
}

void MeasureStage(const std::string& name, const FacetComplex& surface)
{
  const Detection cgal = DetectionByCgal(surface);
  Monitor monitor;
  const std::size_t pairs = FindIntersections(surface.Points, surface.Facets, monitor).size();
  const std::size_t expected = cgal.Run();
  if (pairs != expected)
  {
    std::printf("%s: %zu pairs, %zu by %s\n", name.c_str(), pairs, expected, cgal.Name.c_str());
  }
  const auto seconds = MedianSeconds([&] { Resolve(surface); }, [&] { cgal.Run(); });
  PrintSeconds("pre/" + name, surface.Facets.size(), "stage", cgal.Name.c_str(), seconds);
  const auto target = Targets.find(name);
  if (target != Targets.end())
  {
    PrintRatio("pre/" + name, seconds[0] / seconds[1], target->second);
  }
}

void MeasureThreads(const FacetComplex& surface)
{
  const int threads = omp_get_max_threads();
  const auto detectOn = [&](int count)
  {
    omp_set_num_threads(count);
    Monitor monitor;
    FindIntersections(surface.Points, surface.Facets, monitor);
  };
  const auto seconds = MedianSeconds([&] { detectOn(1); }, [&] { detectOn(2); });
  omp_set_num_threads(threads);
  PrintSeconds("detect/threads", surface.Facets.size(), "1 thread", "2 threads", seconds);
  PrintRatio("detect/threads", seconds[0] / seconds[1], ThreadsTarget);
}

void MeasureScale(const TriangleSoup& soup)
{
  const FacetComplex small = Validated(soup);
  const FacetComplex large = Validated(Subdivided(Subdivided(soup)));
  const auto seconds = MedianSeconds([&] { Resolve(large); }, [&] { Resolve(small); });
  PrintSeconds("scale/pre", large.Facets.size(), "subdivided", "as given", seconds);
  const double perFacet = (seconds[0] / static_cast<double>(large.Facets.size())) /
    (seconds[1] / static_cast<double>(small.Facets.size()));
  PrintRatio("scale/pre", perFacet, ScaleTarget);
}

void Measure(const std::string& path)
{
  const std::string name = StemOf(path);
  const TriangleSoup soup = testmeshes::ReadTriangles(path);
  const FacetComplex surface = Validated(soup);
  MeasureStage(name, surface);
  if (name == ScaledSurface)
  {
    MeasureThreads(surface);
    MeasureScale(soup);
  }
}

/** In a process of its own, for memory that was used once stays with the process. */
void MeasureMemory(const std::string& path)
{
  const FacetComplex surface = Validated(testmeshes::ReadTriangles(path));
  const double before = ResetHighWaterMark();
  Resolve(surface);
  std::printf("memory pre/%s %.1f MiB above %.1f MiB\n", StemOf(path).c_str(),
    HighWaterMark() - before, before);
}
} // namespace

/**
 * BenchmarkResolve [--memory] SURFACE...: measures stage pre, or the memory that it takes at most.
 * Lines as in Measure.h; a surface that cannot be read is named and passed over.
 */
int main(int argc, char** argv)
{
  const bool memory = argc > 1 && std::string(argv[1]) == "--memory";
  for (int i = memory ? 2 : 1; i < argc; ++i)
  {
    try
    {
      memory ? MeasureMemory(argv[i]) : Measure(argv[i]);
    }
    catch (const Error& error)
    {
      std::printf("%s: %s\n", argv[i], error.what());
    }
  }
  return 0;
}
