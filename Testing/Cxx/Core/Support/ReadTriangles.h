// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Files/SurfaceFile.h"

/** Files for the programs that judge and measure; the library leaves polygons to VTK. */
namespace testmeshes
{
using namespace insideout;

/**
 * A surface file as triangles. Polygons become fans from their first corner, which is not how the
 * filters triangulate those that are not convex.
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
    const Id first = surface.Offsets[p];
    for (Id c = first + 2; c < surface.Offsets[p + 1]; ++c)
    {
      soup.Triangles.push_back(
        { surface.Corners[first], surface.Corners[c - 1], surface.Corners[c] });
    }
  }
  return soup;
}
} // namespace testmeshes
