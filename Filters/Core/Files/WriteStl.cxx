// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Vectors.h"
#include "Files/SurfaceWriters.h"

#include <cmath>
#include <limits>

// The format: see ReadStl.cxx.

namespace insideout
{
namespace
{
std::array<Point, 3> CornersOfTriangle(const PolygonSurface& surface, std::size_t polygon)
{
  std::array<Point, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto c = static_cast<std::size_t>(surface.Offsets[polygon]) + k;
    corners[k] = surface.Points[static_cast<std::size_t>(surface.Corners[c])];
  }
  return corners;
}

/** The unit normal; 0 if the triangle has none in doubles. */
Point UnitNormal(const std::array<Point, 3>& corners)
{
  Point normal = NormalOf(corners[0], corners[1], corners[2]);
  const double length = Length(normal);
  const bool told = length > 0.0 && std::isfinite(length);
  for (double& x : normal)
  {
    x = told ? x / length : 0.0;
  }
  return normal;
}
} // namespace

void CheckForStl(const PolygonSurface& surface)
{
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    if (CornersOf(surface, p) != 3)
    {
      throw Error(ErrorCode::InvalidParameter,
        "polygon " + std::to_string(p) + " has " + std::to_string(CornersOf(surface, p)) +
          " corners, but STL holds triangles only");
    }
  }
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    for (const double x : surface.Points[p])
    {
      if (std::isfinite(x) && std::abs(x) > double(std::numeric_limits<float>::max()))
      {
        throw Error(ErrorCode::InvalidParameter,
          "point " + std::to_string(p) + " is beyond the floats that STL holds");
      }
    }
  }
}

void WriteStl(OutputFile& file, const PolygonSurface& surface)
{
  constexpr std::size_t titleLength = 80;
  std::string title = "Binary STL of InsideOut"; // not "solid", which would look like ascii
  // VTK distinguishes an empty file from ascii by this
  title.resize(titleLength, '\0');
  file.Text(title);
  const std::size_t triangles = surface.Offsets.size() - 1;
  file.Binary(static_cast<std::uint32_t>(triangles));
  for (std::size_t t = 0; t < triangles; ++t)
  {
    const std::array<Point, 3> corners = CornersOfTriangle(surface, t);
    for (const Point& vector : { UnitNormal(corners), corners[0], corners[1], corners[2] })
    {
      for (const double x : vector)
      {
        file.Binary(static_cast<float>(x));
      }
    }
    file.Binary(std::uint16_t(0));
  }
}
} // namespace insideout
