// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/ByteOrder.h"
#include "Files/StlColors.h"
#include "Files/StlText.h"
#include "Files/SurfaceReaders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

// The format: 3D Systems, StereoLithography Interface Specification (1988). Binary: 80 bytes of
// title, the number of facets, then 50 bytes each: the normal, three corners, 2 arbitrary bytes.

namespace insideout
{
namespace
{
constexpr std::uint64_t TitleLength = 80;
constexpr std::uint64_t HeadLength = 84;
constexpr std::uint64_t FacetLength = 50;
constexpr std::uint64_t NormalLength = 12;
constexpr std::uint64_t NumbersLength = 48;

/** The number of facets declared, assuming the file is binary and long enough. */
std::uint64_t AnnouncedFacets(const FileContent& file)
{
  return LoadNumber<std::uint32_t>(file.Begin() + TitleLength, ByteOrder::Little);
}

bool HasBinaryLength(const FileContent& file)
{
  return file.Size >= HeadLength && file.Size == HeadLength + FacetLength * AnnouncedFacets(file);
}

/**
 * There are binary files whose title begins with `solid` and that have extra bytes at their end.
 */
bool IsText(const FileContent& file)
{
  return !HasBinaryLength(file) && LooksLikeText(file);
}

std::array<Point, 3> CornersAt(const char* facet)
{
  std::array<Point, 3> corners;
  const char* at = facet + NormalLength;
  for (Point& point : corners)
  {
    for (double& x : point)
    {
      x = double(LoadNumber<float>(at, ByteOrder::Little));
      at += sizeof(float);
    }
  }
  return corners;
}

/** Whether bytes beyond the declared count can be facets: numbers, and not all of them 0. */
bool CanBeFacets(const char* begin, std::uint64_t count)
{
  bool any = false;
  for (std::uint64_t facet = 0; facet < count; ++facet)
  {
    for (const Point& point : CornersAt(begin + facet * FacetLength))
    {
      for (const double x : point)
      {
        if (!std::isfinite(x))
        {
          return false;
        }
        any = any || x != 0.0;
      }
    }
  }
  return any;
}

/** The number of facets to read, after checking that all are complete. */
std::uint64_t CheckedFacets(const FileContent& file, std::vector<std::string>& warnings)
{
  if (file.Size < HeadLength)
  {
    throw Malformed(file,
      "is neither ascii STL, which begins with 'solid', nor has the 84 bytes that binary STL "
      "begins with");
  }
  std::uint64_t facets = AnnouncedFacets(file);
  const std::uint64_t present = (file.Size - HeadLength) / FacetLength;
  if (present < facets)
  {
    throw Malformed(file,
      std::to_string(facets) + " triangles announced, " + std::to_string(present) + " present");
  }
  const bool isWhole = (file.Size - HeadLength) % FacetLength == 0;
  if (present > facets && (isWhole || facets == 0) &&
    CanBeFacets(file.Begin() + HeadLength + facets * FacetLength, present - facets))
  {
    warnings.push_back(file.Name + ": " + std::to_string(facets) + " triangles announced, " +
      std::to_string(present) + " present, and all were read");
    facets = present;
  }
  CheckCount(file, 3 * facets, "points");
  return facets;
}

PolygonSurface ReadBinaryStl(const FileContent& file, Monitor& monitor)
{
  constexpr std::uint64_t facetsBetweenChecks = 1 << 15;
  PolygonSurface surface;
  const std::uint64_t facets = CheckedFacets(file, surface.Warnings);
  surface.Points.reserve(3 * facets);
  surface.Corners.reserve(3 * facets);
  surface.Offsets.reserve(facets + 1);
  StlColors colors({ file.Begin(), TitleLength });
  const char* at = file.Begin() + HeadLength;
  for (std::uint64_t facet = 0; facet < facets; ++facet, at += FacetLength)
  {
    for (const Point& corner : CornersAt(at))
    {
      surface.Corners.push_back(static_cast<Id>(surface.Points.size()));
      surface.Points.push_back(corner);
    }
    ClosePolygon(file, surface);
    colors.Add(LoadNumber<std::uint16_t>(at + NumbersLength, ByteOrder::Little));
    if (facet % facetsBetweenChecks == 0)
    {
      file.ReportPosition(at, monitor);
    }
  }
  colors.MoveTo(surface, file);
  if (at != file.End())
  {
    surface.Warnings.push_back(file.Name + ": " + std::to_string(file.End() - at) +
      " bytes after the last triangle were skipped");
  }
  return surface;
}
} // namespace

bool IsStl(const FileContent& file, Monitor& monitor)
{
  return HasBinaryLength(file) || BeginsAsStlText(file, monitor);
}

PolygonSurface ReadStl(const FileContent& file, Monitor& monitor)
{
  return IsText(file) ? ReadStlText(file, monitor) : ReadBinaryStl(file, monitor);
}
} // namespace insideout
