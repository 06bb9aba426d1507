// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/WindingNumberOfCells.h"

#include "Common/ScaledPoints.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "WindingNumber/ClosedChainTree.h"
#include "WindingNumber/ExactWindingNumber.h"
#include "WindingNumber/HoleCaps.h"
#include "WindingNumber/SpatialOrder.h"
#include "WindingNumber/TetrahedronQuadrature.h"
#include "WindingNumber/TouchedCells.h"
#include "WindingNumber/WalkedWindingNumber.h"
#include "WindingNumber/WindingNumberOfCaps.h"
#include "WindingNumber/WindingNumberOfStraightCaps.h"

#include <algorithm>
#include <memory>

namespace insideout
{
namespace
{
/** Facets with a count that are not faces of the mesh: lost by it, or left out before. */
ChainOfFacets FacetsBeyondMesh(const FacetComplex& surface, const TetrahedralMesh& mesh)
{
  std::vector<Id> facets = mesh.LostFacets;
  for (Id f = surface.NumberOfConstraints; f < surface.NumberOfFacets(); ++f)
  {
    facets.push_back(f);
  }
  ChainOfFacets beyond;
  for (const Id f : facets)
  {
    if (surface.Multiplicity[f] != 0)
    {
      beyond.Triangles.push_back({ surface.Facets[f], surface.Multiplicity[f] });
      beyond.Facets.push_back(f);
    }
  }
  return beyond;
}

/** The mesh's faces with a count, and the facets beyond it. */
ChainOfFacets WholeChain(const FaceCounts& counts, const ChainOfFacets& beyond)
{
  ChainOfFacets chain = counts.Chain();
  chain.Triangles.insert(chain.Triangles.end(), beyond.Triangles.begin(), beyond.Triangles.end());
  chain.Facets.insert(chain.Facets.end(), beyond.Facets.begin(), beyond.Facets.end());
  return chain;
}

/** A chain of triangles in two: the caps that close its holes, and the chain less its caps. */
struct ClosedWithCaps
{
  std::vector<CountedTriangle> Closed;
  std::vector<std::vector<CountedTriangle>> Caps;
};

ClosedWithCaps Close(std::vector<CountedTriangle> chain, const std::vector<Point>& points)
{
  ClosedWithCaps result;
  result.Caps = CapHoles(points, CountedBoundary(chain, static_cast<Id>(points.size())));
  result.Closed = CloseChain(std::move(chain), result.Caps);
  return result;
}

/** The rule's places in some cells, rounded. */
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
 * The winding number of a chain that is open, or partly not in the mesh. Its holes have caps. The
 * integer part is carried by walking through cells that neither caps nor triangles outside the mesh
 * may touch; in the other cells it is evaluated.
 */
class PartlyWalked
{
public:
  /**
   * @param[in] beyond the part of the chain outside the mesh; all arguments have to outlive this
   * object
   */
  PartlyWalked(const std::vector<Point>& points, const TetrahedralMesh& mesh,
    const FaceCounts& counts, std::vector<CountedTriangle> chain,
    const std::vector<CountedTriangle>& beyond, const QuadratureRule& rule, Monitor& monitor)
  {
    if (chain.empty())
    {
      return;
    }
    const ClosedWithCaps closed = Close(std::move(chain), points);
    std::vector<std::vector<CountedTriangle>> apart = closed.Caps;
    apart.push_back(beyond);
    const std::vector<char> touched = TouchedCells(points, mesh.Cells, apart);
    this->Caps = std::make_unique<const WindingNumberOfCaps>(points, closed.Caps,
      mesh.Cells.size() * rule.Sites.size(), monitor,
      ProgressRange{ Stages::WindingNumbers, 0, 0 });
    // Walking takes one thread; another one may sort meanwhile.
    const double nanosecondsPerCell = 30; // of each of the two
    ParallelLoop(2, nanosecondsPerCell * static_cast<double>(mesh.Cells.size()),
      [&](Id i)
      {
        if (i == 0)
        {
          this->Parts = WalkParts(counts, mesh, touched);
        }
        else if (!this->Caps->IsEmpty())
        {
          this->Order = SpatialOrder({ points, mesh.Cells });
        }
      });
    this->Evaluated = this->Parts.FirstCell;
    for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
    {
      if (touched[cell])
      {
        this->Evaluated.push_back(cell);
      }
    }
    this->Tree = std::make_unique<const ClosedChainTree>(points, closed.Closed,
      RoundedPlaces(points, mesh.Cells, this->Evaluated, rule), monitor,
      ProgressRange{ Stages::WindingNumbers, 0.05, 0.1 });
  }

