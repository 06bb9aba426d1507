// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullOfBodies.h"

#include "Boolean/ResolveBodies.h"
#include "Boolean/SingleBodies.h"
#include "Boolean/WindingNumbersOfBodies.h"
#include "Common/AddUp.h"
#include "Common/Box.h"
#include "Common/Vectors.h"

#include <algorithm>

namespace insideout
{
namespace
{
double AreaOf(const Body& body)
{
  double area = 0;
  for (const Triangle& t : body.Soup.Triangles)
  {
    area +=
      Length(NormalOf(body.Soup.Points[t[0]], body.Soup.Points[t[1]], body.Soup.Points[t[2]]));
  }
  return area;
}

double DiagonalOf(const std::vector<Body>& bodies)
{
  std::vector<Point> corners;
  for (const Body& body : bodies)
  {
    for (const Triangle& t : body.Soup.Triangles)
    {
      for (const Id p : t)
      {
        corners.push_back(body.Soup.Points[p]);
      }
    }
  }
  const Box box = BoundingBox(corners);
  return Distance(box.Low, box.High);
}

/** The sum of the counts of all bodies. */
SurfaceCounts SumOf(const std::vector<CountedBody>& bodies)
{
  using Count = Id SurfaceCounts::*;
  constexpr std::array<Count, 14> all = { { &SurfaceCounts::InputPoints,
    &SurfaceCounts::InputTriangles, &SurfaceCounts::Points, &SurfaceCounts::Facets,
    &SurfaceCounts::MergedPoints, &SurfaceCounts::DegenerateFacets, &SurfaceCounts::DuplicateFacets,
    &SurfaceCounts::CancelledFacets, &SurfaceCounts::OpenEdges, &SurfaceCounts::NonManifoldEdges,
    &SurfaceCounts::Components, &SurfaceCounts::TwoSidedSolids, &SurfaceCounts::TwoSidedSheets,
    &SurfaceCounts::NonParticipatingFacets } };
  SurfaceCounts sum;
  for (const CountedBody& body : bodies)
  {
    for (const Count count : all)
    {
      sum.*count += body.Counts.*count;
    }
    sum.OpenLength += body.Counts.OpenLength;
  }
  return sum;
}

Id ThickenedFacetsOf(const std::vector<CountedBody>& bodies)
{
  Id sum = 0;
  for (const CountedBody& body : bodies)
  {
    sum += body.ThickenedFacets;
  }
  return sum;
}

/** How the bodies were turned, each alone: counts are sums, shares those of the area of all. */
Statistics TurnsOf(const ResolvedBodies& resolved, const std::vector<double>& areas)
{
  double area = 0;
  for (const double ofBody : areas)
  {
    area += ofBody;
  }
  Statistics sums;
  for (Id b = 0; b < resolved.NumberOfBodies(); ++b)
  {
    FacetTurns turns = resolved.Bodies[b].Turns;
    turns.SheetShare *= areas[b] / area;
    turns.TurnedShare *= areas[b] / area;
    Statistics figures;
    AddTurns(turns, figures);
    AddUp(figures, sums);
  }
  return sums;
}
} // namespace

HullOfBodies MeshBodies(
  std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor)
{
  std::vector<double> areas;
  std::transform(bodies.begin(), bodies.end(), std::back_inserter(areas), AreaOf);
  HullOfBodies result;
  HullMesh& hull = result.Whole;
  const double diagonal = DiagonalOf(bodies);
  Stopwatch stopwatch;

  ResolvedBodies resolved = ResolveBodies(
    std::move(bodies), { parameters.Chain, parameters.Orientation, parameters.Thicken }, monitor);
  hull.Counts = SumOf(resolved.Bodies);
  hull.Counts.Diagonal = diagonal;
  hull.Statistics.emplace_back("Bodies", resolved.NumberOfBodies());
  hull.Statistics.emplace_back("NearTriangles", resolved.NearTriangles);
  AddCounts(hull.Counts, hull.Statistics);
  AddUp(TurnsOf(resolved, areas), hull.Statistics);
  hull.Statistics.emplace_back("ThickenedFacets", ThickenedFacetsOf(resolved.Bodies));
  hull.Warnings = std::move(resolved.Warnings);
  hull.MergedInto = std::move(resolved.MergedInto);
  hull.DegenerateTriangles = std::move(resolved.DegenerateTriangles);
  hull.TurnedTriangles = std::move(resolved.TurnedTriangles);
  hull.SheetTriangles = std::move(resolved.SheetTriangles);
  TakeResolved(resolved.Surface, static_cast<std::size_t>(resolved.IntersectingPairs), hull);
  const double resolveSeconds = stopwatch.Lap() - resolved.SecondsValidate;

  FillHull(parameters.Budgets, hull, monitor);
  const double meshSeconds = stopwatch.Lap();

  result.W = WindingNumbersOfBodies(resolved, hull.Mesh, parameters.QuadratureOrder, monitor);
  hull.W.assign(hull.Mesh.Cells.size(), 0.0);
  for (const std::vector<double>& w : result.W)
  {
    std::transform(w.begin(), w.end(), hull.W.begin(), hull.W.begin(), std::plus<>());
  }
  const std::vector<char> isClosed =
    FindClosedBodies(resolved, SortedFacetEdges(resolved.Surface.Facets));
  AddRangeOfW(std::all_of(isClosed.begin(), isClosed.end(), [](char c) { return c != 0; }), hull);

  hull.Statistics.emplace_back("SecondsValidate", resolved.SecondsValidate);
  hull.Statistics.emplace_back("SecondsPre", resolveSeconds);
  hull.Statistics.emplace_back("SecondsCDT", meshSeconds);
  hull.Statistics.emplace_back("SecondsW", stopwatch.Lap());
  return result;
}
} // namespace insideout
