// SPDX-License-Identifier: AGPL-3.0-or-later
#include "Measure.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/ReadTriangles.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Tetrahedralize/Ladder.h"
#include "Tetrahedralize/TetgenProcess.h"
#include "Validate/CountedChain.h"

#include <tetgen.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace insideout;
using namespace benchmark;

namespace
{
/** What TetGen's stage has to reach, over TetGen's library called directly. */
struct Target
{
  Limit Stage;    ///< seconds of the whole stage, with transfer and checks
  Limit Transfer; ///< seconds of TetGen in a process of its own, without checks
  Limit Memory;   ///< the helper's peak and what the host grows by
};

const std::map<std::string, Target> Targets = {
  { "Beast", { AtMost(1.25), AtMost(1.05), AtMost(1.5) } },
};

/** Surfaces on which our own engine takes no more time and memory than TetGen's library. */
const std::set<std::string> ExactTargets = { "Beast", "AlienSpaceObject", "camel", "man" };
constexpr Limit MostOfTetgen = AtMost(1);

/** Seconds per point at MostPoints over those at FewestPoints. */
constexpr Limit MostGrowth = AtMost(1.5);
constexpr int FewestPoints = 32000;
constexpr int MostPoints = 1000000;

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

/** What an engine made of a surface. */
struct Sizes
{
  Id SteinerPoints = 0;
  Id Cells = 0;
};

/** What any user of TetGen's library does, with the switches of the stage's first rung with it. */
Sizes RunTetgenDirectly(const FacetComplex& surface)
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
  return { output.numberofpoints - input.numberofpoints, output.numberoftetrahedra };
}

Tetrahedralization RunStage(const FacetComplex& surface, TetrahedralizationEngine engine)
{
  Monitor monitor;
  return ConstrainedDelaunay(surface, { 0, 0, engine }, monitor);
}

/** TetGen harms this process, too, where it cannot do what it is asked. */
bool TetgenManages(const std::string& name, const FacetComplex& surface)
{
  const bool manages = RunStage(surface, TetrahedralizationEngine::TetGen).Failures.empty();
  if (!manages)
  {
    std::printf("cdt/%s: TetGen fails with its first switches\n", name.c_str());
  }
  return manages;
}

/** TetGen in a process of its own, and checked, against its library. */
void MeasureTetgen(const std::string& name, const FacetComplex& surface)
{
  const std::vector<Triangle> constraints = ConstraintsOf(surface);
  const auto direct = [&] { RunTetgenDirectly(surface); };
  const auto inProcess = [&]
  {
    Monitor monitor;
    RunTetgen(surface.Points, constraints, {}, {}, monitor);
  };
  const auto stage =
    MedianSeconds([&] { RunStage(surface, TetrahedralizationEngine::TetGen); }, direct);
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

void PrintSizes(const char* engine, const Sizes& sizes, const char* from)
{
  std::printf(
    "%36s: %9d cells, %6d Steiner points  %s\n", engine, sizes.Cells, sizes.SteinerPoints, from);
}

/** An engine of ours against TetGen's library, where that manages. */
void MeasureEngine(const std::string& name, const FacetComplex& surface, bool tetgenManages,
  const char* word, TetrahedralizationEngine engine)
{
  const std::string row = std::string("cdt-") + word + "/" + name;
  const Tetrahedralization found = RunStage(surface, engine);
  const Id lost = static_cast<Id>(found.Mesh.LostFacets.size());
  PrintSizes(word, { found.Mesh.NumberOfSteinerPoints, found.Mesh.NumberOfCells() },
    (std::string(RungName(found.Rung)) + (lost ? ", facets lost: " + std::to_string(lost) : ""))
      .c_str());
  const auto ours = [&] { RunStage(surface, engine); };
  if (!tetgenManages)
  {
    PrintSeconds(row, surface.Facets.size(), word, "TetGen", { SecondsOf(ours), 0 });
    return;
  }
  const auto seconds = MedianSeconds(ours, [&] { RunTetgenDirectly(surface); });
  PrintSeconds(row, surface.Facets.size(), word, "TetGen", seconds);
  if (ExactTargets.count(name))
  {
    PrintRatio(row, seconds[0] / seconds[1], MostOfTetgen);
  }
}

void Measure(const std::string& path)
{
  const std::string name = StemOf(path);
  const FacetComplex surface = Resolved(path);
  const bool tetgenManages = TetgenManages(name, surface);
  if (tetgenManages)
  {
    MeasureTetgen(name, surface);
    PrintSizes("TetGen", RunTetgenDirectly(surface), "");
  }
  MeasureEngine(name, surface, tetgenManages, "exact", TetrahedralizationEngine::Exact);
  MeasureEngine(name, surface, tetgenManages, "automatic", TetrahedralizationEngine::Automatic);
}

/**
 * A closed surface of about this number of points, with waves, so that nothing in it is regular.
 */
FacetComplex WavyTorus(int points)
{
  const int side = static_cast<int>(std::sqrt(points));
  TriangleSoup soup;
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      const double u = 2 * M_PI * i / side;
      const double v = 2 * M_PI * j / side;
      const double radius = 1 + 0.1 * std::sin(5 * u + 0.3) * std::cos(7 * v + 0.7);
      const double fromAxis = 2.5 + radius * std::cos(v);
      soup.Points.push_back({ { fromAxis * std::cos(u), fromAxis * std::sin(u),
        radius * std::sin(v) + 0.2 * std::sin(3 * u) } });
      const auto at = [&](int k, int l)
      { return static_cast<Id>(((i + k) % side) * side + (j + l) % side); };
      soup.Triangles.push_back({ { at(0, 0), at(1, 0), at(1, 1) } });
      soup.Triangles.push_back({ { at(0, 0), at(1, 1), at(0, 1) } });
    }
  }
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

