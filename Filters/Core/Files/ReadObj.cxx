// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/NameNumbers.h"
#include "Files/SurfaceReaders.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <unordered_map>

// The format: Wavefront, Advanced Visualizer Manual, appendix B1 (object files).

namespace insideout
{
namespace
{
constexpr double NoColor = std::numeric_limits<double>::quiet_NaN();

/** A reference, counted from 0, to something not defined yet. */
struct ForwardReference
{
  std::int64_t Index;
  std::int64_t Line;
};

/** Texture coordinates or normals, N numbers each, and each corner's index in them. */
template <std::size_t N>
struct CornerData
{
  const char* Name;
  std::vector<std::array<double, N>> Values;
  std::vector<Id> OfCorner; ///< parallel to the surface's corners, None for none
  std::vector<ForwardReference> Forward;
  std::int64_t BadLine = 0; ///< the first line with an invalid reference, 0 for none
  bool Usable = false;      ///< whether every corner has one

  /** Set the next corner's index to `given` as in the file, on line `line`. */
  void Refer(std::int64_t given, std::int64_t line)
  {
    const auto count = static_cast<std::int64_t>(this->Values.size());
    const std::int64_t index = given > 0 ? given - 1 : count + given;
    if (given == 0 || index < 0 || index >= std::numeric_limits<Id>::max())
    {
      this->MarkBad(line);
    }
    else if (index >= count)
    {
      this->Forward.push_back({ index, line });
    }
    this->OfCorner.push_back(static_cast<Id>(index));
  }

  void MarkBad(std::int64_t line)
  {
    this->BadLine = this->BadLine == 0 ? line : std::min(this->BadLine, line);
  }

  /** Decide whether they can be used; if they exist but cannot, warn with the reason. */
  void Judge(const FileContent& file, std::vector<std::string>& warnings)
  {
    for (const ForwardReference& reference : this->Forward)
    {
      if (reference.Index >= static_cast<std::int64_t>(this->Values.size()))
      {
        this->MarkBad(reference.Line);
      }
    }
    const auto missing = std::count(this->OfCorner.begin(), this->OfCorner.end(), None);
    const bool none = missing == static_cast<std::ptrdiff_t>(this->OfCorner.size());
    this->Usable = this->BadLine == 0 && missing == 0 && !none;
    if (this->BadLine != 0)
    {
      warnings.push_back(file.Name + ", line " + std::to_string(this->BadLine) +
        ": face refers to " + this->Name + " that do not exist: all were skipped");
    }
    else if (missing > 0 && !none)
    {
      warnings.push_back(file.Name + ": " + this->Name + " were skipped, because " +
        std::to_string(missing) + " corners have none");
    }
  }

  Id At(std::size_t corner) const { return this->Usable ? this->OfCorner[corner] : None; }
};

/** The texture coordinates and the normal of a point. */
struct Combination
{
  Id TCoord = None;
  Id Normal = None;

  bool operator==(const Combination& other) const
  {
    return this->TCoord == other.TCoord && this->Normal == other.Normal;
  }
};

struct PointWithData
{
  Id PointId;
  Combination Data;

