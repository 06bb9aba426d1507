// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceWriters.h"

#include <algorithm>
#include <limits>
#include <set>

// The format: Turk, The PLY Polygon File Format (1994).

namespace insideout
{
namespace
{
/** The names of an attribute's properties in a PLY file. */
std::vector<std::string> PlyNames(const Attribute& attribute)
{
  const auto components = static_cast<std::size_t>(attribute.Components);
  if (IsColor(attribute))
  {
    std::vector<std::string> names = { "red", "green", "blue", "alpha" };
    names.resize(components);
    return names;
  }
  if (IsNormal(attribute))
  {
    return { "nx", "ny", "nz" };
  }
  if (IsTCoord(attribute))
  {
    return { "s", "t" };
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < components; ++i)
  {
    names.push_back(attribute.Name + (components > 1 ? "_" + std::to_string(i) : ""));
  }
  return names;
}

/** A name without blanks that no other property has. */
std::string FreePlyName(std::string name, std::set<std::string>& taken)
{
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~'; }, '_');
  name += name.empty() ? "_" : "";
  while (!taken.insert(name).second)
  {
    name += '_';
  }
  return name;
}

const char* PlyTypeName(const Attribute& attribute)
{
  constexpr std::array<const char*, 4> names = { "double", "float", "int", "uchar" };
  return names[attribute.Values.index()];
}

void WritePlyProperties(
  OutputFile& file, const std::vector<Attribute>& attributes, std::set<std::string> taken)
{
  for (const Attribute& attribute : attributes)
  {
    for (const std::string& name : PlyNames(attribute))
    {
      file.Text(
        std::string("property ") + PlyTypeName(attribute) + " " + FreePlyName(name, taken) + "\n");
    }
  }
}

void WritePlyValues(OutputFile& file, const std::vector<Attribute>& attributes, std::size_t index)
{
  for (const Attribute& attribute : attributes)
  {
    const auto components = static_cast<std::size_t>(attribute.Components);
    std::visit(
      [&file, index, components](const auto& values)
      {
        for (std::size_t i = index * components; i < (index + 1) * components; ++i)
        {
          file.Binary(values[i]);
        }
      },
      attribute.Values);
  }
}

bool HasLargePolygon(const PolygonSurface& surface)
{
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    if (CornersOf(surface, p) > std::numeric_limits<unsigned char>::max())
    {
      return true;
    }
  }
  return false;
}
} // namespace

void WritePly(OutputFile& file, const PolygonSurface& surface)
{
  const std::size_t polygons = surface.Offsets.size() - 1;
  const bool wideCounts = HasLargePolygon(surface); // a byte is what every reader knows
  file.Text("ply\nformat binary_little_endian 1.0\ncomment Written by InsideOut\n");
  file.Text("element vertex " + std::to_string(surface.Points.size()) + "\n");
  file.Text("property double x\nproperty double y\nproperty double z\n");
  WritePlyProperties(file, surface.PointAttributes, { "x", "y", "z" });
  file.Text("element face " + std::to_string(polygons) + "\n");
  file.Text(
    std::string("property list ") + (wideCounts ? "int" : "uchar") + " int vertex_indices\n");
  WritePlyProperties(file, surface.PolygonAttributes, { "vertex_indices", "vertex_index" });
  file.Text("end_header\n");
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    for (const double x : surface.Points[p])
    {
      file.Binary(x);
    }
    WritePlyValues(file, surface.PointAttributes, p);
  }
  for (std::size_t p = 0; p < polygons; ++p)
  {
    const Id count = CornersOf(surface, p);
    wideCounts ? file.Binary(count) : file.Binary(static_cast<unsigned char>(count));
    for (Id c = surface.Offsets[p]; c < surface.Offsets[p + 1]; ++c)
    {
      file.Binary(surface.Corners[static_cast<std::size_t>(c)]);
    }
    WritePlyValues(file, surface.PolygonAttributes, p);
  }
}
} // namespace insideout
