// SPDX-License-Identifier: GPL-3.0-or-later
#include "TwoSidedComponents.h"

#include <CGAL/Exact_rational.h>

#include <cmath>

namespace insideout
{
namespace
{
/** Per facet 1 where it has to be turned over to run along with its neighbours, else 0. */
std::vector<char> OrientAlongEdges(Id numberOfFacets, const std::vector<FacetEdge>& edges)
{
  struct Neighbor
  {
    Id Facet = None;
    bool Turned = false; ///< runs along the shared edge in the same direction
  };
  std::vector<std::array<Neighbor, 3>> neighbors(numberOfFacets);
  std::vector<int> degree(numberOfFacets, 0);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      if (last - first == 2)
      {
        const bool turned = first[0].Direction == first[1].Direction;
        neighbors[first[0].Facet][degree[first[0].Facet]++] = { first[1].Facet, turned };
        neighbors[first[1].Facet][degree[first[1].Facet]++] = { first[0].Facet, turned };
      }
    });

  constexpr char Unknown = 2;
  std::vector<char> turned(numberOfFacets, Unknown);
  std::vector<Id> stack;
  for (Id seed = 0; seed < numberOfFacets; ++seed)
  {
    if (turned[seed] != Unknown)
    {
      continue;
    }
    turned[seed] = 0;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Id facet = stack.back();
      stack.pop_back();
      for (int k = 0; k < degree[facet]; ++k)
      {
        const Neighbor& neighbor = neighbors[facet][k];
        if (turned[neighbor.Facet] == Unknown)
        {
          turned[neighbor.Facet] = static_cast<char>(turned[facet] != neighbor.Turned);
          stack.push_back(neighbor.Facet);
        }
      }
    }
  }
  return turned;
}

/** Six times the volume that the facets enclose, and the sum of the absolute terms. */
template <typename Number>
std::array<Number, 2> SixfoldVolume(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  const Point& origin = points[facets.front()[0]];
  Number volume = 0;
  Number size = 0;
  for (const Triangle& f : facets)
  {
    std::array<std::array<Number, 3>, 3> v;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        v[i][j] = Number(points[f[i]][j]) - Number(origin[j]);
      }
    }
    const Number term = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
      v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
      v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
    volume += term;
    size += term < 0 ? Number(-term) : term;
  }
  return { { volume, size } };
}

int SignOfVolume(const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  // Far above the relative error of a sum of millions of doubles, far below any real solid.
  constexpr double SureSign = 1e-9;
  const auto [volume, size] = SixfoldVolume<double>(points, facets);
  if (std::isfinite(size) && std::abs(volume) > SureSign * size)
  {
    return volume > 0 ? 1 : -1;
  }
  return static_cast<int>(CGAL::sign(SixfoldVolume<CGAL::Exact_rational>(points, facets)[0]));
}
} // namespace

TwoSidedComponents KeepTwoSidedSolids(
  FacetComplex& surface, const std::vector<FacetEdge>& edges, const FacetComponents& components)
{
  const Id numberOfFacets = surface.NumberOfFacets();
  std::vector<char> twoSided(components.Count, 1);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    twoSided[components.Component[f]] &= surface.Multiplicity[f] == 0;
  }

  const std::vector<char> turned = OrientAlongEdges(numberOfFacets, edges);
  std::vector<char> closes = twoSided;
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      int sum = 0;
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        sum += turned[edge->Facet] ? -edge->Direction : edge->Direction;
      }
      closes[components.Component[first->Facet]] &= sum == 0;
    });

  std::vector<std::vector<Triangle>> shells(components.Count);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    if (closes[components.Component[f]])
    {
      const Triangle& t = surface.Facets[f];
      shells[components.Component[f]].push_back(turned[f] ? Triangle{ { t[0], t[2], t[1] } } : t);
    }
  }
  std::vector<int> outward(components.Count, 0);
  TwoSidedComponents result;
  for (Id c = 0; c < components.Count; ++c)
  {
    outward[c] = closes[c] ? SignOfVolume(surface.Points, shells[c]) : 0;
    result.Solids += outward[c] != 0;
    result.Sheets += twoSided[c] && outward[c] == 0;
  }
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    if (const int sign = outward[components.Component[f]])
    {
      surface.Multiplicity[f] = static_cast<std::int16_t>(turned[f] ? -sign : sign);
    }
  }
  return result;
}
} // namespace insideout
