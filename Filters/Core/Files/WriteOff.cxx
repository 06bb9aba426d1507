// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceWriters.h"

// The format: see ReadOff.cxx.

namespace insideout
{
void WriteOff(OutputFile& file, const PolygonSurface& surface)
{
  const std::size_t polygons = surface.Offsets.size() - 1;
  // The comment follows the counts: some readers (Geogram's, and so fTetWild's) want them in the
  // second line.
  file.Text("OFF\n" + std::to_string(surface.Points.size()) + " " + std::to_string(polygons) +
    " 0\n# Written by InsideOut\n");
  for (const Point& point : surface.Points)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      file.Text(k > 0 ? " " : "");
      file.Decimal(point[k]);
    }
    file.Text("\n");
  }
  for (std::size_t p = 0; p < polygons; ++p)
  {
    file.Decimal(CornersOf(surface, p));
    for (Id c = surface.Offsets[p]; c < surface.Offsets[p + 1]; ++c)
    {
      file.Text(" ");
      file.Decimal(surface.Corners[static_cast<std::size_t>(c)]);
    }
    file.Text("\n");
  }
}
} // namespace insideout
