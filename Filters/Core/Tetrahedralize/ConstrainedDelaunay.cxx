// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/ConstrainedDelaunay.h"

#include "Common/Kernel.h"
#include "Common/MachineMemory.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Tetrahedralize/Ladder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace insideout
{
namespace
{
/**
 * Inputs larger than 2 to this power, or smaller than its inverse, are scaled to size 1 for all
 * rungs. TetGen squares and cubes lengths, and its predicates (Shewchuk 1997) are exact only while
 * products of five coordinates neither over- nor underflow.
 */
constexpr int MostExponent = 32;

void CheckParameters(const ConstrainedDelaunayParameters& parameters)
{
  // Negated, so that NaN is refused too.
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
    if (!IsFinite(surface.Points[p]))
    {
      throw Error(ErrorCode::PointNotFinite, "point " + std::to_string(p) + " is not finite");
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

/** Collects affinely independent points, one more than the dimension they span, up to four. */
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

/** Whether another rung may succeed after this error. */
bool IsFailureOfARung(const Error& error)
{
  return error.Code == ErrorCode::TetrahedralizerDied ||
    error.Code == ErrorCode::TetrahedralizerFailed || error.Code == ErrorCode::Inconsistent ||
    error.Code == ErrorCode::TooLarge;
}

/** The budget of each rung. */
TetrahedralizerBudget BudgetOfARung(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters)
{
  // Limits against endless runs: many times TetGen's usual processor time, five times its usual
  // memory.
  constexpr double MinimumSeconds = 4;
  constexpr double SecondsPerElement = 3e-4;
  constexpr double MinimumMebibytes = 1024;
  constexpr double MebibytesPerElement = 1.0 / 64;
  constexpr double ShareOfMachine = 0.75;
  const double elements = static_cast<double>(surface.Points.size() + surface.Facets.size());
  TetrahedralizerBudget budget;
  if (parameters.TimeBudget > 0)
  {
    budget.Seconds = parameters.TimeBudget / static_cast<double>(RungsOf(parameters.Engine).size());
  }
  else
  {
    budget.ProcessorSeconds = MinimumSeconds + SecondsPerElement * elements;
  }
  const double machine = MachineMemory() / (1024 * 1024);
  budget.Mebibytes = parameters.MemoryBudget > 0
    ? parameters.MemoryBudget
    : std::min(MinimumMebibytes + MebibytesPerElement * elements, ShareOfMachine * machine);
  return budget;
}

/** Descend the ladder until a mesh has every facet. */
Tetrahedralization Climb(const FacetComplex& surface, TetrahedralizationEngine engine,
  const TetrahedralizerBudget& budget, Monitor& monitor)
{
  ForwardMonitor forward(monitor);
  Tetrahedralization best;
  std::optional<Error> lastError;
  for (const int rung : RungsOf(engine))
  {
    std::string failure;
    try
    {
      TetrahedralMesh mesh = TryRung(rung, surface, budget, forward);
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
    best.Failures.push_back(std::string(RungName(rung)) + ": " + failure);
  }
  if (best.Rung == 0)
  {
    throw Error(*lastError);
  }
  return best;
}
} // namespace

Tetrahedralization ConstrainedDelaunay(
  const FacetComplex& surface, const ConstrainedDelaunayParameters& parameters, Monitor& monitor)
{
  CheckParameters(parameters);
  CheckIdsAndCoordinates(surface);
  CheckSpansSpace(surface.Points);
  const TetrahedralizerBudget budget = BudgetOfARung(surface, parameters);
  const int exponent = LargestExponent(surface.Points);
  if (std::abs(exponent) > MostExponent)
  {
    FacetComplex scaled = surface;
    scaled.Points = ScaledPoints(surface.Points, -exponent);
    // Unscaled where the smallest coordinates would lose bits: the rungs have to cope.
    if (ScaledPoints(scaled.Points, exponent) == surface.Points)
    {
      Tetrahedralization result = Climb(scaled, parameters.Engine, budget, monitor);
      result.Mesh.Points = ScaledPoints(result.Mesh.Points, exponent);
      return result;
    }
  }
  return Climb(surface, parameters.Engine, budget, monitor);
}

TetrahedralMesh ConstrainedDelaunay(const FacetComplex& surface, Monitor& monitor)
{
  return ConstrainedDelaunay(surface, {}, monitor).Mesh;
}

void AddMeshCounts(const Tetrahedralization& result, Statistics& statistics)
{
  const TetrahedralMesh& mesh = result.Mesh;
  statistics.emplace_back("Rung", result.Rung);
  statistics.emplace_back("HullPoints", mesh.Points.size());
  statistics.emplace_back("HullCells", mesh.Cells.size());
  statistics.emplace_back("SteinerPoints", mesh.NumberOfSteinerPoints);
  statistics.emplace_back("SurfaceSteinerPoints", mesh.NumberOfSurfaceSteinerPoints);
  statistics.emplace_back("LostFacets", mesh.LostFacets.size());
}

void AddWarnings(const Tetrahedralization& result, std::vector<std::string>& warnings)
{
  warnings.insert(warnings.end(), result.Failures.begin(), result.Failures.end());
  if (!result.Failures.empty())
  {
    warnings.push_back(
      std::string(result.Parts == 1 ? "the tetrahedra" : "the tetrahedra of some parts") +
      " come from: " + RungName(result.Rung));
  }
  if (!result.Mesh.LostFacets.empty())
  {
    warnings.push_back(std::to_string(result.Mesh.LostFacets.size()) +
      " facets are not in the mesh as faces: they count, but do not shape it");
  }
  if (result.Mesh.NumberOfSurfaceSteinerPoints > 0)
  {
    warnings.push_back(std::to_string(result.Mesh.NumberOfSurfaceSteinerPoints) +
      " points were added on facets or their edges");
  }
}
} // namespace insideout