  /**
   * All cells, sorted so that neighbors in space are near each other; empty if this was not needed.
   */
  const std::vector<Id>& OrderOfCells() const { return this->Order; }

  /** Set all cells' values. */
  void Evaluate(const Sites& sites, std::vector<double>& w, Monitor& monitor,
    const ProgressRange& progress) const
  {
    if (!this->Tree)
    {
      std::fill(w.begin(), w.end(), 0.0);
      return;
    }
    const double middle = progress.Begin + (progress.End - progress.Begin) / 8;
    this->Tree->Evaluate(
      sites, this->Evaluated, w, monitor, { progress.Stage, progress.Begin, middle });
    for (std::size_t cell = 0; cell < w.size(); ++cell)
    {
      const UntouchedParts::Place& place = this->Parts.OfCell[cell];
      if (place.Part != None)
      {
        w[cell] = w[this->Parts.FirstCell[place.Part]] + place.Rise;
      }
    }
    this->Caps->Add(sites, this->Order, w, monitor, { progress.Stage, middle, progress.End });
  }

private:
  std::unique_ptr<const WindingNumberOfCaps> Caps;
  UntouchedParts Parts;
  std::vector<Id> Order;
  std::vector<Id> Evaluated;
  std::unique_ptr<const ClosedChainTree> Tree;
};

/**
 * Means in cells: the value at the rule's first site and differences from it, so that constants
 * stay exact.
 *
 * @param[in] valuesAt w in all cells at the site with the index given
 */
template <typename Values>
std::vector<double> MeansOf(const QuadratureRule& rule, const Values& valuesAt)
{
  const std::vector<double> first = valuesAt(0);
  std::vector<double> means = first;
  for (std::size_t i = 1; i < rule.Sites.size(); ++i)
  {
    const std::vector<double> w = valuesAt(i);
    for (std::size_t cell = 0; cell < w.size(); ++cell)
    {
      means[cell] += rule.Weights[i] * (w[cell] - first[cell]);
    }
  }
  return means;
}

/**
 * The mean winding numbers of a complex that is open, or of which the mesh lacks facets. The chain
 * consists of the mesh's faces and the facets outside it: straight caps that replace pieces, and
 * the rest.
 */
std::vector<double> PartlyWalkedMeans(const FacetComplex& surface,
  const std::vector<CountedEdge>& boundary, const TetrahedralMesh& mesh,
  const ChainOfFacets& beyond, const QuadratureRule& rule, Monitor& monitor)
{
  monitor.Check(Stages::WindingNumbers, 0);
  const std::vector<Point> points = ScaledPoints(mesh.Points, -LargestExponent(mesh.Points));
  FaceCounts counts(surface, mesh);
  StraightCaps straight = FindStraightCaps(surface, points, WholeChain(counts, beyond), boundary);
  counts.LeaveOut(straight.HasCap);
  std::vector<CountedTriangle> beyondRest;
  for (std::size_t i = 0; i < beyond.Facets.size(); ++i)
  {
    if (!straight.HasCap[beyond.Facets[i]])
    {
      beyondRest.push_back(beyond.Triangles[i]);
    }
  }
  const PartlyWalked rest(
    points, mesh, counts, std::move(straight.Rest), beyondRest, rule, monitor);
  const WindingNumberOfStraightCaps caps(points, straight, mesh.Cells.size() * rule.Sites.size(),
    monitor, { Stages::WindingNumbers, 0.1, 0.1 });
  std::vector<Id> order = rest.OrderOfCells();
  if (order.empty() && !straight.Caps.empty())
  {
    order = SpatialOrder({ points, mesh.Cells });
  }

  const double step = 0.9 / static_cast<double>(rule.Sites.size());
  std::vector<double> means = MeansOf(rule,
    [&](std::size_t i)
    {
      std::vector<double> w(mesh.Cells.size());
      const Sites sites = { points, mesh.Cells, rule.Sites[i] };
      const double begin = 0.1 + step * static_cast<double>(i);
      rest.Evaluate(sites, w, monitor, { Stages::WindingNumbers, begin, begin + step / 2 });
      caps.Add(
        sites, order, w, monitor, { Stages::WindingNumbers, begin + step / 2, begin + step });
      return w;
    });
  monitor.Check(Stages::WindingNumbers, 1);
  return means;
}

std::vector<CountedEdge> BoundaryOf(const FacetComplex& surface)
{
  return CountedBoundary(CountedFacets(surface), static_cast<Id>(surface.Points.size()));
}

/** Six times the volume, positive where the cell is positively oriented. */
double SixfoldVolume(const std::array<Point, 4>& p)
{
  return Determinant(Difference(p[1], p[0]), Difference(p[2], p[0]), Difference(p[3], p[0]));
}
} // namespace

bool IsClosed(const FacetComplex& surface)
{
  return BoundaryOf(surface).empty();
}

std::vector<double> WindingNumberOfCells(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor, int quadratureOrder)
{
  const QuadratureRule rule = TetrahedronQuadrature(quadratureOrder);
  const ChainOfFacets beyond = FacetsBeyondMesh(surface, mesh);
  const std::vector<CountedEdge> boundary = BoundaryOf(surface);
  if (beyond.Facets.empty() && boundary.empty())
  {
    return WalkedWindingNumbers(surface, mesh, monitor);
  }
  return PartlyWalkedMeans(surface, boundary, mesh, beyond, rule, monitor);
}

std::vector<double> WindingNumberOfOtherCells(const FacetComplex& surface,
  const TetrahedralMesh& mesh, const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, int quadratureOrder, Monitor& monitor,
  const ProgressRange& progress)
{
  const QuadratureRule rule = TetrahedronQuadrature(quadratureOrder);
  const std::size_t sites = cells.size() * rule.Sites.size();
  const int exponent = LargestExponent(mesh.Points);
  const std::vector<Point> corners = ScaledPoints(mesh.Points, -exponent);
  const std::vector<Point> scaled = ScaledPoints(points, -exponent);
  StraightCaps straight = FindStraightCaps(surface, corners,
    WholeChain(FaceCounts(surface, mesh), FacetsBeyondMesh(surface, mesh)), BoundaryOf(surface));
  const std::vector<CountedEdge> boundary =
    CountedBoundary(straight.Rest, static_cast<Id>(corners.size()));
  const ExactWindingNumber rest(corners, std::move(straight.Rest), boundary, monitor,
    { progress.Stage, progress.Begin, progress.Begin }, sites);
  const WindingNumberOfStraightCaps caps(corners, straight, sites, monitor, progress);
  const std::vector<Id> order = SpatialOrder({ scaled, cells });
  return MeansOf(rule,
    [&](std::size_t i)
    {
      const Sites at = { scaled, cells, rule.Sites[i] };
      std::vector<double> w = rest.Evaluate(at, monitor, progress);
      caps.Add(at, order, w, monitor, progress);
      return w;
    });
}

double SignedContent(const TetrahedralMesh& mesh, const std::vector<double>& w)
{
  // Compensated summation (Neumaier 1974).
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
