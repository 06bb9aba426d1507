// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/ConstrainedDelaunay.h"

#include "Common/Statistics.h"
#include "Exact/ExactTetrahedralization.h"
#include "Tetrahedralize/AssembleMesh.h"
#include "Tetrahedralize/DelaunayOfPoints.h"
#include "Tetrahedralize/TetgenProcess.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <optional>
#include <string>

#include <unistd.h>

namespace insideout
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/**
 * TetGen squares and cubes lengths, and its predicates (Shewchuk 1997) are exact only while
 * products of five coordinates neither over- nor underflow: sizes beyond 2 to this power (up or
 * down) are brought to 1 for it.
 */
constexpr int LargestExponent = 32;

void CheckParameters(const ConstrainedDelaunayParameters& parameters)
{
  // Written so that a NaN is refused, too.
  if (!(parameters.TimeBudget >= 0) || !(parameters.MemoryBudget >= 0))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the time and memory budgets have to be at least 0, where 0 is the default");
  }
}

void CheckIdsAndCoordinates(const FacetComplex& surface)
{
  if (surface.Facets.empty())
  {
    throw Error(ErrorCode::EmptySurface, "the surface has no facet");
  }
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    for (const double x : surface.Points[p])
    {
      if (!std::isfinite(x))
      {
        throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(p) + " is not finite");
      }
    }
  }
  for (std::size_t f = 0; f < surface.Facets.size(); ++f)
  {
    for (const Id p : surface.Facets[f])
    {
      if (p < 0 || static_cast<std::size_t>(p) >= surface.Points.size())
      {
        throw Error(ErrorCode::PointOutOfRange,
          "facet " + std::to_string(f) + " refers to point " + std::to_string(p) + " of " +
            std::to_string(surface.Points.size()));
      }
    }
  }
}

/** Points in general position so far, one more for each dimension they span. */
void CheckSpansSpace(const std::vector<Point>& points)
{
  std::vector<Kernel::Point_3> base;
  for (const Point& point : points)
  {
    const Kernel::Point_3 p(point[0], point[1], point[2]);
    const bool independent = base.empty() || (base.size() == 1 && p != base[0]) ||
      (base.size() == 2 && !CGAL::collinear(base[0], base[1], p)) ||
      (base.size() == 3 && !CGAL::coplanar(base[0], base[1], base[2], p));
    if (independent)
    {
      base.push_back(p);
      if (base.size() == 4)
      {
        return;
      }
    }
  }
  const std::array<const char*, 3> where = { { "at one point", "on one line", "in one plane" } };
  throw Error(ErrorCode::Planar,
    std::string("all facets lie ") + where[base.size() - 1] + ", so there is no volume to fill");
}

/** The power of two that all coordinates are below; 0 for sizes that TetGen copes with. */
int ExponentToRemove(const std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& point : points)
  {
    for (const double x : point)
    {
      largest = std::max(largest, std::abs(x));
    }
  }
  const int exponent = std::ilogb(largest) + 1;
  return std::abs(exponent) > LargestExponent ? exponent : 0;
}

void Scale(std::vector<Point>& points, int exponent)
{
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x = std::ldexp(x, exponent);
    }
  }
}

constexpr const char* Stage = "tetrahedralizing";

// --- The ladder ----------------------------------------------------------------------------------

/** What a rung has to go by. */
struct Attempt
{
  const FacetComplex& Surface;
  TetgenBudget Budget;
  Monitor& Caller;
};

TetrahedralMesh UseTetgen(const Attempt& attempt, const TetgenOptions& options)
{
  const FacetComplex& surface = attempt.Surface;
  const std::vector<Triangle> constraints(
    surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints);
  return AssembleMesh(surface,
    RunTetgen(surface.Points, constraints, options, attempt.Budget, attempt.Caller),
    attempt.Caller);
}

TetrahedralMesh KeepPointsOffFacets(const Attempt& attempt)
{
  return UseTetgen(attempt, { SurfaceSteinerPoints::Avoid });
}

TetrahedralMesh FlipInGivenOrder(const Attempt& attempt)
{
  return UseTetgen(attempt, { SurfaceSteinerPoints::Avoid, true, true });
}

