// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceWriters.h"

#include <algorithm>
#include <initializer_list>
#include <variant>

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

/** Values `first` to `first + count - 1` of the attribute, each after a blank. */
void WriteObjNumbers(
  OutputFile& file, const Attribute& attribute, std::size_t first, std::size_t count)
{
  std::visit(
    [&file, first, count](const auto& values)
    {
      for (std::size_t i = first; i < first + count; ++i)
      {
        // Colors are the only bytes; in OBJ they range from 0 to 1.
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
/** A name as one line of OBJ can hold it: a number sign after a blank begins a comment, and a
 * backslash at the end joins the line with the next. */
std::string ObjName(std::string name)
{
  char before = ' ';
  for (char& c : name)
  {
    c = static_cast<unsigned char>(c) < ' ' ? ' ' : c == '#' && before == ' ' ? '_' : c;
    before = c;
  }
  if (!name.empty() && name.back() == '\\')
  {
    name.back() = '_';
  }
  return name;
}

/** An OBJ statement with the group or material of the next polygons. */
class ObjGrouping
{
public:
  /** Use the first of some attributes of polygons that exists and has names. */
  ObjGrouping(const char* word, const PolygonSurface& surface,
    std::initializer_list<std::array<const char*, 2>> candidates)
    : Word(word)
  {
    for (const auto& [ids, name] : candidates)
    {
      for (const Attribute& attribute : surface.PolygonAttributes)
      {
        const auto* numbers = std::get_if<std::vector<std::int32_t>>(&attribute.Values);
        if (!this->Names && attribute.Name == ids && attribute.Components == 1 && numbers)
        {
          this->Numbers = numbers;
          this->Names = FindNames(surface, name);
        }
      }
    }
  }

  /** Call before each polygon. */
  void Write(OutputFile& file, std::size_t polygon)
  {
    if (!this->Names || (polygon > 0 && (*this->Numbers)[polygon] == this->Last))
    {
      return;
    }
    this->Last = (*this->Numbers)[polygon];
    const auto index = static_cast<std::size_t>(this->Last);
    const bool isNamed = index < this->Names->size() && !(*this->Names)[index].empty();
    const std::string name = isNamed ? ObjName((*this->Names)[index]) : std::to_string(this->Last);
    file.Text(std::string(this->Word) + " " + name + "\n");
  }

private:
  static const std::vector<std::string>* FindNames(const PolygonSurface& surface, const char* name)
  {
    const auto found = std::find_if(surface.Names.begin(), surface.Names.end(),
      [name](const AttributeNames& names) { return names.Name == name; });
    return found == surface.Names.end() ? nullptr : &found->Values;
  }

  const char* const Word;
  const std::vector<std::int32_t>* Numbers = nullptr;
  const std::vector<std::string>* Names = nullptr;
  std::int32_t Last = 0;
};
} // namespace

void WriteObj(OutputFile& file, const PolygonSurface& surface)
{
  const Attribute* const normals = FindPointAttribute(surface, IsNormal);
  const Attribute* const tcoords = FindPointAttribute(surface, IsTCoord);
  file.Text("# Written by InsideOut\n");
  WriteObjPoints(file, surface);
  WriteObjData(file, "vn", normals);
  WriteObjData(file, "vt", tcoords);
  ObjGrouping group(
    "g", surface, { { "BoundaryTag", "BoundaryTagNames" }, { "GroupIds", "GroupNames" } });
  ObjGrouping material("usemtl", surface, { { "MaterialIds", "MaterialNames" } });
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    group.Write(file, p);
    material.Write(file, p);
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
