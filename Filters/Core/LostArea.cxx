// SPDX-License-Identifier: GPL-3.0-or-later
#include "LostArea.h"

#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** A smaller share is what accessories and stray facets usually have. */
constexpr double WorthAWarning = 0.1;

double AreaOf(const std::vector<Point>& points, const Triangle& triangle)
{
  const std::array<Point, 3> corners = CornersOf(points, triangle);
  return Length(NormalOf(corners[0], corners[1], corners[2]));
}

/** For each facet whether one of its input triangles is in an ascending list. */
std::vector<char> FacetsOf(const FacetComplex& surface, const std::vector<Id>& triangles)
{
  std::vector<char> marks(surface.Facets.size(), 0);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    for (Id s = surface.SourceOffsets[f]; s < surface.SourceOffsets[f + 1] && !marks[f]; ++s)
    {
      marks[f] =
        std::binary_search(triangles.begin(), triangles.end(), surface.Sources[s].Triangle);
    }
  }
  return marks;
}

/** "12 % ", and why, if it is that much; else nothing. */
std::string Reason(double share, const std::string& why)
{
  const long percent = std::lround(100 * share);
  return percent > 0 ? "; " + std::to_string(percent) + " % " + why : std::string();
}
} // namespace

LostArea MeasureLostArea(const HullMesh& hull, const std::vector<OutlierPiece>& outliers)
{
  const std::vector<Point> points =
    ScaledPoints(hull.Mesh.Points, -LargestExponent(hull.Mesh.Points));
  double area = 0;
  for (const Triangle& facet : hull.Surface.Facets)
  {
    area += AreaOf(points, facet);
  }
  const std::vector<char> isSheet = FacetsOf(hull.Surface, hull.SheetTriangles);
  const std::vector<char> isTurned = FacetsOf(hull.Surface, hull.TurnedTriangles);
  LostArea lost;
  for (const OutlierPiece& piece : outliers)
  {
    double& part = piece.Reason != OutlierReason::Energy ? lost.Unmet
      : isSheet[piece.Facet]                             ? lost.Sheets
      : isTurned[piece.Facet]                            ? lost.Turned
                                                         : lost.Others;
    part += AreaOf(points, piece.Corners) / area;
  }
  lost.Share = lost.Sheets + lost.Turned + lost.Unmet + lost.Others;
  return lost;
}

std::string WarningAbout(const LostArea& lost)
{
  if (!(lost.Share > WorthAWarning))
  {
    return {};
  }
  return std::to_string(std::lround(100 * lost.Share)) +
    " % of the surface's area is no part of the solid" +
    Reason(lost.Sheets,
      "are sheets, which enclose nothing: Thicken gives them a width, ConstrainFacets keeps them") +
    Reason(lost.Turned, "were turned over and enclose nothing even so: see Orientation") +
    Reason(lost.Unmet, "could not be followed by the mesh") +
    Reason(lost.Others,
      "lie where the surface is too open (w is below 1/2), was smoothed away, or is of a region "
      "that "
      "was dropped: close holes, set Gamma lower, or ConstrainFacets to keep them");
}
} // namespace insideout
