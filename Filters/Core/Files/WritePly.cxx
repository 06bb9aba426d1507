// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceWriters.h"

#include <algorithm>
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

/** Each after a blank. */
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
          file.Text(" ");
          file.Decimal(values[i]);
        }
      },
      attribute.Values);
  }
}

/** The type of a list's length: every reader supports a byte. */
const char* PlyCountType(const PolygonSurface& surface)
{
  constexpr Id mostInAByte = 255;
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    if (CornersOf(surface, p) > mostInAByte)
    {
      return "int";
    }
  }
  return "uchar";
}
} // namespace

// As text, with the list of points first in a face: gmsh reads only binary files of floats, and
// meshio only faces with that list, or with it first.
void WritePly(OutputFile& file, const PolygonSurface& surface)
{
  const std::size_t polygons = surface.Offsets.size() - 1;
  // Without points both formats differ only in the header, and meshio reads no such text.
  const bool isEmpty = surface.Points.empty();
  file.Text(std::string("ply\nformat ") + (isEmpty ? "binary_little_endian" : "ascii") + " 1.0\n");
  file.Text("comment Written by InsideOut\n");
  file.Text("element vertex " + std::to_string(surface.Points.size()) + "\n");
  file.Text("property double x\nproperty double y\nproperty double z\n");
  WritePlyProperties(file, surface.PointAttributes, { "x", "y", "z" });
  file.Text("element face " + std::to_string(polygons) + "\n");
  file.Text(std::string("property list ") + PlyCountType(surface) + " int vertex_indices\n");
  if (polygons > 0)
  {
    WritePlyProperties(file, surface.PolygonAttributes, { "vertex_indices", "vertex_index" });
  }
  file.Text("end_header\n");
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      file.Text(k > 0 ? " " : "");
      file.Decimal(surface.Points[p][k]);
    }
    WritePlyValues(file, surface.PointAttributes, p);
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
    WritePlyValues(file, surface.PolygonAttributes, p);
    file.Text("\n");
  }
}
} // namespace insideout
