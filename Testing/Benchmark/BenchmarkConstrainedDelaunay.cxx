// SPDX-License-Identifier: AGPL-3.0-or-later
#include "ConstrainedDelaunay.h"
#include "CountedChain.h"
#include "Measure.h"
#include "ReadTriangles.h"
#include "ResolveSelfIntersections.h"
#include "TetgenProcess.h"

#include <tetgen.h>

#include <limits>
#include <map>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace insideout;
using namespace benchmark;

namespace
{
/** What a surface's stage has to reach, over TetGen's library called directly. */
struct Target
{
  Limit Stage;    ///< seconds of the whole stage, with transfer and checks
  Limit Transfer; ///< seconds of TetGen in a process of its own, without checks
  Limit Memory;   ///< the helper's peak and what the host grows by
};

const std::map<std::string, Target> Targets = {
  { "Beast", { AtMost(1.25), AtMost(1.05), AtMost(1.5) } },
};

FacetComplex Resolved(const std::string& path)
{
  Monitor monitor;
  return ResolveSelfIntersections(
    CountFacets(testmeshes::ReadTriangles(path), {}, monitor).Surface, monitor)
    .Surface;
}

std::vector<Triangle> ConstraintsOf(const FacetComplex& surface)
{
  return { surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints };
}

/** TetGen prints, whatever one tells it: while this object lives, to nowhere. */
class Silence
{
public:
  Silence()
    : Saved(dup(STDOUT_FILENO))
  {
    std::fflush(stdout);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    close(nowhere);
  }
  ~Silence()
  {
    std::fflush(stdout);
    dup2(this->Saved, STDOUT_FILENO);
    close(this->Saved);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  const int Saved;
};

/** What any user of TetGen's library does, with the switches of the stage's first rung. */
void RunTetgenDirectly(const FacetComplex& surface)
{
  tetgenio input;
  tetgenio output;
  input.numberofpoints = static_cast<int>(surface.Points.size());
  input.pointlist = new double[3 * surface.Points.size()];
  std::copy_n(surface.Points[0].data(), 3 * surface.Points.size(), input.pointlist);
  input.numberoffacets = static_cast<int>(surface.NumberOfConstraints);
  input.facetlist = new tetgenio::facet[surface.Facets.size()];
  input.facetmarkerlist = new int[surface.Facets.size()];
  for (int f = 0; f < input.numberoffacets; ++f)
  {
    tetgenio::facet& facet = input.facetlist[f];
    tetgenio::init(&facet);
    facet.polygonlist = new tetgenio::polygon[1];
    facet.numberofpolygons = 1;
    tetgenio::init(&facet.polygonlist[0]);
    facet.polygonlist[0].vertexlist = new int[3];
    facet.polygonlist[0].numberofvertices = 3;
    std::copy_n(surface.Facets[f].data(), 3, facet.polygonlist[0].vertexlist);
    input.facetmarkerlist[f] = f + 1;
  }
  char switches[] = "cJQpMY";
  tetgenbehavior behavior;
  behavior.parse_commandline(switches);
  behavior.epsilon = 1e-13;
  behavior.minedgelength = std::numeric_limits<double>::min();
  const Silence silence;
  tetrahedralize(&behavior, &input, &output);
}

/** With TetGen. @return whether the first rung answered */
bool RunStage(const FacetComplex& surface)
{
  Monitor monitor;
  return ConstrainedDelaunay(surface, { 0, 0, TetrahedralizationEngine::TetGen }, monitor)
    .Failures.empty();
}

/** TetGen harms this process, too, where it cannot do what it is asked. */
bool TetgenManages(const std::string& name, const FacetComplex& surface)
{
  const bool manages = RunStage(surface);
  if (!manages)
  {
    std::printf("cdt/%s: TetGen fails with the switches of the first rung\n", name.c_str());
  }
  return manages;
}

void Measure(const std::string& path)
{
  const std::string name = StemOf(path);
  const FacetComplex surface = Resolved(path);
  if (!TetgenManages(name, surface))
  {
    return;
  }
  const std::vector<Triangle> constraints = ConstraintsOf(surface);
  const auto direct = [&] { RunTetgenDirectly(surface); };
  const auto inProcess = [&]
  {
    Monitor monitor;
    RunTetgen(surface.Points, constraints, {}, {}, monitor);
  };
  const auto stage = MedianSeconds([&] { RunStage(surface); }, direct);
  const auto transfer = MedianSeconds(inProcess, direct);
  PrintSeconds("cdt/" + name, surface.Facets.size(), "stage", "TetGen", stage);
  PrintSeconds("cdt/transfer/" + name, surface.Facets.size(), "process", "TetGen", transfer);
  const auto target = Targets.find(name);
  if (target != Targets.end())
  {
    PrintRatio("cdt/" + name, stage[0] / stage[1], target->second.Stage);
    PrintRatio("cdt/transfer/" + name, transfer[0] / transfer[1], target->second.Transfer);
  }
}

/** MiB by which this process, forked for it, grows when it runs TetGen. */
double MemoryOfTetgen(const FacetComplex& surface)
{
  int ends[2];
  double grown = 0;
  if (pipe(ends) != 0)
  {
    return 0;
  }
  const pid_t child = fork();
  if (child == 0)
  {
    const double before = ResetHighWaterMark();
    RunTetgenDirectly(surface);
    grown = HighWaterMark() - before;
    _exit(write(ends[1], &grown, sizeof(grown)) == sizeof(grown) ? 0 : 1);
  }
  close(ends[1]);
  if (read(ends[0], &grown, sizeof(grown)) != sizeof(grown))
  {
    grown = 0;
  }
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return grown;
}

/** In a process of its own, for memory that was used once stays with the process. */
void MeasureMemory(const std::string& path)
{
  const std::string name = StemOf(path);
  const FacetComplex surface = Resolved(path);
  const double before = ResetHighWaterMark();
  if (!TetgenManages(name, surface))
  {
    return;
  }
  const double host = HighWaterMark() - before;
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  const double helper = static_cast<double>(children.ru_maxrss) / 1024;
  const double direct = MemoryOfTetgen(surface);
  std::printf("memory cdt/%s helper %.1f MiB, host %.1f MiB, TetGen %.1f MiB\n", name.c_str(),
    helper, host, direct);
  const auto target = Targets.find(name);
  if (target != Targets.end() && direct > 0)
  {
    PrintRatio("memory/cdt/" + name, (helper + host) / direct, target->second.Memory);
  }
}
} // namespace

/**
 * BenchmarkConstrainedDelaunay [--memory] SURFACE...: measures stage CDT on resolved surfaces
 * against TetGen's library, or the memory that each takes at most. Lines as in Measure.h; a surface
 * that cannot be read is named and passed over, and so is one where TetGen needs a second try.
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
