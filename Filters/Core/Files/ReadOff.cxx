// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceReaders.h"
#include "Files/TextScanner.h"

#include <algorithm>

// The format: Geomview's manual, "OFF Files". Real files omit the number of edges, append the
// numbers to the first word, or give three color components instead of four.

namespace insideout
{
namespace
{
/** The first word: [ST][C][N][4][n]OFF. */
struct OffHeader
{
  bool Found = false;
  std::size_t Length = 0; ///< of the first word
  bool TextureCoordinates = false;
  bool Colors = false;
  bool Normals = false;
  bool OtherDimension = false; ///< points are not (x, y, z)
};

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/** Skip `prefix` if it comes next. */
bool AcceptPrefix(std::string_view word, std::size_t& at, std::string_view prefix)
{
  const bool accepted = word.substr(at, prefix.size()) == prefix;
  at += accepted ? prefix.size() : 0;
  return accepted;
}

OffHeader ParseHeader(std::string_view word)
{
  OffHeader header;
  std::size_t at = 0;
  header.TextureCoordinates = AcceptPrefix(word, at, "ST");
  header.Colors = AcceptPrefix(word, at, "C");
  header.Normals = AcceptPrefix(word, at, "N");
  const bool homogeneous = AcceptPrefix(word, at, "4");
  const bool anyDimension = AcceptPrefix(word, at, "n");
  header.OtherDimension = homogeneous || anyDimension;
  header.Length = at + 3;
  header.Found = EqualsIgnoringCase(word.substr(at, 3), "off") &&
    (header.Length == word.size() || IsDigit(word[header.Length]));
  return header;
}

class OffReader
{
public:
  OffReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.TextBegin(), 1, { true, false }, monitor)
  {
  }

  PolygonSurface Read()
  {
    this->ReadHeader();
    this->ReadCounts();
    for (std::uint64_t point = 0; point < this->PointCount; ++point)
    {
      this->ReadPoint(point);
    }
    for (std::uint64_t face = 0; face < this->FaceCount; ++face)
    {
      this->ReadFace(face);
    }
    this->AddAttributes();
    this->AddWarnings();
    return std::move(this->Surface);
  }

private:
  void ReadHeader()
  {
    TextScanner ahead = this->Scanner;
    ahead.SkipToContent();
    this->Header = ParseHeader(ahead.Word());
    this->Scanner.SkipToContent();
    if (!this->Header.Found)
    {
      return; // it may be omitted
    }
    if (this->Header.OtherDimension)
    {
      this->Scanner.Fail("only points of three coordinates can be read");
    }
    for (std::size_t i = 0; i < this->Header.Length; ++i)
    {
      this->Scanner.Accept(*this->Scanner.Position());
    }
    if (EqualsIgnoringCase(TextScanner(this->Scanner).Word(), "binary"))
    {
      this->Scanner.Fail("binary OFF is not supported");
    }
  }

  void ReadCounts()
  {
    this->PointCount = this->Count("points");
    this->FaceCount = this->Count("faces");
    if (!this->Scanner.AtLineEnd())
    {
      this->Scanner.Integer(); // number of edges, ignored
    }
    constexpr std::uint64_t shortestPoint = 6; // "0 0 0\n"; the last line needs no line end
    constexpr std::uint64_t shortestFace = 2;  // "0\n"
    const std::uint64_t left = this->Scanner.Left() + 1;
    this->CheckAnnounced(this->PointCount, left / shortestPoint, "points");
    this->CheckAnnounced(
      this->FaceCount, (left - shortestPoint * this->PointCount) / shortestFace, "faces");
    CheckCount(this->File, this->PointCount, "points");
    CheckCount(this->File, this->FaceCount, "faces");
    this->ElementPerLine = this->Header.Colors ||
      this->Scanner.HasLines(this->PointCount + this->FaceCount) || !this->NextLineHasTwoPoints();
    this->Surface.Points.reserve(this->PointCount);
    this->Surface.Offsets.reserve(this->FaceCount + 1);
  }

  bool NextLineHasTwoPoints() const
  {
    TextScanner ahead = this->Scanner;
    ahead.SkipToContent();
    int words = 0;
    for (; !ahead.AtLineEnd(); ahead.Word())
    {
      ++words;
    }
    return words >= 2 * 3;
  }

  std::uint64_t Count(const char* things)
  {
    if (!this->Scanner.SkipToContent())
    {
      this->Scanner.Fail(std::string("the number of ") + things + " is missing");
    }
    const std::int64_t count = this->Scanner.Integer();
    if (count < 0)
    {
      this->Scanner.Fail("the number of " + std::string(things) + " is negative");
    }
    return static_cast<std::uint64_t>(count);
  }

  void CheckAnnounced(std::uint64_t count, std::uint64_t possible, const char* things) const
  {
    if (count > possible)
    {
      throw Malformed(this->File,
        std::to_string(count) + " " + things + " announced, at most " + std::to_string(possible) +
          " present: the file is truncated");
    }
  }

  void ReadPoint(std::uint64_t point)
  {
    Point position;
    for (double& x : position)
    {
      x = this->Number("point", point, this->PointCount);
    }
    this->Surface.Points.push_back(position);
    for (int axis = 0; this->Header.Normals && axis < 3; ++axis)
    {
      this->Normals.push_back(this->Number("point", point, this->PointCount));
    }
    if (this->ElementPerLine)
    {
      this->ReadExtrasOfPoint(point);
    }
    else
    {
      this->ReadTextureCoordinates(point);
    }
  }