TetrahedralMesh LeavePointsOnFacets(const Attempt& attempt)
{
  return UseTetgen(attempt, { SurfaceSteinerPoints::Leave });
}

TetrahedralMesh LeavePointsAndFlipInGivenOrder(const Attempt& attempt)
{
  return UseTetgen(attempt, { SurfaceSteinerPoints::Leave, true, true });
}

TetrahedralMesh PutPointsOnFacets(const Attempt& attempt)
{
  return UseTetgen(attempt, { SurfaceSteinerPoints::Allow });
}

/** Ends the exact rung when its time is over: it has no process of its own to be killed. */
class DeadlineMonitor : public Monitor
{
public:
  DeadlineMonitor(const TetgenBudget& budget, Monitor& caller)
    : Budget(budget)
    , Caller(caller)
    , ProcessorStart(ProcessorSeconds())
  {
  }

  bool Continue(const char*, double) override
  {
    this->Elapsed += this->Watch.Lap();
    if (this->Elapsed > this->Budget.Seconds ||
      ProcessorSeconds() - this->ProcessorStart > this->Budget.ProcessorSeconds)
    {
      throw Error(ErrorCode::TetrahedralizerFailed, "it took more than the time it may");
    }
    return this->Caller.Continue(Stage, 0);
  }

private:
  static double ProcessorSeconds()
  {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  const TetgenBudget& Budget;
  Monitor& Caller;
  Stopwatch Watch;
  double Elapsed = 0;
  const double ProcessorStart;
};

TetrahedralMesh FlipAndCutExactly(const Attempt& attempt)
{
  /** Nearly all surfaces need much less, and those for which the other rungs are worse need it. */
  constexpr double Patience = 5;
  TetgenBudget budget = attempt.Budget;
  budget.ProcessorSeconds *= Patience;
  DeadlineMonitor deadline(budget, attempt.Caller);
  const FacetComplex& surface = attempt.Surface;
  ExactTetrahedralization exact = TetrahedralizeExactly(surface.Points,
    { surface.Facets.begin(), surface.Facets.begin() + surface.NumberOfConstraints }, deadline);
  return AssembleMesh(surface,
    { std::move(exact.Points), std::move(exact.Cells), std::move(exact.Faces),
      std::move(exact.FacetOfFaces) },
    attempt.Caller);
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
  std::vector<Engine> Engines; ///< that have it
};

/**
 * The exact way comes first by what was measured (ConstrainedDelaunay.h). TetGen crashes most often
 * where it takes Steiner points out of facets again. Only its first two rungs try that: else some
 * tens of them are left. Where else it crashes depends on the tetrahedra that it begins with, so
 * that another way to these helps. With points wherever it likes there are ten times as many as the
 * facets have corners.
 */
const Rung Ladder[] = {
  { "exact flips and cuts", FlipAndCutExactly, { Engine::Automatic, Engine::Exact } },
  { "TetGen, points kept off facets", KeepPointsOffFacets, { Engine::Automatic, Engine::TetGen } },
  { "TetGen, points kept off facets, flips in the order given", FlipInGivenOrder,
    { Engine::Automatic, Engine::TetGen } },
  { "TetGen, points left on facets", LeavePointsOnFacets, { Engine::Automatic, Engine::TetGen } },
  { "TetGen, points left on facets, flips in the order given", LeavePointsAndFlipInGivenOrder,
    { Engine::Automatic, Engine::TetGen } },
  { "TetGen, points put on facets", PutPointsOnFacets, { Engine::Automatic, Engine::TetGen } },
  { "Delaunay tetrahedra of the points alone", IgnoreFacets,
    { Engine::Automatic, Engine::Exact, Engine::TetGen } },
};
constexpr int NumberOfRungs = sizeof(Ladder) / sizeof(Ladder[0]);

/** The rungs that an engine has, counted from 1. */
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

/** Whether another rung may do better where this was thrown. */
bool IsFailureOfARung(const Error& error)
{
  return error.Code == ErrorCode::TetrahedralizerDied ||
    error.Code == ErrorCode::TetrahedralizerFailed || error.Code == ErrorCode::Inconsistent ||
    error.Code == ErrorCode::TooLarge;
}

/** Later rungs begin anew; whoever watches sees no step back. */
class ForwardMonitor : public Monitor
{
public:
  explicit ForwardMonitor(Monitor& caller)
    : Caller(caller)
  {
  }

