// SPDX-License-Identifier: GPL-3.0-or-later
#include "ByteOrder.h"
#include "SurfaceReaders.h"
#include "TextScanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

// The format: Turk, The PLY Polygon File Format (1994), with the type names that came later.

namespace insideout
{
namespace
{
enum class PlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float32,
  Float64
};

/** The names, length in bytes and range of a type, in the order of PlyType. */
struct PlyTypeFacts
{
  const char* Name;
  const char* OtherName;
  std::uint64_t Length;
  double Lowest;
  double Highest;
};

constexpr double Infinite = std::numeric_limits<double>::infinity();

constexpr std::array<PlyTypeFacts, 8> TypeFacts = { { { "char", "int8", 1, -128.0, 127.0 },
  { "uchar", "uint8", 1, 0.0, 255.0 }, { "short", "int16", 2, -32768.0, 32767.0 },
  { "ushort", "uint16", 2, 0.0, 65535.0 }, { "int", "int32", 4, -2147483648.0, 2147483647.0 },
  { "uint", "uint32", 4, 0.0, 4294967295.0 }, { "float", "float32", 4, -Infinite, Infinite },
  { "double", "float64", 8, -Infinite, Infinite } } };

const PlyTypeFacts& FactsOf(PlyType type)
{
  return TypeFacts[static_cast<std::size_t>(type)];
}

bool IsInteger(PlyType type)
{
  return type < PlyType::Float32;
}

struct PlyProperty
{
  std::string Name;
  PlyType Type = PlyType::Float64; ///< of the value, or of each in the list
  bool IsList = false;
  PlyType CountType = PlyType::UInt8; ///< of the number of values in a list
  std::vector<double> Values;         ///< one per element; none of lists. Doubles hold every type.
};

struct PlyElement
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<PlyProperty> Properties;

  const PlyProperty* Find(std::string_view name) const
  {
    const auto found = std::find_if(this->Properties.begin(), this->Properties.end(),
      [name](const PlyProperty& property) { return property.Name == name; });
    return found == this->Properties.end() ? nullptr : &*found;
  }
};

enum class PlyFormat
{
  Unknown,
  Ascii,
  LittleEndian,
  BigEndian
};

struct PlyHeader
{
  PlyFormat Format = PlyFormat::Unknown;
  std::vector<PlyElement> Elements;
  const char* Body = nullptr; ///< the first byte behind the header
  std::int64_t BodyLine = 0;
  std::int64_t UnknownStatements = 0;
  std::string FirstUnknown;

  /** The list of corners if the element is the faces and has one, else null. */
  static const PlyProperty* CornersOf(const PlyElement& element)
  {
    return element.Name == "face" ? PointsOf(element) : nullptr;
  }

  /** The list of points if the element is strips of triangles and there are no faces, else null. */
  const PlyProperty* StripsOf(const PlyElement& element)
  {
    const PlyElement* const faces = this->Find("face");
    const bool hasFaces = faces && faces->Count > 0;
    return element.Name == "tristrips" && !hasFaces ? PointsOf(element) : nullptr;
  }

  PlyElement* Find(std::string_view name)
  {
    const auto found = std::find_if(this->Elements.begin(), this->Elements.end(),
      [name](const PlyElement& element) { return element.Name == name; });
    return found == this->Elements.end() ? nullptr : &*found;
  }

private:
  static const PlyProperty* PointsOf(const PlyElement& element)
  {
    const PlyProperty* points = element.Find("vertex_indices");
    points = points ? points : element.Find("vertex_index");
    return points && points->IsList ? points : nullptr;
  }
};

class PlyHeaderReader
{
public:
  PlyHeaderReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.Begin(), 1, {}, monitor)
  {
  }

  PlyHeader Read()
  {
    if (!IsPly(this->File))
    {
      this->Scanner.Fail("does not begin with 'ply'");
    }
    do
    {
      this->Scanner.SkipLine();
      if (!this->Scanner.SkipToContent())
      {
        this->Scanner.Fail("the header has no end_header");
      }
    } while (this->ReadStatement(this->Scanner.Word()));
    this->CheckElements();
    this->FindBody();
    return std::move(this->Header);
  }

