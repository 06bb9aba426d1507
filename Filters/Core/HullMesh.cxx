// SPDX-License-Identifier: GPL-3.0-or-later
#include "HullMesh.h"

#include "Boolean/SingleBodies.h"
#include "Boolean/WindingNumbersOfBodies.h"
#include "Common/AddUp.h"
#include "Common/Box.h"
#include "Common/Vectors.h"
#include "Refine/MendFlatCells.h"
#include "Tetrahedralize/TetrahedralizeApart.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <algorithm>
#include <numeric>

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

/** The fraction of each body in the total area. */
std::vector<double> SharesOf(const std::vector<Body>& bodies)
{
  if (bodies.size() == 1)
  {
    return { 1 };
  }
  std::vector<double> shares;
  std::transform(bodies.begin(), bodies.end(), std::back_inserter(shares), AreaOf);
  const double area = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (double& share : shares)
  {
    share /= area;
  }
  return shares;
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
  SurfaceCounts sum = bodies.front().Counts;
  for (std::size_t b = 1; b < bodies.size(); ++b)
  {
    for (const Count count : all)
    {
      sum.*count += bodies[b].Counts.*count;
    }
    sum.OpenLength += bodies[b].Counts.OpenLength;
  }
  return sum;
}

/**
 * The orientation and thickening of all bodies together: counts are summed, fractions are relative
 * to the total area. Lists as long as the surface are dropped.
 */
Statistics TakeTurns(const std::vector<double>& shares, std::vector<CountedBody>& bodies)
{
  Statistics sums;
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    FacetTurns turns = std::move(bodies[b].Turns);
    turns.SheetShare *= shares[b];
    turns.TurnedShare *= shares[b];
    Statistics figures;
    AddTurns(turns, figures);
    figures.emplace_back("ThickenedFacets", bodies[b].ThickenedFacets);
    AddUp(figures, sums);
  }
  return sums;
}

void CountResolved(HullMesh& hull)
{
  const Id leftOut = hull.Surface.NumberOfFacets() - hull.Surface.NumberOfConstraints;
  hull.Statistics.emplace_back("IntersectingPairs", hull.IntersectingPairs);
  hull.Statistics.emplace_back("ResolvedPoints", hull.Surface.Points.size());
  hull.Statistics.emplace_back("ResolvedFacets", hull.Surface.NumberOfFacets());
  hull.Statistics.emplace_back("LeftOutFacets", leftOut);
  if (leftOut > 0)
  {
    hull.Warnings.push_back(std::to_string(leftOut) +
      " facets still cross others after rounding: they count, but do not shape the mesh");
  }
}

void FindW(int quadratureOrder, HullMesh& hull, Monitor& monitor)
{
  if (hull.NumberOfBodies() == 1)
  {
    hull.W = WindingNumberOfCells(hull.Surface, hull.Mesh, monitor, quadratureOrder);
    return;
  }
  hull.WOfBodies = WindingNumbersOfBodies(hull, hull.Mesh, quadratureOrder, monitor);
  hull.W.assign(hull.Mesh.Cells.size(), 0.0);
  for (const std::vector<double>& w : hull.WOfBodies)
  {
    std::transform(w.begin(), w.end(), hull.W.begin(), hull.W.begin(), std::plus<>());
  }
}
} // namespace

HullMesh ResolveHull(
  std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor)
{
  const bool areNamed = AreNamed(bodies);
  const std::vector<double> shares = SharesOf(bodies);
  const double diagonal = bodies.size() > 1 ? DiagonalOf(bodies) : 0;
  Stopwatch stopwatch;
  HullMesh hull{
    ResolveBodies(std::move(bodies),
      { parameters.Chain, parameters.Orientation, parameters.Thicken, parameters.TouchTolerance },
      monitor),
    {}, {}, {}, {}, {}
  };
  const double resolveSeconds = stopwatch.Lap() - hull.SecondsValidate;
  hull.Mesh.Points = hull.Surface.Points;
  hull.Mesh.Origins = hull.Surface.Origins;
  hull.Counts = SumOf(hull.Bodies);
  if (hull.NumberOfBodies() > 1)
  {
    hull.Counts.Diagonal = diagonal;
  }
  if (areNamed)
  {
    hull.Statistics.emplace_back("Bodies", hull.NumberOfBodies());
    AddTouches(hull, hull.Statistics);
  }
  AddCounts(hull.Counts, hull.Statistics);
  AddUp(TakeTurns(shares, hull.Bodies), hull.Statistics);
  CountResolved(hull);
  hull.Statistics.emplace_back("SecondsValidate", hull.SecondsValidate);
  hull.Statistics.emplace_back("SecondsPre", resolveSeconds);
  return hull;
}

void MeshResolvedHull(const HullMeshParameters& parameters, HullMesh& hull, Monitor& monitor)
{
  Stopwatch stopwatch;
  hull.Mesh = {}; // its points would take memory twice
  Tetrahedralization result = parameters.PartsApart
    ? TetrahedralizeApart(hull.Surface, parameters.Budgets, monitor)
    : ConstrainedDelaunay(hull.Surface, parameters.Budgets, monitor);
  MendFlatCells(result.Mesh, monitor);
  if (parameters.PartsApart)
  {
    hull.Statistics.emplace_back("PartsApart", result.Parts);
  }
  AddMeshCounts(result, hull.Statistics);
  AddWarnings(result, hull.Warnings);
  hull.Mesh = std::move(result.Mesh);
  const double meshSeconds = stopwatch.Lap();

  FindW(parameters.QuadratureOrder, hull, monitor);
  const auto [least, most] = std::minmax_element(hull.W.begin(), hull.W.end());
  hull.Statistics.emplace_back("Closed", AreClosed(hull, SortedFacetEdges(hull.Surface.Facets)));
  hull.Statistics.emplace_back("MinimumW", *least);
  hull.Statistics.emplace_back("MaximumW", *most);
  hull.Statistics.emplace_back("SecondsCDT", meshSeconds);
  hull.Statistics.emplace_back("SecondsW", stopwatch.Lap());
}

HullMesh MeshHull(std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor)
{
  HullMesh hull = ResolveHull(std::move(bodies), parameters, monitor);
  MeshResolvedHull(parameters, hull, monitor);
  return hull;
}
} // namespace insideout
