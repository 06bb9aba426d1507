// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/ByteOrder.h"
#include "Files/SurfaceFile.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <system_error>

namespace insideout
{
namespace
{
/** A file that is written through a buffer; what fails is an Error. */
class OutputFile
{
public:
  explicit OutputFile(const std::string& path)
    : Path(path)
    , File(std::fopen(path.c_str(), "wb"), &std::fclose)
  {
    this->FailUnless(this->File != nullptr);
    this->Buffer.reserve(BufferLength + 4096);
  }

  void Text(std::string_view text)
  {
    this->Buffer += text;
    if (this->Buffer.size() >= BufferLength)
    {
      this->Flush();
    }
  }

  /** The shortest text that is read back as the same number. */
  template <typename T>
  void Decimal(T value)
  {
    std::array<char, 32> text;
    const std::to_chars_result result =
      std::to_chars(text.data(), text.data() + text.size(), value);
    this->Text({ text.data(), static_cast<std::size_t>(result.ptr - text.data()) });
  }

  template <typename T>
  void Binary(T value)
  {
    std::array<char, sizeof(T)> bytes;
    StoreLittleEndian(bytes.data(), value);
    this->Text({ bytes.data(), bytes.size() });
  }

  /** Has to be called last: only then is everything known to be written. */
  void Close()
  {
    this->Flush();
    this->FailUnless(std::fclose(this->File.release()) == 0);
  }

private:
  static constexpr std::size_t BufferLength = std::size_t(1) << 20;

  void Flush()
  {
    const std::size_t written =
      std::fwrite(this->Buffer.data(), 1, this->Buffer.size(), this->File.get());
    this->FailUnless(written == this->Buffer.size());
    this->Buffer.clear();
  }

  void FailUnless(bool succeeded) const
  {
    if (!succeeded)
    {
      throw Error(
        ErrorCode::FileUnwritable, this->Path + ": " + std::generic_category().message(errno));
    }
  }

  const std::string Path;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> File;
  std::string Buffer;
};

std::size_t LengthOf(const Attribute& attribute)
{
  return std::visit([](const auto& values) { return values.size(); }, attribute.Values);
}

void CheckAttributes(const std::vector<Attribute>& attributes, std::size_t count)
{
  for (const Attribute& attribute : attributes)
  {
    if (attribute.Components < 1 ||
      LengthOf(attribute) != count * static_cast<std::size_t>(attribute.Components))
    {
      throw Error(ErrorCode::InvalidParameter,
        "attribute " + Quoted(attribute.Name) + " has another length than what it belongs to");
    }
  }
}

/** Writers may trust what passes here. */
void CheckSurface(const PolygonSurface& surface)
{
  const bool ordered = !surface.Offsets.empty() && surface.Offsets.front() == 0 &&
    std::is_sorted(surface.Offsets.begin(), surface.Offsets.end()) &&
    surface.Corners.size() == static_cast<std::size_t>(surface.Offsets.back());
  if (!ordered)
  {
    throw Error(
      ErrorCode::InvalidParameter, "the offsets of the polygons do not fit their corners");
  }
  const auto points = static_cast<Id>(surface.Points.size());
  const auto bad = std::find_if(surface.Corners.begin(), surface.Corners.end(),
    [points](Id corner) { return corner < 0 || corner >= points; });
  if (bad != surface.Corners.end())
  {
    const auto corner = static_cast<Id>(bad - surface.Corners.begin());
    const auto polygon = std::upper_bound(surface.Offsets.begin(), surface.Offsets.end(), corner) -
      surface.Offsets.begin() - 1;
    throw Error(ErrorCode::PointOutOfRange,
      "polygon " + std::to_string(polygon) + " refers to point " + std::to_string(*bad) + " of " +
        std::to_string(points));
  }
  CheckAttributes(surface.PointAttributes, surface.Points.size());
  CheckAttributes(surface.PolygonAttributes, surface.Offsets.size() - 1);
}

bool HasFractions(const Attribute& attribute)
{
  return std::holds_alternative<std::vector<double>>(attribute.Values) ||
    std::holds_alternative<std::vector<float>>(attribute.Values);
}

bool IsColor(const Attribute& attribute)
{
  return attribute.Name == "Colors" &&
    std::holds_alternative<std::vector<unsigned char>>(attribute.Values) &&
    (attribute.Components == 3 || attribute.Components == 4);
}

bool IsNormal(const Attribute& attribute)
{
  return attribute.Name == "Normals" && HasFractions(attribute) && attribute.Components == 3;
}

bool IsTCoord(const Attribute& attribute)
{
  return attribute.Name == "TCoords" && HasFractions(attribute) && attribute.Components == 2;
}

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

Id CornersOf(const PolygonSurface& surface, std::size_t polygon)
{
  return surface.Offsets[polygon + 1] - surface.Offsets[polygon];
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

void WritePly(OutputFile& file, const PolygonSurface& surface)
{
  const std::size_t polygons = surface.Offsets.size() - 1;
  const bool wideCounts = HasLargePolygon(surface); // a byte is what every reader knows
  file.Text("ply\nformat binary_little_endian 1.0\n");
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

/** The unit normal; 0 where the triangle has none that doubles can tell. */
Point UnitNormal(const std::array<Point, 3>& corners)
{
  Point u;
  Point v;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    u[axis] = corners[1][axis] - corners[0][axis];
    v[axis] = corners[2][axis] - corners[0][axis];
  }
  Point normal = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0] };
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const bool told = length > 0.0 && std::isfinite(length);
  for (double& x : normal)
  {
    x = told ? x / length : 0.0;
  }
  return normal;
}

/** @throws Error InvalidParameter where STL cannot hold the surface */
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
  title.resize(titleLength, '\0');               // by which VTK tells an empty file from ascii
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
} // namespace

void WriteSurface(const std::string& path, const PolygonSurface& surface)
{
  CheckSurface(surface);
  const std::string ending = std::filesystem::path(path).extension().string();
  const bool isStl = EqualsIgnoringCase(ending, ".stl");
  const bool isPly = EqualsIgnoringCase(ending, ".ply");
  if (!isStl && !isPly && !EqualsIgnoringCase(ending, ".obj"))
  {
    throw Error(ErrorCode::InvalidParameter,
      path + ": the ending is none of .obj, .ply and .stl, which can be written");
  }
  if (isStl)
  {
    CheckForStl(surface);
  }
  OutputFile file(path);
  isStl ? WriteStl(file, surface) : isPly ? WritePly(file, surface) : WriteObj(file, surface);
  file.Close();
}
} // namespace insideout