private:
  /** False behind end_header. */
  bool ReadStatement(std::string_view word)
  {
    if (word == "format")
    {
      this->ReadFormat();
    }
    else if (word == "element")
    {
      this->ReadElement();
    }
    else if (word == "property")
    {
      this->ReadProperty();
    }
    else if (word != "comment" && word != "obj_info" && word != "end_header")
    {
      this->PassOver(word);
    }
    return word != "end_header";
  }

  /** Some programs sign their files without the word comment. */
  void PassOver(std::string_view word)
  {
    if (this->Header.UnknownStatements++ == 0)
    {
      this->Header.FirstUnknown =
        "line " + std::to_string(this->Scanner.GetLine()) + ": " + Quoted(word);
    }
  }

  void ReadFormat()
  {
    const std::string_view word = this->Scanner.Word();
    this->Header.Format = word == "ascii" ? PlyFormat::Ascii
      : word == "binary_little_endian"    ? PlyFormat::LittleEndian
      : word == "binary_big_endian"       ? PlyFormat::BigEndian
                                          : PlyFormat::Unknown;
    if (this->Header.Format == PlyFormat::Unknown)
    {
      this->Scanner.Fail("unknown format " + Quoted(word));
    }
  }

  void ReadElement()
  {
    PlyElement element;
    element.Name = this->Scanner.Word();
    if (element.Name.empty() || this->Header.Find(element.Name))
    {
      this->Scanner.Fail("element " + Quoted(element.Name) + " has no name, or another's");
    }
    const std::int64_t count = this->Scanner.Integer();
    if (count < 0)
    {
      this->Scanner.Fail("the number of elements is negative");
    }
    element.Count = static_cast<std::uint64_t>(count);
    this->Header.Elements.push_back(std::move(element));
  }

  void ReadProperty()
  {
    if (this->Header.Elements.empty())
    {
      this->Scanner.Fail("a property comes before the first element");
    }
    PlyProperty property;
    std::string_view word = this->Scanner.Word();
    property.IsList = word == "list";
    if (property.IsList)
    {
      property.CountType = this->ToType(this->Scanner.Word());
      word = this->Scanner.Word();
    }
    property.Type = this->ToType(word);
    property.Name = this->Scanner.Word();
    PlyElement& element = this->Header.Elements.back();
    if (property.Name.empty() || element.Find(property.Name))
    {
      this->Scanner.Fail("property " + Quoted(property.Name) + " has no name, or another's");
    }
    element.Properties.push_back(std::move(property));
  }

  PlyType ToType(std::string_view word) const
  {
    const auto found = std::find_if(TypeFacts.begin(), TypeFacts.end(),
      [word](const PlyTypeFacts& facts) { return word == facts.Name || word == facts.OtherName; });
    if (found == TypeFacts.end())
    {
      this->Scanner.Fail("unknown type " + Quoted(word));
    }
    return static_cast<PlyType>(found - TypeFacts.begin());
  }

  void CheckElements()
  {
    if (this->Header.Format == PlyFormat::Unknown)
    {
      throw Malformed(this->File, "the header names no format");
    }
    PlyElement* const vertices = this->Header.Find("vertex");
    if (!vertices)
    {
      throw Malformed(this->File, "the header has no element vertex");
    }
    for (const char* axis : { "x", "y", "z" })
    {
      const PlyProperty* const property = vertices->Find(axis);
      if (!property || property->IsList)
      {
        throw Malformed(this->File, std::string("vertices have no number ") + axis);
      }
    }
  }

  /** One line end after end_header, of the kind that the first line has: data may look like one. */
  void FindBody()
  {
    const std::string_view text(this->File.Begin(), this->File.Size);
    const std::size_t firstEnd = text.find_first_of("\r\n");
    const bool onlyReturns = text[firstEnd] == '\r' && text.substr(firstEnd, 2) != "\r\n";
    while (!this->Scanner.AtLineEnd())
    {
      this->Scanner.Word();
    }
    const char* at = this->Scanner.Position();
    at += at != this->File.End() && *at == '\r' ? 1 : 0;
    at += at != this->File.End() && *at == '\n' && !onlyReturns ? 1 : 0;
    this->Header.Body = at;
    this->Header.BodyLine = this->Scanner.GetLine() + 1;
  }

  const FileContent& File;
  TextScanner Scanner;
  PlyHeader Header;
};

/** Takes numbers from the body of a binary file. */
class BinaryBody
{
public:
  BinaryBody(const FileContent& file, const PlyHeader& header, Monitor& monitor)
    : File(file)
    , At(header.Body)
    , Order(header.Format == PlyFormat::BigEndian ? ByteOrder::Big : ByteOrder::Little)
    , Watch(monitor)
  {
  }

