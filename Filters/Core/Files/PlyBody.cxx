// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/PlyBody.h"

#include "Files/ByteOrder.h"
#include "Files/TextScanner.h"

#include <charconv>
#include <cmath>

namespace insideout
{
namespace
{
template <typename T>
double Load(const char* bytes, ByteOrder order)
{
  return double(LoadNumber<T>(bytes, order));
}

/** Reads numbers from the body of a binary file. */
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

  /** The least number of bytes of a number of the type. */
  static std::uint64_t ShortestLength(PlyType type) { return FactsOf(type).Length; }

  std::uint64_t Left() const { return static_cast<std::uint64_t>(this->File.End() - this->At); }

  /** The next number; false at the end. */
  bool Take(PlyType type, double& value)
  {
    // In the order of PlyType.
    constexpr std::array<double (*)(const char*, ByteOrder), 8> load = { &Load<std::int8_t>,
      &Load<std::uint8_t>, &Load<std::int16_t>, &Load<std::uint16_t>, &Load<std::int32_t>,
      &Load<std::uint32_t>, &Load<float>, &Load<double> };
    const std::uint64_t length = FactsOf(type).Length;
    if (this->Left() < length)
    {
      return false;
    }
    value = load[static_cast<std::size_t>(type)](this->At, this->Order);
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

  [[noreturn]] void Fail(const std::string& what) const { throw Malformed(this->File, what); }

private:
  const FileContent& File;
  const char* At;
  const ByteOrder Order;
  std::uint64_t Elements = 0;
  Monitor& Watch;
};

/** Reads numbers from the body of an ascii file. */
class TextBody
{
public:
  TextBody(const FileContent& file, const PlyHeader& header, Monitor& monitor)
    : Scanner(file, header.Body, header.BodyLine, {}, monitor)
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

  /** The last number needs no blank: it is counted as if it had one. */
  std::uint64_t Left() const { return this->Scanner.Left() + 1; }

  bool Take(PlyType type, double& value)
  {
    if (!this->Scanner.SkipToContent())
    {
      return false;
    }
    value = this->Scanner.Number();
    const PlyTypeFacts& facts = FactsOf(type);
    if (facts.IsInteger &&
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
      this->HasExtras = !this->Scanner.AtLineEnd() || this->HasExtras;
      this->Scanner.SkipLine();
    }
  }

  /** Without a line for each element a wrong count shifts every number after it. */
  bool HasMore()
  {
    const bool hasContent = this->Scanner.SkipToContent();
    if (hasContent && !this->ElementPerLine)
    {
      this->Fail("more follows than the header describes: one of its counts is wrong");
    }
    return this->HasExtras || hasContent;
  }

  [[noreturn]] void Fail(const std::string& what) const { this->Scanner.Fail(what); }

private:
  TextScanner Scanner;
  // If there are enough lines, the rest of an element's line is skipped.
  bool ElementPerLine = true;
  bool HasExtras = false; ///< whether a rest was skipped
};

constexpr Id StripEnd = -1;

/**
 * Append the triangles of strips. Every other triangle of a strip is reversed; one with a repeated
 * point only joins others and is dropped.
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
  PlyBodyReader(
    const FileContent& file, PlyHeader& header, PolygonSurface& surface, Monitor& monitor)
    : File(file)
    , Header(header)
    , Surface(surface)
    , Source(file, header, monitor)
    , PointCount(header.Find("vertex")->Count)
  {
  }

  void Read()
  {
    for (PlyElement& element : this->Header.Elements)
    {
      if (!element.Properties.empty())
      {
        this->Element = &element;
        this->IsFace = element.Name == "face";
        this->IsKept = element.IsKept();
        this->ReadElements();
      }
    }
    WarnOfDropped(this->File, this->Dropped, this->Surface);
    if (this->Source.HasMore())
    {
      this->Surface.Warnings.push_back(
        this->File.Name + ": more was in the file than its header describes, and was skipped");
    }
  }

private:
  void ReadElements()
  {
    this->CheckAnnounced();
    const PlyProperty* const pointIds = this->Header.PointIdsOf(*this->Element);
    this->Reserve();
    for (this->Index = 0; this->Index < this->Element->Count; ++this->Index)
    {
      for (PlyProperty& property : this->Element->Properties)
      {
        if (property.IsList)
        {
          std::vector<Id>* const ids = this->IsFace ? &this->Surface.Corners : &this->Strips;
          this->ReadList(property, &property == pointIds ? ids : nullptr);
        }
        else
        {
          property.Values.push_back(this->Take(property.Type));
        }
      }
      if (!this->FinishElement())
      {
        this->ForgetLast();
      }
      this->Source.EndElement();
    }
  }

  /** Check before allocating that there are enough bytes for the elements. */
  void CheckAnnounced() const
  {
    std::uint64_t shortest = 0;
    for (const PlyProperty& property : this->Element->Properties)
    {
      shortest += Body::ShortestLength(property.IsList ? property.CountType : property.Type);
    }
    const std::uint64_t possible = this->Source.Left() / shortest;
    if (this->Element->Count > possible)
    {
      this->FailMissing(possible);
    }
    if (this->IsKept)
    {
      CheckCount(this->File, this->Element->Count, this->IsFace ? "faces" : "points");
    }
  }

