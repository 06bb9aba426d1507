// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/ByteOrder.h"
#include "Files/NameNumbers.h"
#include "Files/SurfaceReaders.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <string>
#include <string_view>

// The format: 3D Systems, StereoLithography Interface Specification (1988). Binary: 80 bytes of
// title, the number of facets, then 50 bytes each: the normal, three corners, 2 bytes of anything.

namespace insideout
{
namespace
{
constexpr std::uint64_t TitleLength = 80;
constexpr std::uint64_t HeadLength = 84;
constexpr std::uint64_t FacetLength = 50;
constexpr std::uint64_t NormalLength = 12;

/** The number of facets that the file announces, were it binary and long enough. */
std::uint64_t AnnouncedFacets(const FileContent& file)
{
  return LoadNumber<std::uint32_t>(file.Begin() + TitleLength, ByteOrder::Little);
}

bool HasBinaryLength(const FileContent& file)
{
  return file.Size >= HeadLength && file.Size == HeadLength + FacetLength * AnnouncedFacets(file);
}

bool BeginsWithSolid(const FileContent& file)
{
  const char* const begin = std::find_if_not(file.TextBegin(), file.End(),
    [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
  const std::string_view text(begin, static_cast<std::size_t>(file.End() - begin));
  return EqualsIgnoringCase(text.substr(0, 5), "solid");
}

/**
 * Binary files have been seen whose title begins with `solid` and that have bytes at their end. A
 * text has no byte 0; a binary file has one in its first facet's 2 spare bytes, or in its title.
 */
bool HasZeroByte(const FileContent& file)
{
  constexpr std::uint64_t looked = 1024;
  const char* const end = file.Begin() + std::min<std::uint64_t>(file.Size, looked);
  return std::find(file.Begin(), end, '\0') != end;
}

bool IsAsciiStl(const FileContent& file)
{
  return !HasBinaryLength(file) && BeginsWithSolid(file) && !HasZeroByte(file);
}

void AddPoint(const char* bytes, PolygonSurface& surface)
{
  Point point;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    point[axis] = double(LoadNumber<float>(bytes + axis * sizeof(float), ByteOrder::Little));
  }
  surface.Points.push_back(point);
}

/** Points 3 i to 3 i + 2 are the corners of facet i. */
void AddFacetsOfOwnPoints(PolygonSurface& surface)
{
  const auto points = static_cast<Id>(surface.Points.size());
  surface.Corners.reserve(surface.Points.size());
  surface.Offsets.reserve(surface.Points.size() / 3 + 1);
  for (Id p = 0; p < points; ++p)
  {
    surface.Corners.push_back(p);
    if (p % 3 == 2)
    {
      surface.Offsets.push_back(p + 1);
    }
  }
}

/** The number of facets, once it is known that all of them are there. */
std::uint64_t CheckedFacets(const FileContent& file)
{
  if (file.Size < HeadLength)
  {
    throw Malformed(file,
      "is neither ascii STL, which begins with 'solid', nor has the 84 bytes that binary STL "
      "begins with");
  }
  const std::uint64_t announced = AnnouncedFacets(file);
  const std::uint64_t present = (file.Size - HeadLength) / FacetLength;
  if (present < announced)
  {
    throw Malformed(file,
      std::to_string(announced) + " triangles announced, " + std::to_string(present) + " present");
  }
  CheckCount(file, 3 * announced, "points");
  return announced;
}

PolygonSurface ReadBinaryStl(const FileContent& file, Monitor& monitor)
{
  constexpr std::uint64_t facetsBetweenChecks = 1 << 15;
  PolygonSurface surface;
  const std::uint64_t facets = CheckedFacets(file);
  surface.Points.reserve(3 * facets);
  const char* at = file.Begin() + HeadLength;
  for (std::uint64_t facet = 0; facet < facets; ++facet, at += FacetLength)
  {
    for (std::uint64_t corner = 0; corner < 3; ++corner)
    {
      AddPoint(at + NormalLength * (corner + 1), surface);
    }
    if (facet % facetsBetweenChecks == 0)
    {
      file.ReportPosition(at, monitor);
    }
  }
  AddFacetsOfOwnPoints(surface);
  if (at != file.End())
  {
    surface.Warnings.push_back(file.Name + ": " + std::to_string(file.End() - at) +
      " bytes behind the last triangle were passed over");
  }
  return surface;
}

/** Reads `solid`s, one after the other, into one surface. */
class AsciiStlReader
{
public:
  AsciiStlReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.TextBegin(), 1, {}, monitor)
  {
  }

  PolygonSurface Read()
  {
    while (this->Scanner.SkipToContent())
    {
      this->Expect("solid");
      const std::string name = ToUtf8(this->Scanner.RestOfLine());
      this->Scanner.SkipLine();
      const std::size_t facets = this->GroupIds.size();
      this->ReadFacets();
      if (this->GroupIds.size() > facets)
      {
        this->Names.push_back(name);
      }
    }
    AddFacetsOfOwnPoints(this->Surface);
    if (this->Names.size() > 1)
    {
      this->Surface.PolygonAttributes.push_back({ "GroupIds", 1, std::move(this->GroupIds) });
      this->Surface.Names.push_back({ "GroupNames", std::move(this->Names) });
    }
    return std::move(this->Surface);
  }

private:
  std::string_view Next()
  {
    if (!this->Scanner.SkipToContent())
    {
      this->Scanner.Fail("the file ends within a solid: it is truncated");
    }
    return this->Scanner.Word();
  }

  void Expect(const char* keyword)
  {
    const std::string_view word = this->Next();
    if (!EqualsIgnoringCase(word, keyword))
    {
      this->Scanner.Fail(std::string("expected '") + keyword + "', found " + Quoted(word));
    }
  }

  void ReadFacets()
  {
    std::string_view word = this->Next();
    for (; EqualsIgnoringCase(word, "facet"); word = this->Next())
    {
      this->ReadFacet();
    }
    if (!EqualsIgnoringCase(word, "endsolid"))
    {
      this->Scanner.Fail("expected 'facet' or 'endsolid', found " + Quoted(word));
    }
    this->Scanner.SkipLine();
  }

  void ReadFacet()
  {
    this->SkipNormal();
    this->Expect("loop");
    for (int corner = 0; corner < 3; ++corner)
    {
      this->Expect("vertex");
      this->ReadPoint();
    }
    this->Expect("endloop");
    this->Expect("endfacet");
    CheckCount(this->File, this->Surface.Points.size(), "points");
    this->GroupIds.push_back(static_cast<std::int32_t>(this->Names.size()));
  }

  /** The corners tell the normal; in files it may be missing, or no number. Ends behind `outer`. */
  void SkipNormal()
  {
    std::string_view word = this->Next();
    for (int i = 0; i < 4 && !EqualsIgnoringCase(word, "outer"); ++i)
    {
      word = this->Next();
    }
    if (!EqualsIgnoringCase(word, "outer"))
    {
      this->Scanner.Fail("expected 'outer', found " + Quoted(word));
    }
  }

  void ReadPoint()
  {
    Point point;
    for (double& x : point)
    {
      this->Scanner.SkipToContent();
      x = this->Scanner.Number();
    }
    this->Surface.Points.push_back(point);
  }

  const FileContent& File;
  TextScanner Scanner;
  PolygonSurface Surface;
  std::vector<std::int32_t> GroupIds;
  std::vector<std::string> Names; ///< of the solids that have facets
};
} // namespace

bool IsStl(const FileContent& file)
{
  return HasBinaryLength(file) || BeginsWithSolid(file);
}

PolygonSurface ReadStl(const FileContent& file, Monitor& monitor)
{
  return IsAsciiStl(file) ? AsciiStlReader(file, monitor).Read() : ReadBinaryStl(file, monitor);
}
} // namespace insideout