void MeasureGrowth()
{
  const FacetComplex small = WavyTorus(FewestPoints);
  const FacetComplex large = WavyTorus(MostPoints);
  const auto run = [](const FacetComplex& surface)
  { return [&surface] { RunStage(surface, TetrahedralizationEngine::Exact); }; };
  const std::array<double, 2> seconds = MedianSeconds(run(small), run(large));
  PrintSeconds("cdt-exact/torus", large.Facets.size(), "small", "large", seconds);
  const double growth = (seconds[1] / static_cast<double>(large.Points.size())) /
    (seconds[0] / static_cast<double>(small.Points.size()));
  PrintRatio("cdt-exact/growth", growth, MostGrowth);
}

/** MiB by which this process, forked for it, grows when it does the work. */
double MemoryOf(const std::function<void()>& work)
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
    work();
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
  const bool tetgenManages = TetgenManages(name, surface);
  const double host = HighWaterMark() - before;
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children); // before there are others than the helper
  const double helper = static_cast<double>(children.ru_maxrss) / 1024;
  const double exact = MemoryOf([&] { RunStage(surface, TetrahedralizationEngine::Exact); });
  if (!tetgenManages)
  {
    std::printf("memory cdt/%s exact %.1f MiB\n", name.c_str(), exact);
    return;
  }
  const double direct = MemoryOf([&] { RunTetgenDirectly(surface); });
  std::printf("memory cdt/%s exact %.1f MiB, helper %.1f MiB, host %.1f MiB, TetGen %.1f MiB\n",
    name.c_str(), exact, helper, host, direct);
  const auto target = Targets.find(name);
  if (target != Targets.end() && direct > 0)
  {
    PrintRatio("memory/cdt/" + name, (helper + host) / direct, target->second.Memory);
  }
  if (ExactTargets.count(name) && direct > 0)
  {
    PrintRatio("memory/cdt-exact/" + name, exact / direct, MostOfTetgen);
  }
}
} // namespace

/**
 * BenchmarkConstrainedDelaunay [--memory|--growth] SURFACE...: measures stage CDT on resolved
 * surfaces against TetGen's library: TetGen in its process, and both of our engines, with what they
 * make; or the memory that each takes at most; or how our own engine's time grows. With --tetgen
 * SURFACE it prints the seconds of TetGen's library alone, which has to manage. Lines as in
 * Measure.h; a surface that cannot be read is named and passed over. Where TetGen needs a second
 * try, or cannot do it at all, its library is not called.
 */
int main(int argc, char** argv)
{
  const std::string option = argc > 1 ? argv[1] : "";
  if (option == "--growth")
  {
    MeasureGrowth();
    return 0;
  }
  if (option == "--tetgen" && argc > 2)
  {
    const FacetComplex surface = Resolved(argv[2]);
    std::printf("%.4f\n", SecondsOf([&] { RunTetgenDirectly(surface); }));
    return 0;
  }
  const bool memory = option == "--memory";
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
