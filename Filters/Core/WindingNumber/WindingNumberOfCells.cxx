// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumberOfCells.h"

#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "WindingNumber/ClosedChainTree.h"
#include "WindingNumber/HoleCaps.h"
#include "WindingNumber/SpatialOrder.h"
#include "WindingNumber/TetrahedronQuadrature.h"
#include "WindingNumber/TouchedCells.h"
#include "WindingNumber/WalkedWindingNumber.h"
#include "WindingNumber/WindingNumberOfCaps.h"

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
/** Facets that count and are no faces of the mesh: lost by it, or left out before. */
std::vector<CountedTriangle> FacetsBeyondMesh(
  const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  std::vector<Id> facets = mesh.LostFacets;
  for (Id f = surface.NumberOfConstraints; f < surface.NumberOfFacets(); ++f)
  {
    facets.push_back(f);
  }
  std::vector<CountedTriangle> beyond;
  for (const Id f : facets)
  {
    if (surface.Multiplicity[f] != 0)
    {
      beyond.push_back({ surface.Facets[f], surface.Multiplicity[f] });
    }
  }
  return beyond;
}

/** A chain of triangles in pieces: its caps, which close its holes, and the chain less these. */
struct ClosedWithCaps
{
  std::vector<CountedTriangle> Closed;
  std::vector<std::vector<CountedTriangle>> Caps;
};

ClosedWithCaps CloseMeshChain(const FaceCounts& counts, const std::vector<Point>& points,
  const std::vector<CountedTriangle>& beyond)
{
  std::vector<CountedTriangle> chain = counts.Chain();
  chain.insert(chain.end(), beyond.begin(), beyond.end());
  ClosedWithCaps result;
  result.Caps = CapHoles(points, CountedBoundary(chain, static_cast<Id>(points.size())));
  result.Closed = CloseChain(std::move(chain), result.Caps);
  return result;
}

/** Where the rule's places are in some cells, rounded. */
std::vector<Point> RoundedPlaces(const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<Id>& which, const QuadratureRule& rule)
{
  std::vector<Point> places;
  for (const SiteWeights& weights : rule.Sites)
  {
    const Sites sites = { points, cells, weights };
    for (const Id cell : which)
    {
      places.push_back(sites.Rounded(cell).High);
    }
  }
  return places;
}

/**
 * The mean winding numbers of a complex that is open, or of which the mesh lacks facets. Its chain
 * is the mesh's faces and the facets beyond it, and its holes have caps: on cells that neither caps
 * nor facets beyond the mesh may touch, the whole part is walked; elsewhere it is evaluated.
 */
std::vector<double> PartlyWalkedMeans(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<CountedTriangle>& beyond, const QuadratureRule& rule, Monitor& monitor)
{
  monitor.Check(Stages::WindingNumbers, 0);
  const std::vector<Point> points = ScaledPoints(mesh.Points, -LargestExponent(mesh.Points));
  const FaceCounts counts(surface, mesh);
  const ClosedWithCaps chain = CloseMeshChain(counts, points, beyond);
  std::vector<std::vector<CountedTriangle>> apart = chain.Caps;
  apart.push_back(beyond);
  const std::vector<char> touched = TouchedCells(points, mesh.Cells, apart);
  const WindingNumberOfCaps caps(points, chain.Caps);
  UntouchedParts parts;
  std::vector<Id> order;
  // Walking takes one thread; another one may sort meanwhile.
  const double nanosecondsPerCell = 30; // of each of the two
  ParallelLoop(2, nanosecondsPerCell * static_cast<double>(mesh.Cells.size()),
    [&](Id i)
    {
      if (i == 0)
      {
        parts = WalkParts(counts, mesh, touched);
      }
      else if (!caps.IsEmpty())
      {
        order = SpatialOrder({ points, mesh.Cells });
      }
    });
  std::vector<Id> evaluated = parts.FirstCell;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (touched[cell])
    {
      evaluated.push_back(cell);
    }
  }
  const ClosedChainTree tree(points, chain.Closed,
    RoundedPlaces(points, mesh.Cells, evaluated, rule), monitor,
    { Stages::WindingNumbers, 0.05, 0.1 });

  // As the first place's value and differences to it, so that what is constant stays exact.
  std::vector<double> means;
  std::vector<double> first;
  std::vector<double> w(mesh.Cells.size(), 0.0);
  const double step = 0.9 / static_cast<double>(rule.Sites.size());
  for (std::size_t i = 0; i < rule.Sites.size(); ++i)
  {
    const Sites sites = { points, mesh.Cells, rule.Sites[i] };
    const double begin = 0.1 + step * static_cast<double>(i);
    tree.Evaluate(
      sites, evaluated, w, monitor, { Stages::WindingNumbers, begin, begin + step / 8 });
    for (std::size_t cell = 0; cell < w.size(); ++cell)
    {
      const UntouchedParts::Place& place = parts.OfCell[cell];
      if (place.Part != None)
      {
        w[cell] = w[parts.FirstCell[place.Part]] + place.Rise;
      }
    }
    caps.Add(sites, order, w, monitor, { Stages::WindingNumbers, begin + step / 8, begin + step });
    if (i == 0)
    {
      first = means = w;
      continue;
    }
    for (std::size_t cell = 0; cell < w.size(); ++cell)
    {
      means[cell] += rule.Weights[i] * (w[cell] - first[cell]);
    }
  }
  monitor.Check(Stages::WindingNumbers, 1);
  return means;
}

/** Six times the volume, positive where the cell is positively oriented. */
double SixfoldVolume(const std::array<Point, 4>& p)
{
  return Determinant(Difference(p[1], p[0]), Difference(p[2], p[0]), Difference(p[3], p[0]));
}
} // namespace

bool IsClosed(const FacetComplex& surface)
{
  return CountedBoundary(CountedFacets(surface), static_cast<Id>(surface.Points.size())).empty();
}

std::vector<double> WindingNumberOfCells(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor, int quadratureOrder)
{
  const QuadratureRule rule = TetrahedronQuadrature(quadratureOrder);
  const std::vector<CountedTriangle> beyond = FacetsBeyondMesh(surface, mesh);
  if (beyond.empty() && IsClosed(surface))
  {
    return WalkedWindingNumbers(surface, mesh, monitor);
  }
  return PartlyWalkedMeans(surface, mesh, beyond, rule, monitor);
}

double SignedContent(const TetrahedralMesh& mesh, const std::vector<double>& w)
{
  // Compensated after Neumaier (1974).
  double sum = 0;
  double compensation = 0;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const double term = w[cell] * SixfoldVolume(CornersOf(mesh.Points, mesh.Cells[cell]));
    const double next = sum + term;
    compensation += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return (sum + compensation) / 6;
}
} // namespace insideout
