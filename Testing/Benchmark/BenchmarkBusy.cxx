// SPDX-License-Identifier: GPL-3.0-or-later
#include "GraphCut/SegmentMesh.h"
#include "Measure.h"
#include "Output/BoundaryTriangles.h"
#include "Output/InsideBoundary.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/ReadTriangles.h"
#include "Support/TestMeshes.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Validate/CountedChain.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <array>
#include <cmath>
#include <csignal>
#include <vector>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace insideout;
using namespace benchmark;

namespace
{
/** On two processors, two threads that share them fairly with two others take twice their time. */
constexpr Limit Target = AtMost(3);

constexpr int Rounds = 7;
constexpr double SecondsPerSample =
  0.3; ///< so long that the scheduler shares the processors fairly

/** Two processes that do nothing but keep the processors busy, and end with this one. */
class BusyProcesses
{
public:
  BusyProcesses()
  {
    for (pid_t& process : this->Processes)
    {
      process = fork();
      if (process == 0)
      {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (volatile unsigned turns = 0;; turns = turns + 1)
        {
        }
      }
    }
    this->Pause();
  }
  ~BusyProcesses()
  {
    this->Send(SIGKILL);
    for (const pid_t process : this->Processes)
    {
      waitpid(process, nullptr, 0);
    }
  }
  BusyProcesses(const BusyProcesses&) = delete;
  BusyProcesses& operator=(const BusyProcesses&) = delete;

  void Pause() { this->Send(SIGSTOP); }
  void Resume() { this->Send(SIGCONT); }

private:
  void Send(int signal)
  {
    for (const pid_t process : this->Processes)
    {
      if (process > 0)
      {
        kill(process, signal);
      }
    }
  }

  std::array<pid_t, 2> Processes;
};

/** A sphere of 320 triangles, its poles on the z axis. */
TriangleSoup Sphere(const Point& centre)
{
  constexpr Id sectors = 16;
  constexpr Id rings = 10;
  const double pi = std::acos(-1.0);
  TriangleSoup sphere;
  sphere.Points = { { centre[0], centre[1], centre[2] + 1 },
    { centre[0], centre[1], centre[2] - 1 } };
  for (Id i = 0; i < rings * sectors; ++i)
  {
    const double polar = pi * (i / sectors + 1) / (rings + 1);
    const double around = 2 * pi * (i % sectors) / sectors;
    sphere.Points.push_back({ centre[0] + std::sin(polar) * std::cos(around),
      centre[1] + std::sin(polar) * std::sin(around), centre[2] + std::cos(polar) });
  }
  const auto at = [](Id ring, Id sector) { return 2 + ring * sectors + sector % sectors; };
  for (Id k = 0; k < sectors; ++k)
  {
    sphere.Triangles.push_back({ 0, at(0, k), at(0, k + 1) });
    sphere.Triangles.push_back({ 1, at(rings - 1, k + 1), at(rings - 1, k) });
    for (Id ring = 0; ring + 1 < rings; ++ring)
    {
      sphere.Triangles.push_back({ at(ring, k), at(ring + 1, k), at(ring + 1, k + 1) });
      sphere.Triangles.push_back({ at(ring, k), at(ring + 1, k + 1), at(ring, k + 1) });
    }
  }
  return sphere;
}

/** Two spheres that cross, 640 triangles. */
TriangleSoup CrossingSpheres()
{
  return testmeshes::Join(Sphere({ 0, 0, 0 }), Sphere({ 0.5, 0.25, 0.125 }));
}

/** Every stage, and what it works on. */
class Pipeline
{
public:
  explicit Pipeline(TriangleSoup soup)
    : Soup(std::move(soup))
  {
    this->Whole();
  }

