// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/TwoSidedComponents.h"

#include "Common/Numbers.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Sets of consistently oriented facets joined through edges of exactly two facets. */
struct OrientedPatches
{
  std::vector<char> Turned; ///< per facet, 1 if it has to be turned over to agree
  std::vector<Id> Patch;    ///< per facet
  Id Count = 0;
};

OrientedPatches OrientAlongEdges(Id numberOfFacets, const FacetEdges& edges)
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

  OrientedPatches patches;
  patches.Turned.assign(numberOfFacets, 0);
  patches.Patch.assign(numberOfFacets, None);
  std::vector<Id> stack;
  for (Id seed = 0; seed < numberOfFacets; ++seed)
  {
    if (patches.Patch[seed] != None)
    {
      continue;
    }
    patches.Patch[seed] = patches.Count++;
    stack.push_back(seed);
    while (!stack.empty())
    {
      const Id facet = stack.back();
      stack.pop_back();
      for (int k = 0; k < degree[facet]; ++k)
      {
        const Neighbor& neighbor = neighbors[facet][k];
        if (patches.Patch[neighbor.Facet] == None)
        {
          patches.Patch[neighbor.Facet] = patches.Patch[facet];
          patches.Turned[neighbor.Facet] =
            static_cast<char>(patches.Turned[facet] != neighbor.Turned);
          stack.push_back(neighbor.Facet);
        }
      }
    }
  }
  return patches;
}

/** For each patch whether it runs along every one of its edges equally often in both directions. */
std::vector<char> ClosedPatches(const OrientedPatches& patches, const FacetEdges& edges)
{
  std::vector<char> closed(patches.Count, 1);
  std::vector<int> sum(patches.Count, 0);
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        sum[patches.Patch[edge->Facet]] +=
          patches.Turned[edge->Facet] ? -edge->Direction : edge->Direction;
      }
      for (const FacetEdge* edge = first; edge != last; ++edge)
      {
        int& open = sum[patches.Patch[edge->Facet]];
        closed[patches.Patch[edge->Facet]] &= open == 0;
        open = 0;
      }
    });
  return closed;
}

/** Six times the enclosed volume, and the sum of the absolute terms. */
template <typename Number>
std::array<Number, 2> SixfoldVolume(
  const std::vector<Point>& points, const std::vector<Triangle>& facets)
{
  const Point& origin = points[facets.front()[0]];
  Number volume = 0;
  Number size = 0;
  for (const Triangle& f : facets)
  {
    std::array<Vector<Number>, 3> v;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        v[i][j] = Number(points[f[i]][j]) - Number(origin[j]);
      }
    }
    const Number term = Determinant(v[0], v[1], v[2]);
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
  return static_cast<int>(CGAL::sign(SixfoldVolume<DyadicNumber>(points, facets)[0]));
}
} // namespace

TwoSidedComponents KeepTwoSidedSolids(
  FacetComplex& surface, const FacetEdges& edges, const FacetComponents& components)
{
  const Id numberOfFacets = surface.NumberOfFacets();
  std::vector<char> twoSided(components.Count, 1);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    twoSided[components.Component[f]] &= surface.Multiplicity[f] == 0;
  }
  if (std::find(twoSided.begin(), twoSided.end(), 1) == twoSided.end())
  {
    return {};
  }

  const OrientedPatches patches = OrientAlongEdges(numberOfFacets, edges);
  const std::vector<char> closed = ClosedPatches(patches, edges);
  std::vector<std::vector<Triangle>> shells(patches.Count);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    if (twoSided[components.Component[f]] && closed[patches.Patch[f]])
    {
      const Triangle& t = surface.Facets[f];
      shells[patches.Patch[f]].push_back(patches.Turned[f] ? Triangle{ { t[0], t[2], t[1] } } : t);
    }
  }
  std::vector<int> outward(patches.Count, 0);
  for (Id p = 0; p < patches.Count; ++p)
  {
    outward[p] = shells[p].empty() ? 0 : SignOfVolume(surface.Points, shells[p]);
  }

  std::vector<char> isSolid(components.Count, 0);
  for (Id f = 0; f < numberOfFacets; ++f)
  {
    if (twoSided[components.Component[f]])
    {
      surface.Opposed[f] = 0;
    }
    if (const int sign = outward[patches.Patch[f]])
    {
      surface.Multiplicity[f] = static_cast<std::int16_t>(patches.Turned[f] ? -sign : sign);
      isSolid[components.Component[f]] = 1;
    }
  }
  TwoSidedComponents result;
  for (Id c = 0; c < components.Count; ++c)
  {
    result.Solids += isSolid[c];
    result.Sheets += twoSided[c] && !isSolid[c];
  }
  return result;
}
} // namespace insideout
