// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullMesh.h"

#include "Resolve/ResolveSelfIntersections.h"
#include "Tetrahedralize/TetrahedralizeApart.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <algorithm>

namespace insideout
{
namespace
{
void TakeMesh(Tetrahedralization result, HullMesh& hull)
{
  AddMeshCounts(result, hull.Statistics);
  AddWarnings(result, hull.Warnings);
  hull.Mesh = std::move(result.Mesh);
}
} // namespace

HullMesh ResolveHull(
  const TriangleSoup& soup, const HullMeshParameters& parameters, Monitor& monitor)
{
  HullMesh hull;
  Statistics& statistics = hull.Statistics;
  Stopwatch stopwatch;

  CountedChain chain = CountFacets(soup, parameters.Chain, monitor);
  hull.Counts = chain.Counts;
  hull.MergedInto = std::move(chain.MergedInto);
  hull.DegenerateTriangles = std::move(chain.DegenerateTriangles);
  hull.Warnings = std::move(chain.Warnings);
  AddCounts(hull.Counts, statistics);
  const FacetTurns turns =
    OrientFacets(chain.Surface, chain.Edges, parameters.Orientation, monitor);
  chain.Edges = {};
  hull.TurnedTriangles = TrianglesOfFacets(chain.Surface, turns.Turned);
  hull.SheetTriangles = TrianglesOfFacets(chain.Surface, turns.IsSheet);
  hull.Warnings.insert(hull.Warnings.end(), turns.Warnings.begin(), turns.Warnings.end());
  AddTurns(turns, statistics);
  statistics.emplace_back(
    "ThickenedFacets", ThickenFacets(chain.Surface, turns.IsSheet, parameters.Thicken, monitor));
  const double validateSeconds = stopwatch.Lap();

  Resolution resolution = ResolveSelfIntersections(chain.Surface, monitor);
  TakeResolved(std::move(resolution.Surface), resolution.IntersectingPairs.size(), hull);
  statistics.emplace_back("SecondsValidate", validateSeconds);
  statistics.emplace_back("SecondsPre", stopwatch.Lap());
  return hull;
}

void MeshResolvedHull(const HullMeshParameters& parameters, HullMesh& hull, Monitor& monitor)
{
  Stopwatch stopwatch;
  if (parameters.PartsApart)
  {
    Tetrahedralization result = TetrahedralizeApart(hull.Surface, parameters.Budgets, monitor);
    hull.Statistics.emplace_back("PartsApart", result.Parts);
    TakeMesh(std::move(result), hull);
  }
  else
  {
    FillHull(parameters.Budgets, hull, monitor);
  }
  const double meshSeconds = stopwatch.Lap();

  hull.W = WindingNumberOfCells(hull.Surface, hull.Mesh, monitor, parameters.QuadratureOrder);
  AddRangeOfW(IsClosed(hull.Surface), hull);
  hull.Statistics.emplace_back("SecondsCDT", meshSeconds);
  hull.Statistics.emplace_back("SecondsW", stopwatch.Lap());
}

HullMesh MeshHull(const TriangleSoup& soup, const HullMeshParameters& parameters, Monitor& monitor)
{
  HullMesh hull = ResolveHull(soup, parameters, monitor);
  MeshResolvedHull(parameters, hull, monitor);
  return hull;
}

void TakeResolved(FacetComplex surface, std::size_t intersectingPairs, HullMesh& hull)
{
  hull.Surface = std::move(surface);
  hull.Mesh.Points = hull.Surface.Points;
  hull.Mesh.Origins = hull.Surface.Origins;
  const Id leftOut = hull.Surface.NumberOfFacets() - hull.Surface.NumberOfConstraints;
  hull.Statistics.emplace_back("IntersectingPairs", intersectingPairs);
  hull.Statistics.emplace_back("ResolvedPoints", hull.Surface.Points.size());
  hull.Statistics.emplace_back("ResolvedFacets", hull.Surface.NumberOfFacets());
  hull.Statistics.emplace_back("LeftOutFacets", leftOut);
  if (leftOut > 0)
  {
    hull.Warnings.push_back(std::to_string(leftOut) +
      " facets still cross others after rounding: they count, but do not shape the mesh");
  }
}

void FillHull(const ConstrainedDelaunayParameters& budgets, HullMesh& hull, Monitor& monitor)
{
  TakeMesh(ConstrainedDelaunay(hull.Surface, budgets, monitor), hull);
}

void AddRangeOfW(bool isClosed, HullMesh& hull)
{
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  hull.Statistics.emplace_back("Closed", isClosed);
  hull.Statistics.emplace_back("MinimumW", *least);
  hull.Statistics.emplace_back("MaximumW", *most);
}
} // namespace insideout