  void Validate() { this->Counted = CountFacets(this->Soup, {}, this->Silent).Surface; }
  void Resolve() { this->Resolved = ResolveSelfIntersections(this->Counted, this->Silent).Surface; }
  void Tetrahedralize()
  {
    this->Mesh =
      ConstrainedDelaunay(this->Resolved, { 0, 0, TetrahedralizationEngine::Exact }, this->Silent)
        .Mesh;
  }
  void FindWindingNumbers()
  {
    this->W = WindingNumberOfCells(this->Resolved, this->Mesh, this->Silent);
  }
  void Cut() { this->Inside = SegmentMesh(this->Mesh, this->W, {}, {}, {}, this->Silent).Inside; }
  void Extract()
  {
    const ProgressRange progress = { "extracting", 0, 1 };
    this->Boundary = BoundaryTriangles(this->Resolved, this->Mesh,
      BoundaryFaces(this->Mesh, this->Inside, this->Silent, progress), this->Silent, progress);
  }
  void Whole()
  {
    this->Validate();
    this->Resolve();
    this->Tetrahedralize();
    this->FindWindingNumbers();
    this->Cut();
    this->Extract();
  }

  std::size_t NumberOfTriangles() const { return this->Soup.Triangles.size(); }

private:
  Monitor Silent;
  TriangleSoup Soup;
  FacetComplex Counted;
  FacetComplex Resolved;
  TetrahedralMesh Mesh;
  std::vector<double> W;
  std::vector<unsigned char> Inside;
  std::vector<BoundaryTriangle> Boundary;
};

/** The time of one call, from a number of calls that takes several time slices. */
double MeanSeconds(const std::function<void()>& work, int calls)
{
  return SecondsOf(
           [&]
           {
             for (int call = 0; call < calls; ++call)
             {
               work();
             }
           }) /
    calls;
}

/** Median seconds beside the busy processes, and on the machine as it is, by turns. */
std::array<double, 2> BusyAndQuietSeconds(BusyProcesses& others, const std::function<void()>& work)
{
  const int calls = static_cast<int>(SecondsPerSample / SecondsOf(work)) + 1;
  std::array<std::vector<double>, 2> seconds;
  for (int round = 0; round < Rounds; ++round)
  {
    others.Resume();
    seconds[0].push_back(MeanSeconds(work, calls));
    others.Pause();
    seconds[1].push_back(MeanSeconds(work, calls));
  }
  return { Median(seconds[0]), Median(seconds[1]) };
}

void Measure(const TriangleSoup& soup, const std::string& suffix)
{
  using Stage = void (Pipeline::*)();
  const std::pair<const char*, Stage> measured[] = { { "validate", &Pipeline::Validate },
    { "resolve", &Pipeline::Resolve }, { "cdt", &Pipeline::Tetrahedralize },
    { "w", &Pipeline::FindWindingNumbers }, { "cut", &Pipeline::Cut },
    { "output", &Pipeline::Extract }, { "whole", &Pipeline::Whole } };
  Pipeline pipeline(soup);
  BusyProcesses others;
  for (const auto& [stage, function] : measured)
  {
    const std::string name = std::string("busy/") + stage + suffix;
    const auto seconds =
      BusyAndQuietSeconds(others, [&pipeline, run = function] { (pipeline.*run)(); });
    PrintSeconds(name, pipeline.NumberOfTriangles(), "busy", "quiet", seconds);
    PrintRatio(name, seconds[0] / seconds[1], Target);
  }
}
} // namespace

/**
 * BenchmarkBusy SURFACE...: times every stage on 640 facets, and on small surfaces, beside two busy
 * processes and without them. Lines as in Measure.h; a surface that cannot be meshed is named and
 * passed over.
 */
int main(int argc, char** argv)
{
  Measure(CrossingSpheres(), "");
  for (int i = 1; i < argc; ++i)
  {
    try
    {
      Measure(testmeshes::ReadTriangles(argv[i]), "/" + StemOf(argv[i]));
    }
    catch (const Error& error)
    {
      std::printf("%s: %s\n", argv[i], error.what());
    }
  }
  return 0;
}