  /** The fewest bytes that a number of the type takes. */
  static std::uint64_t ShortestLength(PlyType type) { return FactsOf(type).Length; }

  std::uint64_t Left() const { return static_cast<std::uint64_t>(this->File.End() - this->At); }

  std::string Place() const { return this->File.Name + ": "; }

  /** The next number; false when none is left. */
  bool Take(PlyType type, double& value)
  {
    const std::uint64_t length = FactsOf(type).Length;
    if (this->Left() < length)
    {
      return false;
    }
    value = this->Load(type);
    this->At += length;
    return true;
  }

  void EndElement()
  {
    constexpr std::uint64_t elementsBetweenChecks = 1 << 15;
    if (++this->Elements % elementsBetweenChecks == 0)
    {
      this->File.ReportPosition(this->At, this->Watch);
    }
  }

  bool HasMore() const { return this->At != this->File.End(); }

private:
  double Load(PlyType type) const
  {
    switch (type)
    {
      case PlyType::Int8:
        return double(LoadNumber<std::int8_t>(this->At, this->Order));
      case PlyType::UInt8:
        return double(LoadNumber<std::uint8_t>(this->At, this->Order));
      case PlyType::Int16:
        return double(LoadNumber<std::int16_t>(this->At, this->Order));
      case PlyType::UInt16:
        return double(LoadNumber<std::uint16_t>(this->At, this->Order));
      case PlyType::Int32:
        return double(LoadNumber<std::int32_t>(this->At, this->Order));
      case PlyType::UInt32:
        return double(LoadNumber<std::uint32_t>(this->At, this->Order));
      case PlyType::Float32:
        return double(LoadNumber<float>(this->At, this->Order));
      case PlyType::Float64:
        break;
    }
    return LoadNumber<double>(this->At, this->Order);
  }

  const FileContent& File;
  const char* At;
  const ByteOrder Order;
  std::uint64_t Elements = 0;
  Monitor& Watch;
};

/** Takes numbers from the body of an ascii file. */
class TextBody
{
public:
  TextBody(const FileContent& file, const PlyHeader& header, Monitor& monitor)
    : File(file)
    , Scanner(file, header.Body, header.BodyLine, {}, monitor)
  {
    std::uint64_t elements = 0;
    for (const PlyElement& element : header.Elements)
    {
      elements += element.Properties.empty() ? 0 : element.Count;
    }
    this->ElementPerLine = this->Scanner.HasLines(elements);
  }

  /** A digit and a blank. */
  static std::uint64_t ShortestLength(PlyType /*type*/) { return 2; }

  /** The last number needs no blank: it is counted as if there were one. */
  std::uint64_t Left() const { return this->Scanner.Left() + 1; }

  std::string Place() const
  {
    return this->File.Name + ", line " + std::to_string(this->Scanner.GetLine()) + ": ";
  }

  bool Take(PlyType type, double& value)
  {
    if (!this->Scanner.SkipToContent())
    {
      return false;
    }
    value = this->Scanner.Number();
    const PlyTypeFacts& facts = FactsOf(type);
    if (IsInteger(type) &&
      !(value >= facts.Lowest && value <= facts.Highest && value == std::floor(value)))
    {
      this->Scanner.Fail(std::string("a number is not of its type ") + facts.Name);
    }
    return true;
  }

  void EndElement()
  {
    if (this->ElementPerLine)
    {
      this->FirstExtra = this->FirstExtra == 0 && !this->Scanner.AtLineEnd()
        ? this->Scanner.GetLine()
        : this->FirstExtra;
      this->Scanner.SkipLine();
    }
  }

  bool HasMore() { return this->FirstExtra != 0 || this->Scanner.SkipToContent(); }

private:
  const FileContent& File;
  TextScanner Scanner;
  // Where there are enough lines, what stands behind an element's numbers is passed over.
  bool ElementPerLine = true;
  std::int64_t FirstExtra = 0; ///< the line where that happened first, 0 for none
};

constexpr Id StripEnd = -1;

/**
 * Append the triangles of strips. Each other one of a strip is turned over; one that has a point
 * twice is there to join others and is none.
 */
