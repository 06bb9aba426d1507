// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Files/SurfaceFile.h"
#include "Validate/TriangulatePolygon.h"

/** Files for the programs that judge and measure. */
namespace testmeshes
{
using namespace insideout;

/**
 * A surface file as triangles, as the filters see it. Polygons of fewer than three corners are left
 * out.
 *
 * @throws Error what ReadSurface throws
 */
inline TriangleSoup ReadTriangles(const std::string& path)
{
  Monitor monitor;
  PolygonSurface surface = ReadSurface(path, monitor);
  TriangleSoup soup;
  soup.Points = std::move(surface.Points);
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    const std::vector<Id> corners(surface.Corners.begin() + surface.Offsets[p],
      surface.Corners.begin() + surface.Offsets[p + 1]);
    if (corners.size() >= 3)
    {
      TriangulatePolygon(soup.Points, corners, soup.Triangles);
    }
  }
  return soup;
}
} // namespace testmeshes
