// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullMesh.h"

#include "Resolve/ResolveSelfIntersections.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <algorithm>

namespace insideout
{
HullMesh MeshHull(const TriangleSoup& soup, const HullMeshParameters& parameters, Monitor& monitor)
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
  const FacetTurns turns = OrientFacets(chain.Surface, parameters.Orientation, monitor);
  hull.TurnedTriangles = TrianglesOfFacets(chain.Surface, turns.Turned);
  hull.SheetTriangles = TrianglesOfFacets(chain.Surface, turns.IsSheet);
  hull.Warnings.insert(hull.Warnings.end(), turns.Warnings.begin(), turns.Warnings.end());
  AddTurns(turns, statistics);
  statistics.emplace_back(
    "ThickenedFacets", ThickenFacets(chain.Surface, turns.IsSheet, parameters.Thicken, monitor));
  const double validateSeconds = stopwatch.Lap();

  Resolution resolution = ResolveSelfIntersections(chain.Surface, monitor);
  hull.Surface = std::move(resolution.Surface);
  const Id leftOut = hull.Surface.NumberOfFacets() - hull.Surface.NumberOfConstraints;
  statistics.emplace_back("IntersectingPairs", resolution.IntersectingPairs.size());
  statistics.emplace_back("ResolvedPoints", hull.Surface.Points.size());
  statistics.emplace_back("ResolvedFacets", hull.Surface.NumberOfFacets());
  statistics.emplace_back("LeftOutFacets", leftOut);
  if (leftOut > 0)
  {
    hull.Warnings.push_back(std::to_string(leftOut) +
      " facets still cross others after rounding: they count, but do not shape the mesh");
  }
  const double resolveSeconds = stopwatch.Lap();

  Tetrahedralization result = ConstrainedDelaunay(hull.Surface, parameters.Budgets, monitor);
  AddMeshCounts(result, statistics);
  AddWarnings(result, hull.Warnings);
  hull.Mesh = std::move(result.Mesh);
  const double meshSeconds = stopwatch.Lap();

  hull.W = WindingNumberOfCells(hull.Surface, hull.Mesh, monitor, parameters.QuadratureOrder);
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  statistics.emplace_back("Closed", IsClosed(hull.Surface));
  statistics.emplace_back("MinimumW", *least);
  statistics.emplace_back("MaximumW", *most);

  statistics.emplace_back("SecondsValidate", validateSeconds);
  statistics.emplace_back("SecondsPre", resolveSeconds);
  statistics.emplace_back("SecondsCDT", meshSeconds);
  statistics.emplace_back("SecondsW", stopwatch.Lap());
  return hull;
}
} // namespace insideout
