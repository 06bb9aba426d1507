// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceWriters.h"

#include <algorithm>

// The format: Wavefront, Advanced Visualizer Manual, appendix B1 (object files).

namespace insideout
{
namespace
{
using AttributeTest = bool (*)(const Attribute&);

const Attribute* FindPointAttribute(const PolygonSurface& surface, AttributeTest test)
{
  const auto found =
    std::find_if(surface.PointAttributes.begin(), surface.PointAttributes.end(), test);
  return found == surface.PointAttributes.end() ? nullptr : &*found;
}

/** Numbers `first` to `first + count - 1` of the attribute, a blank before each. */
void WriteObjNumbers(
  OutputFile& file, const Attribute& attribute, std::size_t first, std::size_t count)
{
  std::visit(
    [&file, first, count](const auto& values)
    {
      for (std::size_t i = first; i < first + count; ++i)
      {
        // Colours are the only bytes, and OBJ has them from 0 to 1.
        const bool isByte = sizeof(values[i]) == 1;
        file.Text(" ");
        file.Decimal(isByte ? double(values[i]) / 255.0 : double(values[i]));
      }
    },
    attribute.Values);
}

void WriteObjPoints(OutputFile& file, const PolygonSurface& surface)
{
  const Attribute* const colors = FindPointAttribute(surface, IsColor);
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    file.Text("v");
    for (const double x : surface.Points[p])
    {
      file.Text(" ");
      file.Decimal(x);
    }
    if (colors)
    {
      WriteObjNumbers(file, *colors, p * static_cast<std::size_t>(colors->Components), 3);
    }
    file.Text("\n");
  }
}

/** One line per point, so that texture coordinates and normals have the ids of their points. */
void WriteObjData(OutputFile& file, const char* word, const Attribute* data)
{
  const std::size_t components = data ? static_cast<std::size_t>(data->Components) : 1;
  const std::size_t length = data ? LengthOf(*data) : 0;
  for (std::size_t i = 0; i < length; i += components)
  {
    file.Text(word);
    WriteObjNumbers(file, *data, i, components);
    file.Text("\n");
  }
}
} // namespace

void WriteObj(OutputFile& file, const PolygonSurface& surface)
{
  const Attribute* const normals = FindPointAttribute(surface, IsNormal);
  const Attribute* const tcoords = FindPointAttribute(surface, IsTCoord);
  WriteObjPoints(file, surface);
  WriteObjData(file, "vn", normals);
  WriteObjData(file, "vt", tcoords);
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    file.Text("f");
    for (Id c = surface.Offsets[p]; c < surface.Offsets[p + 1]; ++c)
    {
      const std::string id =
        std::to_string(std::int64_t(surface.Corners[static_cast<std::size_t>(c)]) + 1);
      file.Text(
        " " + id + (tcoords ? "/" + id : "") + (normals ? (tcoords ? "/" : "//") + id : ""));
    }
    file.Text("\n");
  }
}
} // namespace insideout