void AppendTriangles(
  const FileContent& file, const std::vector<Id>& strips, PolygonSurface& surface)
{
  std::size_t first = 0;
  for (std::size_t i = 0; i < strips.size(); ++i)
  {
    if (strips[i] == StripEnd)
    {
      first = i + 1;
      continue;
    }
    if (i < first + 2)
    {
      continue;
    }
    const bool turned = (i - first) % 2 == 1;
    const std::array<Id, 3> t = { strips[turned ? i - 1 : i - 2], strips[turned ? i - 2 : i - 1],
      strips[i] };
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      surface.Corners.insert(surface.Corners.end(), t.begin(), t.end());
      ClosePolygon(file, surface);
    }
  }
}

/** Reads the elements in the order of the header. */
template <typename Body>
class PlyBodyReader
{
public:
  PlyBodyReader(const FileContent& file, PlyHeader& header, Monitor& monitor)
    : File(file)
    , Header(header)
    , Source(file, header, monitor)
    , PointCount(header.Find("vertex")->Count)
  {
  }

  void Read(PolygonSurface& surface)
  {
    for (PlyElement& element : this->Header.Elements)
    {
      if (!element.Properties.empty())
      {
        this->ReadElements(element, surface);
      }
    }
    WarnOfDropped(this->File, this->Dropped, surface);
    if (this->Source.HasMore())
    {
      surface.Warnings.push_back(
        this->File.Name + ": more was in the file than its header describes, and was passed over");
    }
  }

private:
  void ReadElements(PlyElement& element, PolygonSurface& surface)
  {
    this->CheckAnnounced(element);
    const bool isVertex = element.Name == "vertex";
    const bool isFace = element.Name == "face";
    const PlyProperty* const corners = this->Header.CornersOf(element);
    const PlyProperty* const strips = this->Header.StripsOf(element);
    if (isFace && !corners && element.Count > 0)
    {
      throw Malformed(this->File, "faces have no list vertex_indices");
    }
    this->Reserve(element, isVertex || isFace);
    for (this->Index = 0; this->Index < element.Count; ++this->Index)
    {
      for (PlyProperty& property : element.Properties)
      {
        this->ReadProperty(element, property,
          &property == corners    ? &surface.Corners
            : &property == strips ? &this->Strips
                                  : nullptr);
      }
      if (strips)
      {
        AppendTriangles(this->File, this->Strips, surface);
        this->Strips.clear();
      }
      if (corners && !ClosePolygon(this->File, surface))
      {
        ++this->Dropped;
        this->ForgetLast(element);
      }
      else if (!isVertex && !isFace)
      {
        this->ForgetLast(element);
      }
      this->Source.EndElement();
    }
  }

  /** Before anything is allocated: are there bytes for as many elements? */
  void CheckAnnounced(const PlyElement& element) const
  {
    std::uint64_t shortest = 0;
    for (const PlyProperty& property : element.Properties)
    {
      shortest += Body::ShortestLength(property.IsList ? property.CountType : property.Type);
    }
    const std::uint64_t possible = this->Source.Left() / shortest;
    if (element.Count > possible)
    {
      this->FailMissing(element, possible);
    }
    if (element.Name == "vertex")
    {
      CheckCount(this->File, element.Count, "points");
    }
    if (element.Name == "face")
    {
      CheckCount(this->File, element.Count, "faces");
    }
  }

  [[noreturn]] void FailMissing(const PlyElement& element, std::uint64_t index) const
  {
    throw Malformed(this->File,
      element.Name + " " + std::to_string(index) + " of " + std::to_string(element.Count) +
        " is missing: the file is truncated");
  }

  void Reserve(PlyElement& element, bool kept)
  {
    for (PlyProperty& property : element.Properties)
    {
      property.Values.reserve(kept && !property.IsList ? element.Count : 1);
    }
  }

  void ForgetLast(PlyElement& element)
  {
    for (PlyProperty& property : element.Properties)
    {
      if (!property.IsList)
      {
        property.Values.pop_back();
      }
    }
  }

