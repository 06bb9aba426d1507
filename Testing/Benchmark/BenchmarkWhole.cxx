// SPDX-License-Identifier: GPL-3.0-or-later
#include "ChangedSurfaces.h"
#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Measure.h"
#include "Output/BoundaryTriangles.h"
#include "Output/InsideBoundary.h"
#include "Output/Outliers.h"
#include "Support/ReadTriangles.h"

#include <array>
#include <map>
#include <omp.h>

#include <sys/wait.h>
#include <unistd.h>

using namespace insideout;
using namespace benchmark;

namespace
{
constexpr Limit ThreadsTarget = AtLeast(1.5); ///< one thread over two
constexpr Limit ScaleTarget = AtMost(1);      ///< seconds per facet, over those as given
constexpr Limit MemoryTarget = AtMost(1.2);   ///< KiB per facet at the peak
constexpr int MeasuredSubdivisions = 2;       ///< what these are measured after
constexpr int Repetitions = 3;

/** Seconds of the stages, as HullMesh has them, then of the cut and of what comes out. */
constexpr std::array<const char*, 6> Stages = { { "validate", "resolve", "cdt", "w", "cut",
  "output" } };

struct Run
{
  std::array<double, Stages.size()> Seconds = {};
  double Kibibytes = 0; ///< at the peak, with the surface that comes in

  double Whole() const
  {
    double sum = 0;
    for (const double seconds : this->Seconds)
    {
      sum += seconds;
    }
    return sum;
  }
};

TriangleSoup SubdividedTimes(const std::string& path, int times)
{
  TriangleSoup soup = testmeshes::ReadTriangles(path);
  for (int k = 0; k < times; ++k)
  {
    soup = Subdivided(soup);
  }
  return soup;
}

Run RunPipeline(const TriangleSoup& soup)
{
  constexpr ProgressRange progress = { "extracting", 0, 1 };
  Run run;
  Monitor monitor;
  HullMeshParameters parameters;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  const HullMesh hull = MeshHull(soup, parameters, monitor);
  const std::map<std::string, double> statistics(hull.Statistics.begin(), hull.Statistics.end());
  Stopwatch watch;
  const std::vector<unsigned char> inside =
    SegmentMesh(hull.Mesh, hull.W, {}, {}, {}, monitor).Inside;
  const double cut = watch.Lap();
  BoundaryTriangles(hull.Surface, hull.Mesh, BoundaryFaces(hull.Mesh, inside, monitor, progress),
    monitor, progress);
  OutlierPieces(hull.Surface, hull.Mesh, inside, monitor, progress);
  run.Seconds = { { statistics.at("SecondsValidate"), statistics.at("SecondsPre"),
    statistics.at("SecondsCDT"), statistics.at("SecondsW"), cut, watch.Lap() } };
  return run;
}

/** In a process of its own, for memory that was used once stays with the process. */
bool RunApart(const std::string& path, int subdivisions, int threads, Run& run)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return false;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    omp_set_num_threads(threads);
    const double before = ResetHighWaterMark();
    const TriangleSoup soup = SubdividedTimes(path, subdivisions);
    Run own = RunPipeline(soup);
    own.Kibibytes = 1024 * (HighWaterMark() - before);
    _exit(write(ends[1], &own, sizeof(own)) == sizeof(own) ? 0 : 1);
  }
  close(ends[1]);
  const bool isRead = read(ends[0], &run, sizeof(run)) == sizeof(run);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return isRead;
}

/** The run of median time. */
bool MedianRun(const std::string& path, int subdivisions, int threads, Run& median)
{
  std::vector<Run> runs;
  for (int k = 0; k < Repetitions; ++k)
  {
    Run run;
    if (!RunApart(path, subdivisions, threads, run))
    {
      return false;
    }
    runs.push_back(run);
  }
  std::sort(
    runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.Whole() < b.Whole(); });
  median = runs[runs.size() / 2];
  return true;
}

void PrintRow(std::size_t facets, int threads, const Run& run)
{
  std::printf("%9zu facets, %d threads:", facets, threads);
  for (std::size_t k = 0; k < Stages.size(); ++k)
  {
    std::printf(" %s %.3f s,", Stages[k], run.Seconds[k]);
  }
  std::printf(" whole %.3f s, %.2f KiB per facet\n", run.Whole(),
    run.Kibibytes / static_cast<double>(facets));
  std::fflush(stdout);
}

void Measure(const std::string& path, int subdivisions)
{
  const std::size_t given = testmeshes::ReadTriangles(path).Triangles.size();
  std::size_t facets = given;
  Run asGiven;
  for (int times = 0; times <= subdivisions; ++times, facets *= 4)
  {
    std::array<Run, 2> runs; // on one thread and on two
    for (const int threads : { 1, 2 })
    {
      if (!MedianRun(path, times, threads, runs[threads - 1]))
      {
        std::printf("%s cannot be meshed in %d threads\n", path.c_str(), threads);
        return;
      }
      PrintRow(facets, threads, runs[threads - 1]);
    }
    if (times == 0)
    {
      asGiven = runs[1];
    }
    if (times == MeasuredSubdivisions)
    {
      const double growth = static_cast<double>(facets) / static_cast<double>(given);
      PrintRatio("threads/whole", runs[0].Whole() / runs[1].Whole(), ThreadsTarget);
      PrintRatio("scale/whole", runs[1].Whole() / (growth * asGiven.Whole()), ScaleTarget);
      PrintRatio("memory/whole", runs[1].Kibibytes / static_cast<double>(facets), MemoryTarget);
    }
  }
}
} // namespace

/**
 * BenchmarkWhole SURFACE [TIMES]: the whole pipeline on a surface, and on the surface subdivided
 * once, twice, up to TIMES times (2 by default), each time into four times as many facets. It
 * prints a table of the stages' seconds on one thread and on two, and of the memory. Lines as in
 * Measure.h.
 */
int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::printf("usage: BenchmarkWhole SURFACE [TIMES]\n");
    return 1;
  }
  try
  {
    Measure(argv[1], argc > 2 ? std::atoi(argv[2]) : MeasuredSubdivisions);
  }
  catch (const Error& error)
  {
    std::printf("%s: %s\n", argv[1], error.what());
  }
  return 0;
}