  /** The color, whose length follows only from the line's, and the texture coordinates. */
  void ReadExtrasOfPoint(std::uint64_t point)
  {
    const std::vector<double>& extras = this->RestOfLine();
    std::size_t colors = extras.size();
    if (this->Header.TextureCoordinates)
    {
      if (colors < 2)
      {
        this->Scanner.Fail("point " + std::to_string(point) + " has no texture coordinates");
      }
      colors -= 2;
      this->TCoords.insert(this->TCoords.end(), extras.end() - 2, extras.end());
    }
    this->PointColors.Add({ extras.begin(), extras.begin() + static_cast<std::ptrdiff_t>(colors) });
  }

  void ReadTextureCoordinates(std::uint64_t point)
  {
    for (int axis = 0; this->Header.TextureCoordinates && axis < 2; ++axis)
    {
      this->TCoords.push_back(this->Number("point", point, this->PointCount));
    }
  }

  void ReadFace(std::uint64_t face)
  {
    this->SkipTo("face", face, this->FaceCount);
    const std::int64_t corners = this->Scanner.Integer();
    if (corners < 0 || static_cast<std::uint64_t>(corners) > this->Scanner.Left() / 2 + 1)
    {
      this->Scanner.Fail("face " + std::to_string(face) + " announces " + std::to_string(corners) +
        " corners, which are not there");
    }
    for (std::int64_t corner = 0; corner < corners; ++corner)
    {
      this->SkipTo("face", face, this->FaceCount);
      this->Surface.Corners.push_back(this->PointId());
    }
    const bool kept = ClosePolygon(this->File, this->Surface);
    this->Dropped += kept ? 0 : 1;
    if (this->ElementPerLine)
    {
      const std::vector<double>& color = this->RestOfLine();
      if (kept)
      {
        this->FaceColors.Add(color);
      }
    }
  }

  Id PointId()
  {
    const std::int64_t id = this->Scanner.Integer();
    if (id < 0 || static_cast<std::uint64_t>(id) >= this->PointCount)
    {
      this->Scanner.Fail(
        "face refers to point " + std::to_string(id) + " of " + std::to_string(this->PointCount));
    }
    return static_cast<Id>(id);
  }

  double Number(const char* thing, std::uint64_t index, std::uint64_t count)
  {
    this->SkipTo(thing, index, count);
    return this->Scanner.Number();
  }

  void SkipTo(const char* thing, std::uint64_t index, std::uint64_t count)
  {
    if (!this->Scanner.SkipToContent())
    {
      throw Malformed(this->File,
        std::string(thing) + " " + std::to_string(index) + " of " + std::to_string(count) +
          " is missing: the file is truncated");
    }
  }

  const std::vector<double>& RestOfLine()
  {
    this->Rest.clear();
    while (!this->Scanner.AtLineEnd())
    {
      this->Rest.push_back(this->Scanner.Number());
    }
    return this->Rest;
  }

  void AddAttributes()
  {
    PolygonSurface& surface = this->Surface;
    if (this->Header.Normals)
    {
      surface.PointAttributes.push_back({ "Normals", 3, std::move(this->Normals) });
    }
    if (this->Header.TextureCoordinates)
    {
      surface.PointAttributes.push_back({ "TCoords", 2, std::move(this->TCoords) });
    }
    this->AddColors(this->PointColors, "points", surface.PointAttributes);
    this->AddColors(this->FaceColors, "faces", surface.PolygonAttributes);
  }

  void AddColors(const ColorColumn& colors, const char* things, std::vector<Attribute>& attributes)
  {
    if (std::optional<Attribute> attribute = colors.ToAttribute())
    {
      attributes.push_back(std::move(*attribute));
    }
    else if (colors.Any())
    {
      this->Surface.Warnings.push_back(this->File.Name + ": the numbers after some " + things +
        " were skipped, because they are not one color each");
    }
  }

  void AddWarnings()
  {
    WarnOfDropped(this->File, this->Dropped, this->Surface);
    if (this->Scanner.SkipToContent())
    {
      this->Surface.Warnings.push_back(this->File.Name + ", line " +
        std::to_string(this->Scanner.GetLine()) + ": content after the last face was skipped");
    }
  }

  const FileContent& File;
  TextScanner Scanner;
  OffHeader Header;
  std::uint64_t PointCount = 0;
  std::uint64_t FaceCount = 0;
  // The manual lets points continue over line ends, but files with unknown extra numbers after them
  // are more frequent. So each line is one element's, unless there are too few lines.
  bool ElementPerLine = true;
  PolygonSurface Surface;
  std::vector<double> Normals;
  std::vector<double> TCoords;
  ColorColumn PointColors;
  ColorColumn FaceColors;
  std::vector<double> Rest;
  std::uint64_t Dropped = 0;
};
} // namespace

bool IsOff(const FileContent& file, Monitor& monitor)
{
  TextScanner scanner(file, file.TextBegin(), 1, { true, false }, monitor);
  return scanner.SkipToContent() && ParseHeader(scanner.Word()).Found;
}

PolygonSurface ReadOff(const FileContent& file, Monitor& monitor)
{
  return OffReader(file, monitor).Read();
}
} // namespace insideout
