// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberOfCells.h"

#include "WindingNumberSum.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** An edge of a facet: its points in ascending order, and how often it is run through that way. */
struct CountedEdge
{
  Id Low;
  Id High;
  std::int64_t Count;

  bool IsSameEdge(const CountedEdge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  bool operator<(const CountedEdge& other) const
  {
    return this->Low != other.Low ? this->Low < other.Low : this->High < other.High;
  }
};

std::vector<CountedEdge> CountedEdges(const FacetComplex& surface)
{
  std::vector<CountedEdge> edges;
  edges.reserve(3 * surface.Facets.size());
  for (std::size_t f = 0; f < surface.Facets.size(); ++f)
  {
    const int multiplicity = surface.Multiplicity[f];
    for (int k = 0; multiplicity != 0 && k < 3; ++k)
    {
      const Id from = surface.Facets[f][k];
      const Id to = surface.Facets[f][(k + 1) % 3];
      edges.push_back(
        { std::min(from, to), std::max(from, to), from < to ? multiplicity : -multiplicity });
    }
  }
  return edges;
}

/** Carry the winding number from the hull into every cell that can be reached. */
std::vector<double> Walk(
  const FacetComplex& surface, const TetrahedralMesh& mesh, std::vector<Id>& reached)
{
  std::vector<double> w(mesh.Cells.size(), 0.0);
  std::vector<char> known(mesh.Cells.size(), 0);
  const auto reach = [&](Id cell, double value)
  {
    if (!known[cell])
    {
      known[cell] = 1;
      w[cell] = value;
      reached.push_back(cell);
    }
  };
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[cell][k] == None)
      {
        reach(cell, MultiplicityOnEntering(surface, mesh, cell, k));
      }
    }
  }
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const Id cell = reached[next];
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[cell][k] != None)
      {
        reach(mesh.Neighbors[cell][k], w[cell] - MultiplicityOnEntering(surface, mesh, cell, k));
      }
    }
  }
  return w;
}

/** Throw unless w jumps by the facets' multiplicity, seen from both sides of every face. */
void VerifyJumps(
  const FacetComplex& surface, const TetrahedralMesh& mesh, const std::vector<double>& w)
{
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Id neighbor = mesh.Neighbors[cell][k];
      const double beyond = neighbor == None ? 0.0 : w[neighbor];
      if (w[cell] - beyond != MultiplicityOnEntering(surface, mesh, cell, k))
      {
        throw Error(ErrorCode::Inconsistent,
          "the winding number does not rise by the facets' count between cell " +
            (neighbor == None ? std::string("(outside)") : std::to_string(neighbor)) +
            " and cell " + std::to_string(cell));
      }
    }
  }
}

std::vector<double> WalkedWindingNumbers(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor)
{
  const char* stage = "winding numbers";
  monitor.Check(stage, 0);
  std::vector<Id> reached;
  const std::vector<double> w = Walk(surface, mesh, reached);
  if (reached.size() != mesh.Cells.size())
  {
    std::sort(reached.begin(), reached.end());
    Id missing = 0;
    while (missing < static_cast<Id>(reached.size()) && reached[missing] == missing)
    {
      ++missing;
    }
    throw Error(ErrorCode::Inconsistent,
      "cell " + std::to_string(missing) + " cannot be reached from the hull");
  }
  monitor.Check(stage, 0.5);
  VerifyJumps(surface, mesh, w);
  monitor.Check(stage, 1);
  return w;
}

/** Six times the volume, positive where the cell is positively oriented. */
double SixfoldVolume(const std::array<Point, 4>& p)
{
  Point u, v, t;
  for (int axis = 0; axis < 3; ++axis)
  {
    u[axis] = p[1][axis] - p[0][axis];
    v[axis] = p[2][axis] - p[0][axis];
    t[axis] = p[3][axis] - p[0][axis];
  }
  return u[0] * (v[1] * t[2] - v[2] * t[1]) + u[1] * (v[2] * t[0] - v[0] * t[2]) +
    u[2] * (v[0] * t[1] - v[1] * t[0]);
}
} // namespace

bool IsClosed(const FacetComplex& surface)
{
  std::vector<CountedEdge> edges = CountedEdges(surface);
  std::sort(edges.begin(), edges.end());
  for (std::size_t first = 0; first < edges.size();)
  {
    std::int64_t sum = 0;
    std::size_t next = first;
    for (; next < edges.size() && edges[next].IsSameEdge(edges[first]); ++next)
    {
      sum += edges[next].Count;
    }
    if (sum != 0)
    {
      return false;
    }
    first = next;
  }
  return true;
}

std::vector<double> WindingNumberOfCells(
  const FacetComplex& surface, const TetrahedralMesh& mesh, Monitor& monitor)
{
  const bool closed = IsClosed(surface);
  const bool complete =
    mesh.LostFacets.empty() && surface.NumberOfConstraints == surface.NumberOfFacets();
  if (closed && complete)
  {
    return WalkedWindingNumbers(surface, mesh, monitor);
  }
  std::vector<double> w = WindingNumberSum(surface, mesh.Points, mesh.Cells, monitor);
  if (closed)
  {
    // The sum is an integer but for rounding, or halfway between two in a barycentre on a facet.
    for (double& value : w)
    {
      value = std::round(2 * value) / 2;
    }
  }
  return w;
}

double SignedContent(const TetrahedralMesh& mesh, const std::vector<double>& w)
{
  // Compensated after Neumaier (1974).
  double sum = 0;
  double compensation = 0;
  for (std::size_t cell = 0; cell < mesh.Cells.size(); ++cell)
  {
    const Tetrahedron& corners = mesh.Cells[cell];
    const double term = w[cell] *
      SixfoldVolume({ mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]],
        mesh.Points[corners[3]] });
    const double next = sum + term;
    compensation += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return (sum + compensation) / 6;
}
} // namespace insideout
