// SPDX-License-Identifier: GPL-3.0-or-later
#include "LostArea.h"

#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insideout
{
namespace
{
/** A smaller fraction is usual for accessories and stray facets. */
constexpr double WorthAWarning = 0.1;

/** Share of a shell's area that rounding leaves after all of its pieces are subtracted. */
constexpr double Rounding = 1e-9;

/** Limit of the shells that a warning names. */
constexpr std::size_t MostNamed = 4;

double AreaOf(const std::vector<Point>& points, const Triangle& triangle)
{
  const std::array<Point, 3> corners = CornersOf(points, triangle);
  return Length(NormalOf(corners[0], corners[1], corners[2]));
}

/** Per facet, whether one of its input triangles is in an ascending list. */
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

/** "12 % ", and the reason, if it is at least that much; else nothing. */
std::string Reason(double share, const std::string& why)
{
  const long percent = std::lround(100 * share);
  return percent > 0 ? "; " + std::to_string(percent) + " % " + why : std::string();
}

/** The shells with holes and without a facet on the solid. */
std::vector<HoledShell> LostShells(
  const HullMesh& hull, const std::vector<OutlierPiece>& outliers, const std::vector<Point>& points)
{
  if (hull.HoledShells.empty() || outliers.empty())
  {
    return {};
  }
  std::vector<std::pair<Id, std::size_t>> shellOf; // by triangle
  for (std::size_t shell = 0; shell < hull.HoledShells.size(); ++shell)
  {
    for (const Id triangle : hull.HoledShells[shell].Triangles)
    {
      shellOf.push_back({ triangle, shell });
    }
  }
  std::sort(shellOf.begin(), shellOf.end());
  std::vector<double> left(hull.HoledShells.size(), 0); // area on the solid, by shell
  const auto add = [&](Id facet, double area)
  {
    for (Id s = hull.Surface.SourceOffsets[facet]; s < hull.Surface.SourceOffsets[facet + 1]; ++s)
    {
      const Id triangle = hull.Surface.Sources[s].Triangle;
      const auto found =
        std::lower_bound(shellOf.begin(), shellOf.end(), std::make_pair(triangle, std::size_t(0)));
      if (found != shellOf.end() && found->first == triangle)
      {
        left[found->second] += area;
      }
    }
  };
  for (Id f = 0; f < hull.Surface.NumberOfFacets(); ++f)
  {
    add(f, AreaOf(points, hull.Surface.Facets[f]));
  }
  const std::vector<double> whole = left;
  for (const OutlierPiece& piece : outliers)
  {
    add(piece.Facet, -AreaOf(points, piece.Corners));
  }
  std::vector<HoledShell> lost;
  for (std::size_t shell = 0; shell < left.size(); ++shell)
  {
    if (left[shell] <= Rounding * whole[shell])
    {
      lost.push_back(hull.HoledShells[shell]);
    }
  }
  return lost;
}

std::string WarningAboutShells(const std::vector<HoledShell>& shells)
{
  const bool isOne = shells.size() == 1;
  std::string text = isOne ? "shell " : "shells ";
  for (std::size_t i = 0; i < std::min(shells.size(), MostNamed); ++i)
  {
    const HoledShell& shell = shells[i];
    char volume[32];
    std::snprintf(volume, sizeof(volume), "%.3g", shell.Volume);
    text += (i > 0 ? ", " : "") + std::to_string(shell.Number) +
      (shell.Body.empty() ? "" : " of body " + shell.Body) + " (volume " + volume + ")";
  }
  if (shells.size() > MostNamed)
  {
    text += " and " + std::to_string(shells.size() - MostNamed) + " more";
  }
  return text + (isOne ? " has holes and is" : " have holes and are") +
    " not part of the solid: close the holes, or set Gamma lower";
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
  lost.Shells = LostShells(hull, outliers, points);
  return lost;
}

std::vector<std::string> WarningsAbout(const LostArea& lost)
{
  std::vector<std::string> warnings;
  if (!lost.Shells.empty())
  {
    warnings.push_back(WarningAboutShells(lost.Shells));
  }
  if (lost.Share > WorthAWarning)
  {
    warnings.push_back(std::to_string(std::lround(100 * lost.Share)) +
      " % of the surface's area is not part of the solid" +
      Reason(lost.Sheets,
        "are sheets, which enclose nothing: Thicken gives them a width, ConstrainFacets keeps "
        "them") +
      Reason(lost.Turned, "were turned over and enclose nothing even so: see Orientation") +
      Reason(lost.Unmet, "could not be followed by the mesh") +
      Reason(lost.Others,
        "lie where the surface is too open (w is below 1/2), was smoothed away, or is of a region "
        "that was dropped: close holes, set Gamma lower, or ConstrainFacets to keep them"));
  }
  return warnings;
}
} // namespace insideout
