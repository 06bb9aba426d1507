// SPDX-License-Identifier: GPL-3.0-or-later
#include "SplitAtLoosePoints.h"

#include "BoxTree.h"
#include "TrianglePredicates.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** The points that no constraint has, ascending. */
std::vector<Id> FindLoosePoints(const FacetComplex& surface)
{
  std::vector<char> isCorner(surface.Points.size(), 0);
  for (Id f = 0; f < surface.NumberOfConstraints; ++f)
  {
    const Triangle& t = surface.Facets[f];
    isCorner[t[0]] = isCorner[t[1]] = isCorner[t[2]] = 1;
  }
  std::vector<Id> loose;
  for (std::size_t p = 0; p < isCorner.size(); ++p)
  {
    if (!isCorner[p])
    {
      loose.push_back(static_cast<Id>(p));
    }
  }
  return loose;
}

FilteredPoint Filtered(const Point& p)
{
  return { p[0], p[1], p[2] };
}

/** Whether a point lies in a triangle or on an edge of it, but not where a corner is. */
bool LiesWithin(const std::vector<Point>& points, const Triangle& t, Id p)
{
  const FilteredTriangle triangle = { Filtered(points[t[0]]), Filtered(points[t[1]]),
    Filtered(points[t[2]]) };
  const FilteredPoint point = Filtered(points[p]);
  return std::find(triangle.begin(), triangle.end(), point) == triangle.end() &&
    CGAL::coplanar(triangle[0], triangle[1], triangle[2], point) &&
    ContainsInPlane(triangle, point);
}

/** The triangle in pieces around the first point that lies within, these around the next, ... */
std::vector<Triangle> PiecesAround(
  const std::vector<Point>& points, const Triangle& triangle, const std::vector<Id>& inner)
{
  std::vector<Triangle> pieces = { triangle };
  for (const Id p : inner)
  {
    std::vector<Triangle> next;
    for (const Triangle& piece : pieces)
    {
      if (!LiesWithin(points, piece, p))
      {
        next.push_back(piece);
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        const Id from = piece[k];
        const Id to = piece[(k + 1) % 3];
        if (!IsDegenerate(points[from], points[to], points[p]))
        {
          next.push_back({ { from, to, p } });
        }
      }
    }
    pieces = std::move(next);
  }
  return pieces;
}

/** Constraints and what takes their places. */
struct SplitConstraint
{
  Id Facet;
  std::vector<Triangle> Pieces;
};

std::vector<SplitConstraint> SplitConstraints(const FacetComplex& surface)
{
  const std::vector<Id> loose = FindLoosePoints(surface);
  std::vector<Box> boxes;
  for (const Id p : loose)
  {
    boxes.push_back({ surface.Points[p], surface.Points[p] });
  }
  const BoxTree tree(std::move(boxes));
  std::vector<SplitConstraint> split;
  std::vector<Id> inner;
  for (Id f = 0; !loose.empty() && f < surface.NumberOfConstraints; ++f)
  {
    const Triangle& corners = surface.Facets[f];
    inner.clear();
    tree.Visit(BoundingBox(surface.Points, corners),
      [&](Id i)
      {
        if (LiesWithin(surface.Points, corners, loose[i]))
        {
          inner.push_back(loose[i]);
        }
      });
    if (!inner.empty())
    {
      // Of equal points the lowest becomes a corner, in each constraint.
      std::sort(inner.begin(), inner.end());
      split.push_back({ f, PiecesAround(surface.Points, corners, inner) });
    }
  }
  return split;
}

/** Append a facet with what another one counts. */
void Append(FacetComplex& surface, const Triangle& corners, const FacetComplex& from, Id facet)
{
  surface.Facets.push_back(corners);
  surface.Multiplicity.push_back(from.Multiplicity[facet]);
  surface.Sources.insert(surface.Sources.end(), from.Sources.begin() + from.SourceOffsets[facet],
    from.Sources.begin() + from.SourceOffsets[facet + 1]);
  surface.SourceOffsets.push_back(static_cast<Id>(surface.Sources.size()));
}
} // namespace

FacetComplex SplitAtLoosePoints(FacetComplex surface)
{
  const std::vector<SplitConstraint> split = SplitConstraints(surface);
  if (split.empty())
  {
    return surface;
  }
  FacetComplex result;
  auto next = split.begin();
  for (Id f = 0; f < surface.NumberOfConstraints; ++f)
  {
    if (next != split.end() && next->Facet == f)
    {
      ++next;
    }
    else
    {
      Append(result, surface.Facets[f], surface, f);
    }
  }
  for (const SplitConstraint& constraint : split)
  {
    for (const Triangle& piece : constraint.Pieces)
    {
      Append(result, piece, surface, constraint.Facet);
    }
  }
  result.NumberOfConstraints = result.NumberOfFacets();
  for (Id f = surface.NumberOfConstraints; f < surface.NumberOfFacets(); ++f)
  {
    Append(result, surface.Facets[f], surface, f);
  }
  result.Points = std::move(surface.Points);
  result.Origins = std::move(surface.Origins);
  return result;
}
} // namespace insideout
