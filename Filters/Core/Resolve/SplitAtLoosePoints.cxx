// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/SplitAtLoosePoints.h"

#include "Common/BoxTree.h"
#include "Common/LoopProgress.h"
#include "Common/TrianglePredicates.h"
#include "Resolve/AppendFacet.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace insideout
{
namespace
{
/** The points that belong to no constraint, ascending. */
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

/** Whether a point lies in a triangle or on its edges, excluding positions of the corners. */
bool LiesWithin(const std::vector<Point>& points, const Triangle& t, Id p)
{
  const FilteredTriangle triangle = ToFiltered(points, t);
  const FilteredPoint point = ToFiltered(points[p]);
  return std::find(triangle.begin(), triangle.end(), point) == triangle.end() &&
    CGAL::coplanar(triangle[0], triangle[1], triangle[2], point) &&
    ContainsInPlane(triangle, point);
}

/** The points within a triangle, in their order. */
std::vector<Id> PointsWithin(
  const std::vector<Point>& points, const Triangle& triangle, const std::vector<Id>& some)
{
  std::vector<Id> within;
  std::copy_if(some.begin(), some.end(), std::back_inserter(within),
    [&](Id p) { return LiesWithin(points, triangle, p); });
  return within;
}

/** The pieces of a triangle around its first inner point, recursively. */
std::vector<Triangle> PiecesAround(const std::vector<Point>& points, const Triangle& triangle,
  std::vector<Id> inner, const std::function<void()>& check)
{
  struct Part
  {
    Triangle Corners;
    std::vector<Id> Inner;
  };
  std::vector<Part> parts;
  parts.push_back({ triangle, std::move(inner) });
  std::vector<Triangle> pieces;
  while (!parts.empty())
  {
    const Part part = std::move(parts.back());
    parts.pop_back();
    if (part.Inner.empty())
    {
      pieces.push_back(part.Corners);
      continue;
    }
    check();
    const Id p = part.Inner.front();
    for (int k = 0; k < 3; ++k)
    {
      const Id from = part.Corners[k];
      const Id to = part.Corners[(k + 1) % 3];
      if (!IsDegenerate(points[from], points[to], points[p]))
      {
        const Triangle piece = { { from, to, p } };
        parts.push_back({ piece, PointsWithin(points, piece, part.Inner) });
      }
    }
  }
  return pieces;
}

/** Constraints and their replacements. */
struct SplitConstraint
{
  Id Facet;
  std::vector<Triangle> Pieces;
};

std::vector<SplitConstraint> SplitConstraints(
  const FacetComplex& surface, Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<Id> loose = FindLoosePoints(surface);
  std::vector<Box> boxes;
  for (const Id p : loose)
  {
    boxes.push_back({ surface.Points[p], surface.Points[p] });
  }
  const BoxTree tree(std::move(boxes));
  std::vector<SplitConstraint> split;
  const LoopProgress turns(
    monitor, progress, static_cast<std::size_t>(surface.NumberOfConstraints));
  for (Id f = 0; !loose.empty() && f < surface.NumberOfConstraints; ++f)
  {
    turns.Check(static_cast<std::size_t>(f));
    std::vector<Id> inner;
    tree.Visit(BoundingBox(surface.Points, surface.Facets[f]),
      [&](Id i)
      {
        if (LiesWithin(surface.Points, surface.Facets[f], loose[i]))
        {
          inner.push_back(loose[i]);
        }
      });
    if (!inner.empty())
    {
      // The lowest of coincident points becomes a corner, in each constraint.
      std::sort(inner.begin(), inner.end());
      split.push_back({ f,
        PiecesAround(surface.Points, surface.Facets[f], std::move(inner),
          [&]() { turns.CheckNow(static_cast<std::size_t>(f)); }) });
    }
  }
  return split;
}
} // namespace

FacetComplex SplitAtLoosePoints(
  FacetComplex surface, Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<SplitConstraint> split = SplitConstraints(surface, monitor, progress);
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
      AppendFacet(result, surface.Facets[f], surface, f);
    }
  }
  for (const SplitConstraint& constraint : split)
  {
    for (const Triangle& piece : constraint.Pieces)
    {
      AppendFacet(result, piece, surface, constraint.Facet);
    }
  }
  result.NumberOfConstraints = result.NumberOfFacets();
  for (Id f = surface.NumberOfConstraints; f < surface.NumberOfFacets(); ++f)
  {
    AppendFacet(result, surface.Facets[f], surface, f);
  }
  result.Points = std::move(surface.Points);
  result.Origins = std::move(surface.Origins);
  return result;
}
} // namespace insideout
