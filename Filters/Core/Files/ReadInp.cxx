// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/InpSets.h"
#include "Files/SolidBuilder.h"
#include "Files/SolidReaders.h"

#include <algorithm>

// The format: Abaqus Keywords Reference Guide; Dhondt, CalculiX CrunchiX User's Manual.

namespace insideout
{
namespace
{
/**
 * The number of points of an element type that is a triangle or a tetrahedron; 0 for other types.
 */
struct InpType
{
  std::size_t Corners;
  std::size_t Nodes;
};

/** The digits after one of these prefixes of a type's name, 0 if there are none. */
int DigitsBehind(const std::string& type, std::initializer_list<const char*> beginnings)
{
  for (const std::string beginning : beginnings)
  {
    const std::size_t end = type.find_first_not_of("0123456789", beginning.size());
    if (type.compare(0, beginning.size(), beginning) == 0 && type.size() > beginning.size() &&
      end != beginning.size() && std::min(end, type.size()) < beginning.size() + 3)
    {
      return std::stoi(type.substr(beginning.size(), end - beginning.size()));
    }
  }
  return 0;
}

InpType TypeOf(const std::string& type)
{
  const int ofVolume = DigitsBehind(type, { "C3D", "DC3D", "AC3D" });
  if (ofVolume == 4 || ofVolume == 10)
  {
    return { 4, static_cast<std::size_t>(ofVolume) };
  }
  const int ofFace = DigitsBehind(type,
    { "CPS", "CPE", "CPEG", "CAX", "CGAX", "DC2D", "DCAX", "AC2D", "ACAX", "S", "DS", "STRI", "M3D",
      "SFM3D", "R3D" });
  if (ofFace == 3 || ofFace == 6 || type == "STRI65")
  {
    return { 3, ofFace == 3 ? 3u : 6u };
  }
  return { 0, 0 };
}

/** Whether elements of this type are lines, springs or masses, which are not part of a solid. */
bool IsNoCell(const std::string& type)
{
  for (const std::string beginning :
    { "T2D", "T3D", "B2", "B3", "R2D", "RB", "MASS", "ROTARYI", "SPRING", "DASHPOT", "CONN" })
  {
    if (type.compare(0, beginning.size(), beginning) == 0)
    {
      return true;
    }
  }
  return false;
}

class InpReader
{
public:
  InpReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.TextBegin(), 1, { false, false }, monitor)
    , Builder(file)
    , Sets(file)
  {
  }

  SolidContent Read()
  {
    while (this->Scanner.SkipToContent())
    {
      if (*this->Scanner.Position() != '*')
      {
        (this->*ReadData)();
        continue;
      }
      this->KeywordLine = this->Scanner.GetLine();
      const std::string line = this->Line();
      if (line.compare(0, 2, "**") == 0)
      {
        this->Sets.ReadComment(line);
      }
      else
      {
        this->ReadKeyword(line);
      }
    }
    this->Sets.PutInto(this->Builder);
    return this->Builder.Finish();
  }

private:
  void ReadKeyword(const std::string& line)
  {
    InpKeyword keyword(line);
    while (keyword.IsContinued && this->Scanner.SkipToContent())
    {
      keyword.Continue(this->Line());
    }
    this->ReadData = &InpReader::SkipData;
    this->FollowParts(keyword.Name);
    // An assembly has points of its own, outside its instances: they bear loads.
    const bool isMesh = !this->IsInAssembly || this->IsInInstance;
    if (keyword.Name == "NODE" && isMesh)
    {
      this->BeginNodes(keyword);
    }
    else if (keyword.Name == "ELEMENT" && isMesh)
    {
      this->BeginElements(keyword);
    }
    else if (keyword.Name == "ELSET")
    {
      this->Sets.BeginSet(keyword);
      this->ReadData = &InpReader::ReadSet;
    }
    else if (keyword.Name == "SURFACE" && keyword.Is("TYPE", "ELEMENT"))
    {
      this->Sets.BeginSurface(keyword);
      this->ReadData = &InpReader::ReadSurface;
    }
    else if (keyword.Name == "INCLUDE")
    {
      this->WarnOfOtherFile(keyword);
    }
  }

  void FollowParts(const std::string& name)
  {
    if (name == "PART" && ++this->Parts > 1)
    {
      this->FailAtKeyword("a second *PART begins; files of one part can be read");
    }
    this->IsInAssembly = name == "ASSEMBLY" || (this->IsInAssembly && name != "END ASSEMBLY");
    this->IsInInstance = name == "INSTANCE" || (this->IsInInstance && name != "END INSTANCE");
  }

  [[noreturn]] void FailAtKeyword(const std::string& what) const
  {
    FailAtLine(this->File, this->KeywordLine, what);
  }