  void Reserve()
  {
    for (PlyProperty& property : this->Element->Properties)
    {
      property.Values.reserve(this->IsKept && !property.IsList ? this->Element->Count : 1);
    }
  }

  /** `ids` is given for lists of points. */
  void ReadList(const PlyProperty& list, std::vector<Id>* ids)
  {
    const std::uint64_t length = this->TakeLength(list);
    for (std::uint64_t i = 0; i < length; ++i)
    {
      const double value = this->Take(list.Type);
      if (ids)
      {
        const bool endsStrip = ids == &this->Strips && value == StripEnd;
        ids->push_back(endsStrip ? StripEnd : this->PointId(value));
      }
    }
  }

  std::uint64_t TakeLength(const PlyProperty& list)
  {
    const double count = this->Take(list.CountType);
    // A double up to 2^53 is an exact integer; the file cannot have the bytes for a larger count.
    constexpr double largest = 9007199254740992.0;
    if (!(count >= 0.0 && count <= largest && count == std::floor(count)))
    {
      this->Fail("announces a list of negative or fractional length");
    }
    const auto length = static_cast<std::uint64_t>(count);
    if (length > this->Source.Left() / Body::ShortestLength(list.Type))
    {
      this->Fail("announces a list of " + std::to_string(length) +
        " numbers that are not there: the file is truncated or damaged");
    }
    return length;
  }

  double Take(PlyType type)
  {
    double value = 0.0;
    if (!this->Source.Take(type, value))
    {
      this->FailMissing(this->Index);
    }
    return value;
  }

  Id PointId(double value) const
  {
    if (!(value >= 0.0 && value < double(this->PointCount) && value == std::floor(value)))
    {
      std::array<char, 32> text;
      char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
      this->Fail("refers to point " + std::string(text.data(), end) + " of " +
        std::to_string(this->PointCount));
    }
    // Faces may come before the vertices, whose number is then unchecked.
    CheckCount(this->File, static_cast<std::uint64_t>(value) + 1, "points");
    return static_cast<Id>(value);
  }

  /** Make polygons of the element that was read. False if its numbers are not to be kept. */
  bool FinishElement()
  {
    if (this->IsFace)
    {
      const bool isPolygon = ClosePolygon(this->File, this->Surface);
      this->Dropped += isPolygon ? 0 : 1;
      return isPolygon;
    }
    AppendTriangles(this->File, this->Strips, this->Surface);
    this->Strips.clear();
    return this->IsKept;
  }

  void ForgetLast()
  {
    for (PlyProperty& property : this->Element->Properties)
    {
      if (!property.IsList)
      {
        property.Values.pop_back();
      }
    }
  }

  [[noreturn]] void FailMissing(std::uint64_t index) const
  {
    throw Malformed(this->File,
      this->Element->Name + " " + std::to_string(index) + " of " +
        std::to_string(this->Element->Count) + " is missing: the file is truncated");
  }

  [[noreturn]] void Fail(const std::string& what) const
  {
    this->Source.Fail(this->Element->Name + " " + std::to_string(this->Index) + " " + what);
  }

  const FileContent& File;
  PlyHeader& Header;
  PolygonSurface& Surface;
  Body Source;
  const std::uint64_t PointCount;
  PlyElement* Element = nullptr; ///< the kind being read
  bool IsFace = false;           ///< whether these are the faces
  bool IsKept = false;           ///< whether these are faces or vertices
  std::uint64_t Index = 0;       ///< of the element that is read
  std::vector<Id> Strips;        ///< of the element that is read
  std::uint64_t Dropped = 0;
};
} // namespace

void ReadPlyBody(
  const FileContent& file, PlyHeader& header, PolygonSurface& surface, Monitor& monitor)
{
  if (header.Format == PlyFormat::Ascii)
  {
    PlyBodyReader<TextBody>(file, header, surface, monitor).Read();
  }
  else
  {
    PlyBodyReader<BinaryBody>(file, header, surface, monitor).Read();
  }
}
} // namespace insideout
