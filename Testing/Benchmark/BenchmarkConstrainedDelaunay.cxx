// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The whole CDT stage, with transfer and checks, against TetGen's library called directly with the
// switches of the stage's first rung, both on the resolved surface:
//
//   BenchmarkConstrainedDelaunay SURFACE...
//
// Times are medians of runs by turns. Memory is that of processes of their own: TetGen's peak, and
// the helper's peak and what the host grew by, each above what it held when the surface was there.

#include "ConstrainedDelaunay.h"
#include "CountedChain.h"
#include "ResolveSelfIntersections.h"
#include "Statistics.h"
#include "SurfaceFile.h"

#include <tetgen.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace insideout;

namespace
{
constexpr int Runs = 5;

FacetComplex ReadResolved(const char* path)
{
  Monitor monitor;
  const PolygonSurface polygons = ReadSurface(path, monitor);
  TriangleSoup soup;
  soup.Points = polygons.Points;
  for (std::size_t p = 0; p + 1 < polygons.Offsets.size(); ++p)
  {
    const Id first = polygons.Offsets[p];
    for (Id k = first + 1; k + 1 < polygons.Offsets[p + 1]; ++k)
    {
      soup.Triangles.push_back(
        { polygons.Corners[first], polygons.Corners[k], polygons.Corners[k + 1] });
    }
  }
  return ResolveSelfIntersections(CountFacets(soup, {}, monitor).Surface, monitor).Surface;
}

/** What any user of TetGen's library does: fill its structures, run it. */
void RunTetgenDirectly(const FacetComplex& surface)
{
  tetgenio input;
  tetgenio output;
  input.numberofpoints = static_cast<int>(surface.Points.size());
  input.pointlist = new double[3 * surface.Points.size()];
  std::copy_n(surface.Points[0].data(), 3 * surface.Points.size(), input.pointlist);
  input.numberoffacets = surface.NumberOfConstraints;
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
  tetrahedralize(&behavior, &input, &output);
}

double MebibytesNow()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    double kibibytes;
    if (word == "VmRSS:" && status >> kibibytes)
    {
      return kibibytes / 1024;
    }
  }
  return 0;
}

/** By how many MiB work makes a process grow at most, and the largest of its children's peaks. */
struct Growth
{
  double Own;
  double Child;
};

template <typename Work>
Growth GrowthIn(const Work& work)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    std::exit(1);
  }
  const pid_t child = fork();
  if (child == 0)
  {
    malloc_trim(0);
    // The peak so far is forgotten.
    std::ofstream("/proc/self/clear_refs") << "5";
    const double before = MebibytesNow();
    work();
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    std::ifstream status("/proc/self/status");
    double peak = 0;
    for (std::string word; status >> word;)
    {
      if (word == "VmHWM:")
      {
        status >> peak;
      }
    }
    const Growth growth = { peak / 1024 - before, static_cast<double>(children.ru_maxrss) / 1024 };
    _exit(write(ends[1], &growth, sizeof(growth)) == sizeof(growth) ? 0 : 1);
  }
  Growth growth = { 0, 0 };
  waitpid(child, nullptr, 0);
  if (read(ends[0], &growth, sizeof(growth)) != sizeof(growth))
  {
    std::exit(1);
  }
  close(ends[0]);
  close(ends[1]);
  return growth;
}

double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

std::string NameOf(const std::string& path)
{
  const std::string file = path.substr(path.rfind('/') + 1);
  return file.substr(0, file.rfind('.'));
}

/** TetGen prints, whatever one tells it. */
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

private:
  const int Saved;
};

void Measure(const char* path)
{
  const std::string name = NameOf(path);
  const FacetComplex surface = ReadResolved(path);
  Tetrahedralization result;
  const auto stage = [&]()
  {
    Monitor monitor;
    result = ConstrainedDelaunay(surface, {}, monitor);
  };
  const auto direct = [&]()
  {
    const Silence silence;
    RunTetgenDirectly(surface);
  };
  stage(); // warms up, too
  if (result.Rung != 1)
  {
    std::printf("%s: TetGen fails with these switches\n", name.c_str());
    return;
  }
  std::vector<double> stageSeconds;
  std::vector<double> directSeconds;
  for (int run = 0; run < Runs; ++run)
  {
    Stopwatch stopwatch;
    direct();
    directSeconds.push_back(stopwatch.Lap());
    stage();
    stageSeconds.push_back(stopwatch.Lap());
  }
  result = {};
  const Growth stageGrowth = GrowthIn(stage);
  const Growth directGrowth = GrowthIn(direct);
  std::printf(
    "%s: stage %.3f s, TetGen %.3f s; helper %.1f MiB and host %.1f MiB, TetGen %.1f MiB\n",
    name.c_str(), Median(stageSeconds), Median(directSeconds), stageGrowth.Child, stageGrowth.Own,
    directGrowth.Own);
  std::printf(
    "ratio cdt/%s %.3f at most 1.25\n", name.c_str(), Median(stageSeconds) / Median(directSeconds));
  std::printf("ratio memory/cdt/%s %.3f at most 1.5\n", name.c_str(),
    (stageGrowth.Child + stageGrowth.Own) / directGrowth.Own);
}
} // namespace

int main(int count, char** arguments)
{
  for (int k = 1; k < count; ++k)
  {
    Measure(arguments[k]);
  }
  return 0;
}