  bool Continue(const char* stage, double fraction) override
  {
    this->Furthest = std::max(this->Furthest, fraction);
    return this->Caller.Continue(stage, this->Furthest);
  }

private:
  Monitor& Caller;
  double Furthest = 0;
};

/** What each rung may use up. */
TetgenBudget BudgetOfARung(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters)
{
  constexpr double MinimumSeconds = 4;
  constexpr double SecondsPerElement = 3e-4;
  constexpr double SlowestMachine = 10;
  constexpr double MinimumMebibytes = 1024;
  constexpr double MebibytesPerElement = 1.0 / 64;
  constexpr double ShareOfMachine = 0.75;
  const double elements = static_cast<double>(surface.Points.size() + surface.Facets.size());
  TetgenBudget budget;
  if (parameters.TimeBudget > 0)
  {
    budget.Seconds = parameters.TimeBudget / static_cast<double>(RungsOf(parameters.Engine).size());
  }
  else
  {
    budget.ProcessorSeconds = MinimumSeconds + SecondsPerElement * elements;
    budget.Seconds = SlowestMachine * budget.ProcessorSeconds;
  }
  const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
    static_cast<double>(sysconf(_SC_PAGE_SIZE)) / (1024 * 1024);
  budget.Mebibytes = parameters.MemoryBudget > 0
    ? parameters.MemoryBudget
    : std::min(MinimumMebibytes + MebibytesPerElement * elements, ShareOfMachine * machine);
  return budget;
}

/** Down the ladder until a mesh has every facet. */
Tetrahedralization Climb(const FacetComplex& surface, TetrahedralizationEngine engine,
  const TetgenBudget& budget, Monitor& monitor)
{
  ForwardMonitor forward(monitor);
  Tetrahedralization best;
  std::optional<Error> lastError;
  for (const int rung : RungsOf(engine))
  {
    std::string failure;
    try
    {
      TetrahedralMesh mesh = Ladder[rung - 1].Try({ surface, budget, forward });
      const std::size_t lost = mesh.LostFacets.size();
      if (best.Rung == 0 || lost < best.Mesh.LostFacets.size())
      {
        best.Mesh = std::move(mesh);
        best.Rung = rung;
      }
      if (lost == 0)
      {
        return best;
      }
      failure = "it loses " + std::to_string(lost) + " facets";
    }
    catch (const Error& error)
    {
      if (!IsFailureOfARung(error))
      {
        throw;
      }
      failure = error.what();
      lastError.emplace(error);
    }
    best.Failures.push_back(std::string(Ladder[rung - 1].Name) + ": " + failure);
  }
  if (best.Rung == 0)
  {
    throw Error(*lastError);
  }
  return best;
}
} // namespace

const char* RungName(int rung)
{
  return rung >= 1 && rung <= NumberOfRungs ? Ladder[rung - 1].Name : nullptr;
}

Tetrahedralization ConstrainedDelaunay(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters, Monitor& monitor)
{
  CheckParameters(parameters);
  CheckIdsAndCoordinates(surface);
  CheckSpansSpace(surface.Points);
  const TetgenBudget budget = BudgetOfARung(surface, parameters);
  const int exponent = ExponentToRemove(surface.Points);
  FacetComplex scaled;
  if (exponent != 0)
  {
    scaled = surface;
    Scale(scaled.Points, -exponent);
    std::vector<Point> restored = scaled.Points;
    Scale(restored, exponent);
    // Where the smallest coordinates would lose bits, the rungs have to cope.
    if (restored == surface.Points)
    {
      Tetrahedralization result = Climb(scaled, parameters.Engine, budget, monitor);
      Scale(result.Mesh.Points, exponent);
      return result;
    }
  }
  return Climb(surface, parameters.Engine, budget, monitor);
}

TetrahedralMesh ConstrainedDelaunay(const FacetComplex& surface, Monitor& monitor)
{
  return ConstrainedDelaunay(surface, {}, monitor).Mesh;
}
} // namespace insideout
