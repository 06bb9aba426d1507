// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullMesh.h"

#include "Resolve/ResolveSelfIntersections.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** Turn every facet's count over. The facets' corners stay as they are. */
void TurnOver(FacetComplex& surface)
{
  for (std::int16_t& multiplicity : surface.Multiplicity)
  {
    multiplicity = static_cast<std::int16_t>(-multiplicity);
  }
  for (FacetSource& source : surface.Sources)
  {
    source.Reversed = !source.Reversed;
  }
}

/** Apply the orientation; whether that turned the surface over. */
bool Orient(HullMesh& hull, Orientation orientation)
{
  const bool insideOut =
    orientation == Orientation::Automatic && SignedContent(hull.Mesh, hull.W) < 0;
  if (insideOut)
  {
    hull.Warnings.push_back("the surface is inside out as a whole: it is turned over");
  }
  const bool turned = insideOut || orientation == Orientation::Reverse;
  if (turned)
  {
    TurnOver(hull.Surface);
    for (double& w : hull.W)
    {
      w = 0 - w; // not -w, which would make -0 of 0
    }
  }
  return turned;
}
} // namespace

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
  const bool turned = Orient(hull, parameters.Orientation);
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  statistics.emplace_back("Closed", IsClosed(hull.Surface));
  statistics.emplace_back("TurnedOver", turned);
  statistics.emplace_back("MinimumW", *least);
  statistics.emplace_back("MaximumW", *most);

  statistics.emplace_back("SecondsValidate", validateSeconds);
  statistics.emplace_back("SecondsPre", resolveSeconds);
  statistics.emplace_back("SecondsCDT", meshSeconds);
  statistics.emplace_back("SecondsW", stopwatch.Lap());
  return hull;
}
} // namespace insideout
