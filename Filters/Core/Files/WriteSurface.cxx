// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceWriters.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <new>

namespace insideout
{
namespace
{
bool HasFractions(const Attribute& attribute)
{
  return std::holds_alternative<std::vector<double>>(attribute.Values) ||
    std::holds_alternative<std::vector<float>>(attribute.Values);
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

/** Writers rely on these checks. */
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
} // namespace

std::size_t LengthOf(const Attribute& attribute)
{
  return std::visit([](const auto& values) { return values.size(); }, attribute.Values);
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

bool HasFloats(const std::string& path)
{
  return EqualsIgnoringCase(std::filesystem::path(path).extension().string(), ".stl");
}

void WriteSurface(const std::string& path, const PolygonSurface& surface, Monitor& monitor)
{
  using Writer = void (*)(OutputFile&, const PolygonSurface&);
  struct Format
  {
    const char* Ending;
    Writer Write;
  };
  constexpr Format formats[] = { { ".obj", WriteObj }, { ".off", WriteOff }, { ".ply", WritePly },
    { ".stl", WriteStl } };

  CheckSurface(surface);
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto* const format = std::find_if(std::begin(formats), std::end(formats),
    [&ending](const Format& known) { return EqualsIgnoringCase(ending, known.Ending); });
  if (format == std::end(formats))
  {
    std::string endings;
    for (const Format& known : formats)
    {
      endings += std::string(" ") + known.Ending;
    }
    throw Error(ErrorCode::InvalidParameter,
      path + ": the ending is none of those that can be written:" + endings);
  }
  if (format->Write == WriteStl)
  {
    CheckForStl(surface);
  }
  try
  {
    OutputFile file(path, monitor);
    format->Write(file, surface);
    file.Close();
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::TooLarge, path + ": not enough memory to write it");
  }
}
} // namespace insideout
