// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/PatchWindingNumbers.h"

#include "Common/FacetComplex.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "WindingNumber/ExactWindingNumber.h"

namespace insideout
{
namespace
{
/** For each patch its facet of the largest area, of several the lowest. */
std::vector<Id> LargestFacets(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  const SurfacePatches& patches)
{
  std::vector<Id> largest(static_cast<std::size_t>(patches.Count), None);
  std::vector<double> areas(largest.size(), 0);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    const std::array<Point, 3> corners = CornersOf(points, facets[f]);
    const double area = Length(NormalOf(corners[0], corners[1], corners[2]));
    const Id patch = patches.Patch[f];
    if (largest[patch] == None || area > areas[patch])
    {
      largest[patch] = static_cast<Id>(f);
      areas[patch] = area;
    }
  }
  return largest;
}
} // namespace

std::vector<PatchSides> WindingNumbersBesidePatches(const FacetComplex& surface,
  const SurfacePatches& patches, Monitor& monitor, const ProgressRange& progress)
{
  const std::vector<Point> points = ScaledPoints(surface.Points, -LargestExponent(surface.Points));
  const std::vector<Id> largest = LargestFacets(points, surface.Facets, patches);
  // A cell of which two corners are one has its barycentre in the facet, exactly.
  std::vector<Tetrahedron> middles;
  for (const Id f : largest)
  {
    const Triangle& facet = surface.Facets[f];
    middles.push_back({ { facet[0], facet[1], facet[2], facet[2] } });
  }
  std::vector<CountedTriangle> triangles = CountedFacets(surface);
  const std::vector<CountedEdge> boundary =
    CountedBoundary(triangles, static_cast<Id>(points.size()));
  const double middle = (progress.Begin + progress.End) / 2;
  const ExactWindingNumber windingNumber(
    points, std::move(triangles), boundary, monitor, { progress.Stage, progress.Begin, middle });
  const std::vector<double> means =
    windingNumber.Evaluate({ points, middles }, monitor, { progress.Stage, middle, progress.End });

  std::vector<PatchSides> sides;
  for (std::size_t patch = 0; patch < means.size(); ++patch)
  {
    const double half = surface.Multiplicity[largest[patch]] / 2.0;
    sides.push_back({ means[patch] - half, means[patch] + half });
  }
  return sides;
}
} // namespace insideout