  bool operator==(const PointWithData& other) const
  {
    return this->PointId == other.PointId && this->Data == other.Data;
  }
};

struct HashOfPointWithData
{
  std::size_t operator()(const PointWithData& key) const
  {
    std::uint64_t hash = 0;
    for (const Id id : { key.PointId, key.Data.TCoord, key.Data.Normal })
    {
      hash = (hash ^ static_cast<std::uint32_t>(id)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
  }
};

/** Counts the skipped lines of one kind. */
struct PassedOver
{
  std::uint64_t Count = 0;
  std::string First; ///< line and word of the first
};

/** A statement `l`, used only in a file without faces. */
struct LineStatement
{
  std::int64_t Line;
  std::string Corners;
  std::int32_t Group;
  std::int32_t Material;
};

class ObjReader
{
public:
  ObjReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.TextBegin(), 1, { true, true }, monitor)
  {
  }

  PolygonSurface Read()
  {
    while (this->Scanner.SkipToContent())
    {
      this->Line = this->Scanner.GetLine();
      this->ReadStatement(this->Scanner.Word());
      this->Scanner.SkipLine();
    }
    this->ReadLines();
    this->CheckForwardPoints();
    this->TCoords.Judge(this->File, this->Surface.Warnings);
    this->Normals.Judge(this->File, this->Surface.Warnings);
    this->SplitPoints();
    this->AddAttributes();
    this->AddWarnings();
    return std::move(this->Surface);
  }

private:
  void ReadStatement(std::string_view word)
  {
    if (word == "v")
    {
      this->ReadPoint();
    }
    else if (word == "vt")
    {
      this->ReadTCoord();
    }
    else if (word == "vn")
    {
      this->Normals.Values.push_back(this->ReadVector());
      CheckCount(this->File, this->Normals.Values.size(), "normals");
    }
    else if (word == "f" || word == "fo")
    {
      this->ReadFace();
    }
    else if (!this->ReadGrouping(word))
    {
      this->PassOver(word);
    }
  }

  bool ReadGrouping(std::string_view word)
  {
    if (word == "usemtl")
    {
      this->Materials.Choose(ToUtf8(this->Scanner.RestOfLine()));
    }
    else if (word == "g" || word == "o")
    {
      (word == "g" ? this->Group : this->Object) = ToUtf8(this->Scanner.RestOfLine());
      this->Groups.Choose(this->Object + '\n' + this->Group);
    }
    else
    {
      return false;
    }
    return true;
  }

  void PassOver(std::string_view word)
  {
    constexpr std::array<std::string_view, 10> ofNoInterest = { "s", "mg", "mtllib", "maplib",
      "usemap", "lod", "bevel", "c_interp", "d_interp", "vp" };
    if (std::find(ofNoInterest.begin(), ofNoInterest.end(), word) != ofNoInterest.end())
    {
      return;
    }
    if (word == "l" && this->Surface.Corners.empty())
    {
      this->Lines.push_back({ this->Line, this->Scanner.RestOfLine(), this->Groups.Current(),
        this->Materials.Current() });
      return;
    }
    PassedOver& passed = word == "l" || word == "p" ? this->LinesAndPoints : this->Unknown;
    if (passed.Count++ == 0)
    {
      passed.First = "line " + std::to_string(this->Line) + ": " + Quoted(word);
    }
  }

  /** Without faces, read the lines: `1 2 3` or `1/1 2/2`. */
  void ReadLines()
  {
    if (!this->Surface.Corners.empty() && !this->Lines.empty())
    {
      this->LinesAndPoints.Count += this->Lines.size();
      this->LinesAndPoints.First =
        "line " + std::to_string(this->Lines.front().Line) + ": " + Quoted("l");
      this->Lines.clear();
    }
    for (const LineStatement& line : this->Lines)
    {
      this->ReadLine(line);
    }
  }

  void ReadLine(const LineStatement& line)
  {
    std::istringstream words(line.Corners);
    words.imbue(std::locale::classic());
    std::size_t count = 0;
    for (std::string word; words >> word; ++count)
    {
      const std::string number = word.substr(0, word.find('/'));
      std::int64_t given = 0;
      const auto [end, error] =
        std::from_chars(number.data(), number.data() + number.size(), given);
      const auto points = static_cast<std::int64_t>(this->Surface.Points.size());
      const std::int64_t index = given > 0 ? given - 1 : points + given;
      if (error != std::errc() || end != number.data() + number.size() || given == 0 || index < 0 ||
        index >= points)
      {
        throw Error(ErrorCode::FileMalformed,
          this->File.Name + ", line " + std::to_string(line.Line) + ": line refers to point " +
            Quoted(word) + " of " + std::to_string(points));
      }
      this->Surface.LineCorners.push_back(static_cast<Id>(index));
    }
    if (count > 0)
    {
      this->Surface.LineOffsets.push_back(static_cast<Id>(this->Surface.LineCorners.size()));
      this->GroupIds.push_back(line.Group);
      this->MaterialIds.push_back(line.Material);
    }
  }

  Point ReadVector()
  {
    Point vector;
    for (double& x : vector)
    {
      x = this->Scanner.Number();
    }
    return vector;
  }

  /** `v x y z`, then nothing, a weight, a color, or a weight followed by a color. */
  void ReadPoint()
  {
    this->Surface.Points.push_back(this->ReadVector());
    CheckCount(this->File, this->Surface.Points.size(), "points");
    Point color = { NoColor, NoColor, NoColor };
    std::size_t extras = 0;
    for (; !this->Scanner.AtLineEnd(); ++extras)
    {
      const double number = this->Scanner.Number();
      if (extras < 3)
      {
        color[extras] = number;
      }
    }
    if (extras >= 3 && this->Colors.empty())
    {
      this->Colors.resize(this->Surface.Points.size() - 1, { NoColor, NoColor, NoColor });
      this->HasColors = true;
    }
    if (this->HasColors)
    {
      this->Colors.push_back(extras >= 3 ? color : Point{ NoColor, NoColor, NoColor });
    }
  }

  /** `vt u`, `vt u v` or `vt u v w`. */
  void ReadTCoord()
  {
    std::array<double, 2> coordinates = { this->Scanner.Number(), 0.0 };
    if (!this->Scanner.AtLineEnd())
    {
      coordinates[1] = this->Scanner.Number();
    }
    this->TCoords.Values.push_back(coordinates);
    CheckCount(this->File, this->TCoords.Values.size(), "texture coordinates");
  }

  void ReadFace()
  {
    while (!this->Scanner.AtLineEnd())
    {
      this->ReadCorner();
    }
    if (ClosePolygon(this->File, this->Surface))
    {
      this->GroupIds.push_back(this->Groups.Current());
      this->MaterialIds.push_back(this->Materials.Current());
      return;
    }
    ++this->Dropped;
    this->TCoords.OfCorner.resize(this->Surface.Corners.size());
    this->Normals.OfCorner.resize(this->Surface.Corners.size());
  }

  /** `1`, `1/2`, `1//3` or `1/2/3`. */
  void ReadCorner()
  {
    this->Surface.Corners.push_back(this->PointId(this->Scanner.LeadingInteger()));
    this->ReadReference(this->TCoords);
    this->ReadReference(this->Normals);
    this->Scanner.ExpectWordEnd();
  }

  template <std::size_t N>
  void ReadReference(CornerData<N>& data)
  {
    if (this->Scanner.Accept('/') && !this->Scanner.AtWordEnd() && *this->Scanner.Position() != '/')
    {
      data.Refer(this->Scanner.LeadingInteger(), this->Line);
    }
    else
    {
      data.OfCorner.push_back(None);
    }
  }

  Id PointId(std::int64_t given)
  {
    const auto count = static_cast<std::int64_t>(this->Surface.Points.size());
    const std::int64_t index = given > 0 ? given - 1 : count + given;
    if (given == 0)
    {
      this->Scanner.Fail("face refers to point 0, but OBJ counts from 1");
    }
    if (index < 0 || index >= std::numeric_limits<Id>::max())
    {
      this->Scanner.Fail(this->NoSuchPoint(given));
    }
    if (index >= count)
    {
      this->ForwardPoints.push_back({ index, this->Line });
    }
    return static_cast<Id>(index);
  }

  std::string NoSuchPoint(std::int64_t given) const
  {
    return "face refers to point " + std::to_string(given) + " of " +
      std::to_string(this->Surface.Points.size());
  }

  void CheckForwardPoints() const
  {
    for (const ForwardReference& reference : this->ForwardPoints)
    {
      if (reference.Index >= static_cast<std::int64_t>(this->Surface.Points.size()))
      {
        throw Error(ErrorCode::FileMalformed,
          this->File.Name + ", line " + std::to_string(reference.Line) + ": " +
            this->NoSuchPoint(reference.Index + 1));
      }
    }
  }

  /** Give every point one combination: points whose corners have several are copied. */
  void SplitPoints()
  {
    if (!this->TCoords.Usable && !this->Normals.Usable)
    {
      return;
    }
    this->OfPoint.resize(this->Surface.Points.size());
    std::unordered_map<PointWithData, Id, HashOfPointWithData> copies;
    for (std::size_t c = 0; c < this->Surface.Corners.size(); ++c)
    {
      Id& point = this->Surface.Corners[c];
      const Combination data = { this->TCoords.At(c), this->Normals.At(c) };
      Combination& first = this->OfPoint[static_cast<std::size_t>(point)];
      if (first == Combination())
      {
        first = data;
      }
      if (!(first == data))
      {
        const auto next = static_cast<Id>(this->Surface.Points.size());
        const auto found = copies.insert({ { point, data }, next });
        if (found.second)
        {
          this->CopyPoint(static_cast<std::size_t>(point), data);
        }
        point = found.first->second;
      }
    }
  }

  void CopyPoint(std::size_t point, Combination data)
  {
    this->Surface.Points.push_back(Point(this->Surface.Points[point]));
    CheckCount(this->File, this->Surface.Points.size(), "points");
    this->OfPoint.push_back(data);
    if (this->HasColors)
    {
      this->Colors.push_back(Point(this->Colors[point]));
    }
  }

  void AddAttributes()
  {
    this->AddCornerData(this->Normals, "Normals", &Combination::Normal);
    this->AddCornerData(this->TCoords, "TCoords", &Combination::TCoord);
    this->AddColors();
    std::vector<Attribute>& attributes = this->Surface.PolygonAttributes;
    if (this->Groups.Any())
    {
      attributes.push_back({ "GroupIds", 1, std::move(this->GroupIds) });
      this->Surface.Names.push_back({ "GroupNames", NamesOfGroups(this->Groups.Used()) });
    }
    if (this->Materials.Any())
    {
      attributes.push_back({ "MaterialIds", 1, std::move(this->MaterialIds) });
      this->Surface.Names.push_back({ "MaterialNames", NamesOrDefault(this->Materials.Used()) });
    }
  }

  template <std::size_t N>
  void AddCornerData(const CornerData<N>& data, const char* name, Id Combination::*which)
  {
    if (!data.Usable)
    {
      return;
    }
    std::vector<double> values;
    values.reserve(N * this->OfPoint.size());
    for (const Combination& combination : this->OfPoint)
    {
      const Id id = combination.*which;
      const std::array<double, N> value =
        id == None ? std::array<double, N>{} : data.Values[static_cast<std::size_t>(id)];
      values.insert(values.end(), value.begin(), value.end());
    }
    this->Surface.PointAttributes.push_back({ name, static_cast<int>(N), std::move(values) });
  }

  /** Points unused by faces need no color: they get black. */
  void AddColors()
  {
    if (!this->HasColors)
    {
      return;
    }
    std::vector<bool> used(this->Surface.Points.size(), false);
    for (const std::vector<Id>* corners : { &this->Surface.Corners, &this->Surface.LineCorners })
    {
      for (const Id corner : *corners)
      {
        used[static_cast<std::size_t>(corner)] = true;
      }
    }
    std::vector<double> numbers;
    numbers.reserve(3 * used.size());
    for (std::size_t p = 0; p < used.size(); ++p)
    {
      const Point& color = this->Colors[p];
      const bool black = !used[p] && std::isnan(color[0]);
      numbers.insert(
        numbers.end(), { black ? 0.0 : color[0], black ? 0.0 : color[1], black ? 0.0 : color[2] });
    }
    if (std::optional<std::vector<unsigned char>> bytes = ToColorBytes(numbers))
    {
      this->Surface.PointAttributes.push_back({ "Colors", 3, std::move(*bytes) });
      return;
    }
    this->Surface.Warnings.push_back(
      this->File.Name + ": the colors were skipped, because some points have none from 0 to 255");
  }

  void AddWarnings()
  {
    const bool nothing = this->Surface.Points.empty() && this->Surface.Corners.empty();
    if (nothing && this->Unknown.Count > 0)
    {
      throw Malformed(this->File, "holds no point or face of OBJ; " + this->Unknown.First);
    }
    WarnOfDropped(this->File, this->Dropped, this->Surface);
    this->Warn(this->LinesAndPoints, "lines and points");
    this->Warn(this->Unknown, "unknown statements");
  }

  void Warn(const PassedOver& passed, const char* things)
  {
    if (passed.Count > 0)
    {
      this->Surface.Warnings.push_back(this->File.Name + ": " + std::to_string(passed.Count) + " " +
        things + " were skipped, the first on " + passed.First);
    }
  }

  const FileContent& File;
  TextScanner Scanner;
  std::int64_t Line = 1; ///< line on which the statement begins
  PolygonSurface Surface;
  std::vector<ForwardReference> ForwardPoints;
  CornerData<2> TCoords{ "texture coordinates", {}, {}, {} };
  CornerData<3> Normals{ "normals", {}, {}, {} };
  std::vector<Combination> OfPoint;
  bool HasColors = false;
  /// parallel to the points if HasColors, NoColor for points without one
  std::vector<Point> Colors;
  std::string Object;
  std::string Group;
  NameNumbers Groups;
  NameNumbers Materials;
  std::vector<std::int32_t> GroupIds;
  std::vector<std::int32_t> MaterialIds;
  std::uint64_t Dropped = 0;
  std::vector<LineStatement> Lines; ///< before the first face
  PassedOver LinesAndPoints;
  PassedOver Unknown;
};

bool HasThreeNumbers(TextScanner& line)
{
  try
  {
    line.Number();
    line.Number();
    line.Number();
    return true;
  }
  catch (const Error& error)
  {
    if (error.Code != ErrorCode::FileMalformed)
    {
      throw;
    }
    return false;
  }
}
} // namespace

bool IsObj(const FileContent& file, Monitor& monitor)
{
  constexpr std::string_view before[] = { "mtllib", "usemtl", "o", "g", "s", "vn", "vt", "vp" };
  TextScanner scanner(file, file.TextBegin(), 1, { true, true }, monitor);
  while (scanner.SkipToContent())
  {
    const std::string_view word = scanner.Word();
    if (std::find(std::begin(before), std::end(before), word) == std::end(before))
    {
      return word == "v" && HasThreeNumbers(scanner);
    }
    scanner.SkipLine();
  }
  return false;
}

PolygonSurface ReadObj(const FileContent& file, Monitor& monitor)
{
  return ObjReader(file, monitor).Read();
}
} // namespace insideout