  void WarnOfOtherFile(const InpKeyword& keyword)
  {
    this->Builder.Warn(", line " + std::to_string(this->KeywordLine) +
      ": the content of another file is left out: " + keyword.Get("INPUT"));
  }

  void BeginNodes(const InpKeyword& keyword)
  {
    const std::string system = keyword.Get("SYSTEM");
    if (!system.empty() && !EqualsIgnoringCase(system, "r"))
    {
      this->FailAtKeyword("coordinates of the system " + Quoted(system) + " cannot be read");
    }
    if (!keyword.Get("INPUT").empty())
    {
      this->WarnOfOtherFile(keyword);
    }
    this->ReadData = &InpReader::ReadNode;
  }

  void BeginElements(const InpKeyword& keyword)
  {
    if (!keyword.Get("INPUT").empty())
    {
      this->WarnOfOtherFile(keyword);
    }
    const std::string type = InpKeyword::Upper(keyword.Get("TYPE"));
    if (type.empty())
    {
      this->FailAtKeyword("*ELEMENT has no TYPE");
    }
    this->Set = this->Sets.NumberOf(keyword.Get("ELSET"));
    this->Type = TypeOf(type);
    this->OtherType = IsNoCell(type) ? "" : "elements of type " + type;
    this->ReadData = this->Type.Nodes > 0 ? &InpReader::ReadElement : &InpReader::CountOther;
  }

  void ReadNode()
  {
    const std::int64_t number = this->Scanner.LeadingInteger();
    Point point = { { 0, 0, 0 } };
    for (double& x : point)
    {
      // Omitted coordinates are 0.
      if (this->NextField() && *this->Scanner.Position() != ',')
      {
        x = this->Scanner.LeadingNumber();
      }
    }
    this->Builder.AddPoint(this->Scanner, number, point);
    this->Scanner.SkipLine(); // a normal may follow
  }

  void ReadElement()
  {
    FileElement element = { 0, this->Scanner.GetLine(), this->Set };
    element.Number = this->Scanner.LeadingInteger();
    this->Nodes.resize(this->Type.Nodes);
    for (std::int64_t& node : this->Nodes)
    {
      // A line that ends with a comma continues.
      if (this->NextField() || (this->IsBehindComma && this->Scanner.SkipToContent()))
      {
        node = this->Scanner.LeadingInteger();
        continue;
      }
      this->Scanner.Fail("element " + std::to_string(element.Number) + " has not " +
        std::to_string(this->Type.Nodes) + " points");
    }
    if (this->NextField())
    {
      this->Scanner.Fail("element " + std::to_string(element.Number) + " has more than " +
        std::to_string(this->Type.Nodes) + " points");
    }
    SolidBuilder::AddElement(
      this->Type.Corners == 3 ? this->Builder.Triangles : this->Builder.Tetrahedra, element,
      this->Nodes);
  }

  /** Move after the comma to the next item on the line; false if there is none. */
  bool NextField()
  {
    this->IsBehindComma = false;
    if (this->Scanner.AtLineEnd())
    {
      return false;
    }
    if (!this->Scanner.Accept(','))
    {
      this->Scanner.Fail("expected a comma, found " + Quoted(this->Scanner.Word()));
    }
    this->IsBehindComma = true;
    return !this->Scanner.AtLineEnd();
  }

  void CountOther()
  {
    const bool isBegin = !this->GoesOn;
    const std::string line = this->Line();
    this->GoesOn = !line.empty() && line.back() == ',';
    this->Builder.AddOthers(this->OtherType, isBegin && !this->OtherType.empty() ? 1 : 0);
  }

  void ReadSet() { this->Sets.AddToSet(this->Line()); }
  void ReadSurface() { this->Sets.AddToSurface(this->Line()); }
  void SkipData() { this->Scanner.SkipLine(); }

  /** The rest of the line, without trailing blanks. */
  std::string Line()
  {
    this->GoesOn = false;
    const char* const begin = this->Scanner.Position();
    this->Scanner.SkipLine();
    const std::string line(begin, this->Scanner.Position());
    return line.substr(0, line.find_last_not_of(" \t\r\n") + 1);
  }

  const FileContent& File;
  TextScanner Scanner;
  std::int64_t KeywordLine = 1;
  SolidBuilder Builder;
  InpSets Sets;
  void (InpReader::*ReadData)() = &InpReader::SkipData; ///< of the line after the last keyword
  int Parts = 0;
  bool IsInAssembly = false;
  bool IsInInstance = false;
  std::int64_t Set = 0; ///< type of the elements being read
  InpType Type = { 0, 0 };
  std::string OtherType;
  bool GoesOn = false; ///< the last element of another type
  bool IsBehindComma = false;
  std::vector<std::int64_t> Nodes;
};
} // namespace

SolidContent ReadInp(const FileContent& file, Monitor& monitor)
{
  return InpReader(file, monitor).Read();
}
} // namespace insideout
