// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ThickenFacets.h"

#include "Common/Box.h"
#include "Common/DisjointSets.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Orient/Shells.h"
#include "Validate/CountedChain.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace insideout
{
namespace
{
/**
 * The least width relative to the surface's size: far more than rounding, far less than any sheet.
 */
constexpr double LeastWidth = 1e-9;

/** Limit of a slab corner's distance relative to half the width, where facets bend. */
constexpr double MostMiter = 2;

/** Facets of one sheet, and the corners of the slab around them. */
class Slab
{
public:
  Slab(const FacetComplex& surface, std::vector<Id> facets)
    : Surface(surface)
    , Scaled(ScaledPoints(surface.Points, -LargestExponent(surface.Points)))
    , Facets(std::move(facets))
    , Corners(3 * this->Facets.size())
    , IsRim(3 * this->Facets.size(), 1)
  {
    FacetComplex part;
    part.Points = surface.Points;
    for (const Id f : this->Facets)
    {
      part.Facets.push_back(surface.Facets[f]);
      part.Multiplicity.push_back(1);
    }
    const FacetEdges edges = SortedFacetEdges(part.Facets);
    this->Turned = FindShells(part, edges).Turned;
    ForEachEdge(edges,
      [&](const FacetEdge* first, const FacetEdge* last)
      {
        const auto direction = [&](const FacetEdge& edge)
        { return this->Turned[edge.Facet] ? -edge.Direction : edge.Direction; };
        if (last - first == 2 && direction(first[0]) + direction(first[1]) == 0)
        {
          this->JoinAlong(part.Facets, first[0], first[1]);
        }
      });
  }

  /** Append the slab's points and triangles. @param[out] facets that the triangles belong to */
  void Append(double width, std::vector<Point>& points, std::vector<PointOrigin>& origins,
    std::vector<Triangle>& triangles, std::vector<FacetSource>& facets)
  {
    std::map<Id, std::array<Id, 2>> placed; // per set of corners: the points before and behind
    const std::vector<Point> normals = this->SumsOfNormals();
    const auto place = [&](std::size_t facet, int k) -> const std::array<Id, 2>&
    {
      const Id set = this->Corners.Find(static_cast<Id>(3 * facet + k));
      auto& both = placed[set];
      if (both[0] == both[1])
      {
        const Id p = this->CornerOf(facet, k);
        const Point offset = this->Offset(set, normals, width / 2);
        for (const int side : { 0, 1 })
        {
          Point corner = this->Surface.Points[p];
          for (int axis = 0; axis < 3; ++axis)
          {
            corner[axis] += side == 0 ? offset[axis] : -offset[axis];
          }
          both[side] = static_cast<Id>(points.size());
          points.push_back(corner);
          origins.push_back(PointOrigin::Like(this->Surface.Origins[p].Points[0]));
        }
      }
      return both;
    };
    for (std::size_t i = 0; i < this->Facets.size(); ++i)
    {
      const bool turned = this->Turned[i] != 0;
      const std::array<int, 3> order =
        turned ? std::array<int, 3>{ { 0, 2, 1 } } : std::array<int, 3>{ { 0, 1, 2 } };
      const auto add = [&](Id a, Id b, Id c, bool reversed)
      {
        triangles.push_back({ { a, b, c } });
        facets.push_back({ this->Facets[i], reversed });
      };
      const std::array<std::array<Id, 2>, 3> c = { { place(i, order[0]), place(i, order[1]),
        place(i, order[2]) } };
      add(c[0][0], c[1][0], c[2][0], turned);
      add(c[0][1], c[2][1], c[1][1], !turned);
      for (int k = 0; k < 3; ++k)
      {
        const int next = (k + 1) % 3;
        if (this->IsRim[3 * i + EdgeBetween(order[k], order[next])])
        {
          // With the facet's own edge, so that it does not stick out if the rim is not planar.
          const Id from = this->CornerOf(i, order[k]);
          const Id to = this->CornerOf(i, order[next]);
          add(c[k][0], from, to, turned);
          add(c[k][0], to, c[next][0], turned);
          add(from, c[k][1], c[next][1], turned);
          add(from, c[next][1], to, turned);
        }
      }
    }
  }

private:
  Id CornerOf(std::size_t facet, int k) const
  {
    return this->Surface.Facets[this->Facets[facet]][k];
  }

  /** The number of the edge from corner k to k + 1, regardless of direction. */
  static std::size_t EdgeBetween(int a, int b)
  {
    return static_cast<std::size_t>((a + 1) % 3 == b ? a : b);
  }

  void JoinAlong(const std::vector<Triangle>& facets, const FacetEdge& a, const FacetEdge& b)
  {
    for (const Id p : { a.Low, a.High })
    {
      const auto corner = [&](Id facet)
      {
        const auto begin = facets[facet].begin();
        return static_cast<Id>(3 * facet + (std::find(begin, begin + 3, p) - begin));
      };
      this->Corners.Join(corner(a.Facet), corner(b.Facet));
    }
    for (const FacetEdge& edge : { a, b })
    {
      const Triangle& facet = facets[edge.Facet];
      for (int k = 0; k < 3; ++k)
      {
        const Id from = facet[k];
        const Id to = facet[(k + 1) % 3];
        if (std::min(from, to) == edge.Low && std::max(from, to) == edge.High)
        {
          this->IsRim[static_cast<std::size_t>(3 * edge.Facet + k)] = 0;
        }
      }
    }
  }

  /** The unit normal of a facet as it is turned. */
  Point UnitNormal(std::size_t facet) const
  {
    const std::array<Point, 3> c =
      CornersOf(this->Scaled, this->Surface.Facets[this->Facets[facet]]);
    Point normal = NormalOf(c[0], c[1], c[2]);
    const double length = Length(normal) * (this->Turned[facet] ? -1 : 1);
    for (double& x : normal)
    {
      x = length != 0 ? x / length : 0;
    }
    return normal;
  }

  /** Per set of corners the sum of normals, each weighted by the corner's angle. */
  std::vector<Point> SumsOfNormals()
  {
    std::vector<Point> sums(3 * this->Facets.size(), Point{ 0, 0, 0 });
    this->FacetsAt.assign(sums.size(), {});
    for (std::size_t i = 0; i < this->Facets.size(); ++i)
    {
      const std::array<Point, 3> c = CornersOf(this->Scaled, this->Surface.Facets[this->Facets[i]]);
      const Point normal = this->UnitNormal(i);
      for (int k = 0; k < 3; ++k)
      {
        const Point u = Difference(c[(k + 1) % 3], c[k]);
        const Point v = Difference(c[(k + 2) % 3], c[k]);
        const double angle = std::atan2(Length(Cross(u, v)), Dot(u, v));
        const Id set = this->Corners.Find(static_cast<Id>(3 * i + k));
        this->FacetsAt[set].push_back(i);
        for (int axis = 0; axis < 3; ++axis)
        {
          sums[set][axis] += angle * normal[axis];
        }
      }
    }
    return sums;
  }

  /** The vector from the surface to a corner of the slab. */
  Point Offset(Id set, const std::vector<Point>& sums, double half) const
  {
    const std::vector<std::size_t>& facets = this->FacetsAt[set];
    Point direction = sums[set];
    double length = Length(direction);
    if (!(length > 1e-6)) // a fold: any of the normals is suitable
    {
      direction = this->UnitNormal(facets.front());
      length = 1;
    }
    double least = 1; // cosine of the angle between the direction and a normal
    for (double& x : direction)
    {
      x /= length;
    }
    for (const std::size_t i : facets)
    {
      least = std::min(least, Dot(direction, this->UnitNormal(i)));
    }
    const double reach = half * std::min(MostMiter, 1 / std::max(least, 1e-6));
    return { reach * direction[0], reach * direction[1], reach * direction[2] };
  }

  const FacetComplex& Surface;
  const std::vector<Point> Scaled; // scaled for angles and normals, to prevent overflow
  const std::vector<Id> Facets;
  DisjointSets Corners;    // corner k of facet i is 3 i + k
  std::vector<char> IsRim; // per edge, from corner k to k + 1
  std::vector<char> Turned;
  std::vector<std::vector<std::size_t>> FacetsAt; // per set of corners
};

void CheckWidth(double width, const FacetComplex& surface)
{
  const Box box = BoundingBox(surface.Points);
  const double least = LeastWidth * Distance(box.Low, box.High);
  if (!(width >= 0) || std::isinf(width) || (width > 0 && width < least))
  {
    throw Error(ErrorCode::InvalidParameter,
      "Thicken is " + std::to_string(width) + "; it must be finite and 0, or at least " +
        std::to_string(LeastWidth) + " of the surface's size");
  }
}

/** The counted facets of a soup whose triangles come from facets of a surface. */
FacetComplex Recount(const TriangleSoup& soup, const std::vector<PointOrigin>& origins,
  const std::vector<FacetSource>& facets, const FacetComplex& surface, Monitor& monitor)
{
  FacetComplex counted = CountFacets(soup, {}, monitor).Surface;
  for (PointOrigin& origin : counted.Origins)
  {
    origin = origins[origin.Points[0]];
  }
  std::vector<FacetSource> sources;
  std::vector<Id> offsets = { 0 };
  for (Id f = 0; f < counted.NumberOfFacets(); ++f)
  {
    const std::size_t first = sources.size();
    for (Id s = counted.SourceOffsets[f]; s < counted.SourceOffsets[f + 1]; ++s)
    {
      const auto [triangle, reversed] = counted.Sources[s];
      const auto [facet, facetReversed] = facets[triangle];
      for (Id t = surface.SourceOffsets[facet]; t < surface.SourceOffsets[facet + 1]; ++t)
      {
        const bool turned = (reversed != facetReversed) != surface.Sources[t].Reversed;
        sources.push_back({ surface.Sources[t].Triangle, turned });
      }
    }
    std::stable_sort(sources.begin() + static_cast<std::ptrdiff_t>(first), sources.end(),
      [](const FacetSource& a, const FacetSource& b) { return a.Triangle < b.Triangle; });
    offsets.push_back(static_cast<Id>(sources.size()));
  }
  counted.Sources = std::move(sources);
  counted.SourceOffsets = std::move(offsets);
  return counted;
}
} // namespace

Id ThickenFacets(FacetComplex& surface, const std::vector<char>& isSheet,
  const ThickenParameters& parameters, Monitor& monitor)
{
  CheckWidth(parameters.Width, surface);
  std::vector<Id> chosen;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (parameters.Width > 0 && (parameters.All || isSheet[f]))
    {
      chosen.push_back(f);
    }
  }
  if (chosen.empty())
  {
    return 0;
  }
  TriangleSoup soup = { surface.Points, surface.Facets, surface.Multiplicity };
  std::vector<FacetSource> facets; // of the surface, per triangle
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    facets.push_back({ f, false });
    soup.Multiplicity[f] = isSheet[f] ? 0 : soup.Multiplicity[f];
  }
  std::vector<PointOrigin> origins = surface.Origins;
  Slab(surface, chosen).Append(parameters.Width, soup.Points, origins, soup.Triangles, facets);
  soup.Multiplicity.resize(soup.Triangles.size(), 1);
  surface = Recount(soup, origins, facets, surface, monitor);
  return static_cast<Id>(chosen.size());
}
} // namespace insideout
