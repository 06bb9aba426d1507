// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/Ladder.h"

#include "Common/Stages.h"
#include "Common/Statistics.h"
#include "Exact/ExactTetrahedralization.h"
#include "Tetrahedralize/AssembleMesh.h"
#include "Tetrahedralize/DelaunayOfPoints.h"
#include "Tetrahedralize/TetgenProcess.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** The input of a rung. */
struct Attempt
{
  const FacetComplex& Surface;
  TetrahedralizerBudget Budget;
  Monitor& Caller;
};

TetrahedralMesh UseTetgen(const Attempt& attempt, SurfaceSteinerPoints steiner)
{
  const FacetComplex& surface = attempt.Surface;
  const std::vector<Triangle> constraints(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  return AssembleMesh(surface,
    RunTetgen(surface.Points, constraints, steiner, attempt.Budget, attempt.Caller),
    attempt.Caller);
}

TetrahedralMesh KeepPointsOffFacets(const Attempt& attempt)
{
  return UseTetgen(attempt, SurfaceSteinerPoints::Avoid);
}

TetrahedralMesh LeavePointsOnFacets(const Attempt& attempt)
{
  return UseTetgen(attempt, SurfaceSteinerPoints::Leave);
}

/**
 * Stop the exact rung when the user's time budget is used up; without a budget there is no clock.
 */
class DeadlineMonitor : public Monitor
{
public:
  DeadlineMonitor(double seconds, Monitor& caller)
    : Seconds(seconds)
    , Caller(caller)
  {
  }

  bool Continue(const char*, double fraction) override
  {
    this->Elapsed += this->Watch.Lap();
    if (this->Elapsed > this->Seconds)
    {
      throw Error(ErrorCode::TetrahedralizerFailed, "it took more than the time it may");
    }
    return this->Caller.Continue(Stages::Tetrahedralizing, ShareOfProgress * fraction);
  }

private:
  static constexpr double ShareOfProgress = 0.9; ///< AssembleMesh does the rest

  const double Seconds;
  Monitor& Caller;
  Stopwatch Watch;
  double Elapsed = 0;
};

TetrahedralMesh FlipAndCutExactly(const Attempt& attempt)
{
  DeadlineMonitor deadline(attempt.Budget.Seconds, attempt.Caller);
  const FacetComplex& surface = attempt.Surface;
  ExactTetrahedralization exact = TetrahedralizeExactly(surface.Points,
    { surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints }, deadline);
  return AssembleMesh(surface, std::move(exact.Tetrahedra), attempt.Caller);
}

TetrahedralMesh IgnoreFacets(const Attempt& attempt)
{
  return AssembleMesh(attempt.Surface,
    DelaunayOfPoints(attempt.Surface.Points, attempt.Budget.Mebibytes, attempt.Caller),
    attempt.Caller);
}

using Engine = TetrahedralizationEngine;

struct Rung
{
  const char* Name;
  TetrahedralMesh (*Try)(const Attempt&);
  std::vector<Engine> Engines; ///< engines that have the rung
};

/**
 * The exact rung comes first by measurement (ConstrainedDelaunay.h). TetGen crashes most often
 * while it removes Steiner points from facets, or because of the tetrahedra that it starts from.
 * Its second rung therefore keeps these points and starts from others. Together the two keep every
 * facet of each surface for which any of five settings does.
 */
const Rung Ladder[] = {
  { "exact flips and cuts", FlipAndCutExactly, { Engine::Automatic, Engine::Exact } },
  { "TetGen, points kept off facets", KeepPointsOffFacets, { Engine::Automatic, Engine::TetGen } },
  { "TetGen, points left on facets", LeavePointsOnFacets, { Engine::Automatic, Engine::TetGen } },
  { "Delaunay tetrahedra of the points alone", IgnoreFacets,
    { Engine::Automatic, Engine::Exact, Engine::TetGen } },
};
constexpr int NumberOfRungs = sizeof(Ladder) / sizeof(Ladder[0]);
} // namespace

const char* RungName(int rung)
{
  return rung >= 1 && rung <= NumberOfRungs ? Ladder[rung - 1].Name : nullptr;
}

std::vector<int> RungsOf(Engine engine)
{
  std::vector<int> rungs;
  for (int rung = 1; rung <= NumberOfRungs; ++rung)
  {
    const std::vector<Engine>& engines = Ladder[rung - 1].Engines;
    if (std::find(engines.begin(), engines.end(), engine) != engines.end())
    {
      rungs.push_back(rung);
    }
  }
  return rungs;
}

TetrahedralMesh TryRung(
  int rung, const FacetComplex& surface, const TetrahedralizerBudget& budget, Monitor& monitor)
{
  return Ladder[rung - 1].Try({ surface, budget, monitor });
}
} // namespace insideout
