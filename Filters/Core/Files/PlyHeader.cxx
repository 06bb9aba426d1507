// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/PlyHeader.h"

#include "Files/TextScanner.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** The first of `things` that has this name, or their end. */
template <typename Things>
auto FindNamed(Things& things, std::string_view name)
{
  return std::find_if(
    things.begin(), things.end(), [name](const auto& thing) { return thing.Name == name; });
}

class PlyHeaderReader
{
public:
  PlyHeaderReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.TextBegin(), 1, {}, monitor)
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
  /** False after end_header. */
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

  /** Some programs insert their name without the word comment. */
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
    const auto found = std::find_if(PlyTypes.begin(), PlyTypes.end(),
      [word](const PlyTypeFacts& facts) { return word == facts.Name || word == facts.OtherName; });
    if (found == PlyTypes.end())
    {
      this->Scanner.Fail("unknown type " + Quoted(word));
    }
    return static_cast<PlyType>(found - PlyTypes.begin());
  }

  void CheckElements()
  {
    if (this->Header.Format == PlyFormat::Unknown)
    {
      throw Malformed(this->File, "the header names no format");
    }
    const PlyElement* const vertices = this->Header.Find("vertex");
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
    if (this->Header.HasFaces() && !this->Header.PointIdsOf(*this->Header.Find("face")))
    {
      throw Malformed(this->File, "faces have no list vertex_indices");
    }
  }

  /**
   * Skip one line end after end_header, of the same kind as the first line's: data may look like
   * one.
   */
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
} // namespace

const PlyProperty* PlyElement::Find(std::string_view name) const
{
  const auto found = FindNamed(this->Properties, name);
  return found == this->Properties.end() ? nullptr : &*found;
}

void PlyElement::Remove(std::string_view name)
{
  this->Properties.erase(FindNamed(this->Properties, name));
}

PlyElement* PlyHeader::Find(std::string_view name)
{
  const auto found = FindNamed(this->Elements, name);
  return found == this->Elements.end() ? nullptr : &*found;
}

bool PlyHeader::HasFaces() const
{
  const auto faces = FindNamed(this->Elements, "face");
  return faces != this->Elements.end() && faces->Count > 0;
}

const PlyProperty* PlyHeader::PointIdsOf(const PlyElement& element) const
{
  const bool isSource =
    element.Name == "face" || (element.Name == "tristrips" && !this->HasFaces());
  const PlyProperty* ids = element.Find("vertex_indices");
  ids = ids ? ids : element.Find("vertex_index");
  return isSource && ids && ids->IsList ? ids : nullptr;
}

PlyHeader ReadPlyHeader(const FileContent& file, Monitor& monitor)
{
  return PlyHeaderReader(file, monitor).Read();
}
} // namespace insideout