  /** `points` is given for the lists of corners and of strips. */
  void ReadProperty(const PlyElement& element, PlyProperty& property, std::vector<Id>* points)
  {
    if (!property.IsList)
    {
      property.Values.push_back(this->Take(element, property.Type));
      return;
    }
    const std::uint64_t count = this->ListLength(element, property);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      const double value = this->Take(element, property.Type);
      if (points)
      {
        const bool endsStrip = points == &this->Strips && value == StripEnd;
        points->push_back(endsStrip ? StripEnd : this->PointId(element, value));
      }
    }
  }

  std::uint64_t ListLength(const PlyElement& element, const PlyProperty& property)
  {
    const double count = this->Take(element, property.CountType);
    // A double up to 2^53 is an exact integer; no count beyond has its bytes in the file.
    constexpr double largest = 9007199254740992.0;
    if (!(count >= 0.0 && count <= largest && count == std::floor(count)))
    {
      this->Fail(element, "announces a list of negative or fractional length");
    }
    const auto length = static_cast<std::uint64_t>(count);
    if (length > this->Source.Left() / Body::ShortestLength(property.Type))
    {
      this->Fail(element,
        "announces a list of " + std::to_string(length) +
          " numbers that are not there: the file is truncated or damaged");
    }
    return length;
  }

  double Take(const PlyElement& element, PlyType type)
  {
    double value = 0.0;
    if (!this->Source.Take(type, value))
    {
      this->FailMissing(element, this->Index);
    }
    return value;
  }

  Id PointId(const PlyElement& element, double value) const
  {
    if (!(value >= 0.0 && value < double(this->PointCount) && value == std::floor(value)))
    {
      std::array<char, 32> text;
      char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
      throw Error(ErrorCode::FileMalformed,
        this->Source.Place() + element.Name + " " + std::to_string(this->Index) +
          " refers to point " + std::string(text.data(), end) + " of " +
          std::to_string(this->PointCount));
    }
    return static_cast<Id>(value);
  }

  [[noreturn]] void Fail(const PlyElement& element, const std::string& what) const
  {
    throw Error(ErrorCode::FileMalformed,
      this->Source.Place() + element.Name + " " + std::to_string(this->Index) + " " + what);
  }

  const FileContent& File;
  PlyHeader& Header;
  Body Source;
  const std::uint64_t PointCount;
  std::uint64_t Index = 0; ///< of the element that is read
  std::uint64_t Dropped = 0;
  std::vector<Id> Strips; ///< of the element that is read
};

/** Moves the properties of an element into attributes. */
class AttributeMaker
{
public:
  AttributeMaker(PlyElement& element, std::vector<Attribute>& attributes)
    : Element(element)
    , Attributes(attributes)
  {
  }

  void MakeAll()
  {
    this->MakeVector("Normals", { "nx", "ny", "nz" });
    for (const Names& names : { Names{ "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" } })
    {
      if (!this->IsTaken("TCoords"))
      {
        this->MakeVector("TCoords", names);
      }
    }
    this->MakeColors();
    while (!this->Element.Properties.empty())
    {
      const std::string name = this->Element.Properties.front().Name;
      if (this->Element.Properties.front().IsList)
      {
        this->Remove({ name });
      }
      else
      {
        this->Make(this->FreeName(name), { name });
      }
    }
  }

private:
  using Names = std::vector<std::string>;

  bool HasNumbers(const Names& names) const
  {
    return std::all_of(names.begin(), names.end(),
      [this](const std::string& name)
      {
        const PlyProperty* const property = this->Element.Find(name);
        return property && !property->IsList;
      });
  }

  bool HaveType(const Names& names, PlyType type) const
  {
    return std::all_of(names.begin(), names.end(),
      [this, type](const std::string& name) { return this->Element.Find(name)->Type == type; });
  }

  /** Whether the properties are integers that 32 bits with a sign hold. */
  bool AreIntegers(const Names& names) const
  {
    const double highest = FactsOf(PlyType::Int32).Highest;
    return std::all_of(names.begin(), names.end(),
      [this, highest](const std::string& name)
      {
        const PlyProperty& property = *this->Element.Find(name);
        return IsInteger(property.Type) &&
          std::all_of(property.Values.begin(), property.Values.end(),
            [highest](double value) { return value <= highest; });
      });
  }

  bool IsTaken(std::string_view name) const
  {
    return std::any_of(this->Attributes.begin(), this->Attributes.end(),
      [name](const Attribute& attribute) { return attribute.Name == name; });
  }

  std::string FreeName(std::string name) const
  {
    while (this->IsTaken(name))
    {
      name += '_';
    }
    return name;
  }

  void Remove(const Names& names)
  {
    std::vector<PlyProperty>& properties = this->Element.Properties;
    properties.erase(std::remove_if(properties.begin(), properties.end(),
                       [&names](const PlyProperty& property) {
                         return std::find(names.begin(), names.end(), property.Name) != names.end();
                       }),
      properties.end());
  }

