// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/PlyAttributes.h"
#include "Files/PlyBody.h"
#include "Files/TextScanner.h"

// The format: Turk, The PLY Polygon File Format (1994).

namespace insideout
{
namespace
{
/** Warn of statements, elements and lists that a PolygonSurface cannot hold. */
void WarnOfUnused(
  const FileContent& file, const PlyHeader& header, std::vector<std::string>& warnings)
{
  const auto warn = [&](const std::string& what) { warnings.push_back(file.Name + ": " + what); };
  if (header.UnknownStatements > 0)
  {
    warn(std::to_string(header.UnknownStatements) +
      " unknown statements were skipped in the header, the first on " + header.FirstUnknown);
  }
  for (const PlyElement& element : header.Elements)
  {
    if (element.Count == 0)
    {
      continue;
    }
    const PlyProperty* const pointIds = header.PointIdsOf(element);
    if (!element.IsKept() && !pointIds)
    {
      warn(std::to_string(element.Count) + " elements " + Quoted(element.Name) + " were skipped");
    }
    for (const PlyProperty& property : element.Properties)
    {
      if (element.IsKept() && property.IsList && &property != pointIds)
      {
        warn("the lists " + Quoted(property.Name) + " of " + element.Name + " were skipped");
      }
    }
  }
}
} // namespace

bool IsPly(const FileContent& file)
{
  const std::string_view text(
    file.TextBegin(), static_cast<std::size_t>(file.End() - file.TextBegin()));
  return text.substr(0, 3) == "ply" && text.find_first_of(" \t\r\n") == 3;
}

PolygonSurface ReadPly(const FileContent& file, Monitor& monitor)
{
  PolygonSurface surface;
  PlyHeader header = ReadPlyHeader(file, monitor);
  ReadPlyBody(file, header, surface, monitor);
  WarnOfUnused(file, header, surface.Warnings);
  PlyElement& vertices = *header.Find("vertex");
  surface.Points = TakePlyPoints(vertices);
  surface.PointAttributes = TakePlyAttributes(vertices);
  if (header.HasFaces()) // otherwise polygons come from strips
  {
    surface.PolygonAttributes = TakePlyAttributes(*header.Find("face"));
  }
  return surface;
}
} // namespace insideout