  /** The values of the properties, those of one point or polygon side by side. */
  template <typename T>
  std::vector<T> Values(const Names& names) const
  {
    const std::size_t count = this->Element.Find(names.front())->Values.size();
    std::vector<T> values(count * names.size());
    for (std::size_t component = 0; component < names.size(); ++component)
    {
      const std::vector<double>& column = this->Element.Find(names[component])->Values;
      for (std::size_t i = 0; i < count; ++i)
      {
        values[i * names.size() + component] = static_cast<T>(column[i]);
      }
    }
    return values;
  }

  void Make(const std::string& attribute, const Names& names)
  {
    Attribute made{ attribute, static_cast<int>(names.size()), {} };
    if (this->HaveType(names, PlyType::UInt8))
    {
      made.Values = this->Values<unsigned char>(names);
    }
    else if (this->AreIntegers(names))
    {
      made.Values = this->Values<std::int32_t>(names);
    }
    else if (this->HaveType(names, PlyType::Float32))
    {
      made.Values = this->Values<float>(names);
    }
    else
    {
      made.Values = this->Values<double>(names);
    }
    this->Attributes.push_back(std::move(made));
    this->Remove(names);
  }

  void MakeVector(const char* attribute, const Names& names)
  {
    if (this->HasNumbers(names) && !this->AreIntegers(names))
    {
      this->Make(attribute, names);
    }
  }

  void MakeColors()
  {
    Names names = { "red", "green", "blue", "alpha" };
    if (!this->HasNumbers(names))
    {
      names.pop_back();
    }
    if (!this->HasNumbers(names))
    {
      return;
    }
    if (this->HaveType(names, PlyType::UInt8))
    {
      this->Make("Colors", names);
    }
    else if (auto bytes = ToColorBytes(this->Values<double>(names)))
    {
      this->Attributes.push_back({ "Colors", static_cast<int>(names.size()), std::move(*bytes) });
      this->Remove(names);
    }
  }

  PlyElement& Element;
  std::vector<Attribute>& Attributes;
};

void MovePoints(PlyElement& vertices, std::vector<Point>& points)
{
  points.resize(vertices.Count);
  const std::array<const char*, 3> axes = { "x", "y", "z" };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const PlyProperty* const property = vertices.Find(axes[axis]);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      points[i][axis] = property->Values[i];
    }
    vertices.Properties.erase(vertices.Properties.begin() + (property - &vertices.Properties[0]));
  }
}

/** Name the statements, elements and lists that have no place in a PolygonSurface. */
void WarnOfUnused(const FileContent& file, PlyHeader& header, PolygonSurface& surface)
{
  if (header.UnknownStatements > 0)
  {
    surface.Warnings.push_back(file.Name + ": " + std::to_string(header.UnknownStatements) +
      " unknown statements were passed over in the header, the first on " + header.FirstUnknown);
  }
  for (const PlyElement& element : header.Elements)
  {
    const bool used = element.Name == "vertex" || element.Name == "face";
    if (!used && element.Count > 0 && !header.StripsOf(element))
    {
      surface.Warnings.push_back(file.Name + ": " + std::to_string(element.Count) + " elements " +
        Quoted(element.Name) + " were passed over");
    }
    const PlyProperty* const corners = header.CornersOf(element);
    for (const PlyProperty& property : element.Properties)
    {
      if (used && property.IsList && &property != corners)
      {
        surface.Warnings.push_back(file.Name + ": the lists " + Quoted(property.Name) + " of " +
          element.Name + " were passed over");
      }
    }
  }
}
} // namespace

bool IsPly(const FileContent& file)
{
  const std::string_view text(file.Begin(), file.Size);
  return text.substr(0, 3) == "ply" && text.find_first_of(" \t\r\n") == 3;
}

PolygonSurface ReadPly(const FileContent& file, Monitor& monitor)
{
  PolygonSurface surface;
  PlyHeader header = PlyHeaderReader(file, monitor).Read();
  if (header.Format == PlyFormat::Ascii)
  {
    PlyBodyReader<TextBody>(file, header, monitor).Read(surface);
  }
  else
  {
    PlyBodyReader<BinaryBody>(file, header, monitor).Read(surface);
  }
  WarnOfUnused(file, header, surface);
  MovePoints(*header.Find("vertex"), surface.Points);
  AttributeMaker(*header.Find("vertex"), surface.PointAttributes).MakeAll();
  PlyElement* const faces = header.Find("face");
  if (faces && faces->Count > 0) // polygons are else of strips
  {
    AttributeMaker(*faces, surface.PolygonAttributes).MakeAll();
  }
  return surface;
}
} // namespace insideout
