// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/StlText.h"

#include "Files/NameNumbers.h"
#include "Files/TextScanner.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>

// The format: 3D Systems, StereoLithography Interface Specification (1988).

namespace insideout
{
namespace
{
bool Is(std::string_view word, std::string_view keyword)
{
  return EqualsIgnoringCase(word, keyword);
}

bool IsComment(std::string_view word)
{
  return word.substr(0, 2) == "//" || word.find_first_of("#;!") == 0;
}

/** Deviations from the format: each kind once, with its first line. */
class Oddities
{
public:
  void Note(const TextScanner& scanner, const std::string& what)
  {
    const auto found = std::find_if(
      this->Notes.begin(), this->Notes.end(), [&](const auto& n) { return n.What == what; });
    if (found == this->Notes.end())
    {
      this->Notes.push_back({ what, scanner.GetLine(), 1 });
    }
    else
    {
      ++found->Times;
    }
  }

  void AddTo(PolygonSurface& surface, const FileContent& file) const
  {
    for (const Oddity& note : this->Notes)
    {
      surface.Warnings.push_back(file.Name + ", line " + std::to_string(note.Line) + ": " +
        note.What + (note.Times > 1 ? " (" + std::to_string(note.Times) + " times)" : ""));
    }
  }

private:
  struct Oddity
  {
    std::string What;
    std::int64_t Line;
    std::int64_t Times;
  };
  std::vector<Oddity> Notes;
};

/** Reads `solid`s, one after the other, into one surface. */
class StlTextReader
{
public:
  StlTextReader(const FileContent& file, Monitor& monitor)
    : File(file)
    , Scanner(file, file.TextBegin(), 1, {}, monitor)
  {
  }

  PolygonSurface Read()
  {
    bool isStl = false;
    std::string_view word = this->Next();
    const std::string first(word);
    while (!word.empty())
    {
      if (Is(word, "solid"))
      {
        isStl = true;
        const std::string name = this->ReadName();
        word = this->ReadFacets(this->Next(), name);
      }
      else if (Is(word, "facet"))
      {
        isStl = true;
        this->Odd.Note(this->Scanner, "a facet outside of any solid was read");
        word = this->ReadFacets(word, {});
      }
      else
      {
        this->Odd.Note(this->Scanner, "text outside of any solid was skipped");
        this->Scanner.SkipLine();
        word = this->Next();
      }
    }
    if (!isStl)
    {
      throw Malformed(this->File,
        "is text, but no STL, which begins with 'solid': it " +
          (first.empty() ? "is blank" : "begins with " + Quoted(first)));
    }
    this->Odd.AddTo(this->Surface, this->File);
    if (this->Names.size() > 1)
    {
      this->Surface.PolygonAttributes.push_back({ "GroupIds", 1, std::move(this->GroupIds) });
      this->Surface.Names.push_back({ "GroupNames", std::move(this->Names) });
    }
    return std::move(this->Surface);
  }

private:
  /** The next word; `end solid` and the like are one word, comments are skipped; empty at the end.
   */
  std::string_view Next()
  {
    while (this->Scanner.SkipToContent())
    {
      const std::string_view word = this->Scanner.Word();
      if (!IsComment(word))
      {
        return Is(word, "end") ? this->JoinEnd(word) : word;
      }
      this->Odd.Note(this->Scanner, "a comment, which STL does not have, was skipped");
      this->Scanner.SkipLine();
    }
    return {};
  }

  /** After `end`: the tag that it is half of, or `end`. */
  std::string_view JoinEnd(std::string_view end)
  {
    TextScanner ahead(this->Scanner);
    const std::string_view half = ahead.Word();
    for (const char* tag : { "endsolid", "endfacet", "endloop" })
    {
      if (Is(half, tag + end.size()))
      {
        this->Scanner.Word();
        this->Odd.Note(
          this->Scanner, std::string("'end ") + (tag + end.size()) + "' was read as '" + tag + "'");
        return tag;
      }
    }
    return end;
  }

  std::string_view NextOfFacet()
  {
    const std::string_view word = this->Next();
    if (word.empty())
    {
      this->Scanner.Fail("the file ends within a facet: it is truncated");
    }
    return word;
  }

  void Expect(const char* keyword)
  {
    const std::string_view word = this->NextOfFacet();
    if (!Is(word, keyword))
    {
      this->Scanner.Fail(std::string("expected '") + keyword + "', found " + Quoted(word));
    }
  }

  /** Skip the rest of the line after an end tag, up to any of these words. */
  std::string_view NextBehind(const char* tag, std::initializer_list<const char*> known)
  {
    const std::int64_t line = this->Scanner.GetLine();
    const auto isKnown = [&known](std::string_view word)
    {
      return std::any_of(
        known.begin(), known.end(), [word](const char* keyword) { return Is(word, keyword); });
    };
    std::string_view word = this->Next();
    while (!word.empty() && this->Scanner.GetLine() == line && !isKnown(word))
    {
      this->Odd.Note(this->Scanner, std::string("content after '") + tag + "' was skipped");
      word = this->Next();
    }
    return word;
  }

  /** Whether the next words on the line begin a facet. */
  static bool IsAtFacet(TextScanner ahead)
  {
    if (!Is(ahead.Word(), "facet"))
    {
      return false;
    }
    const std::string_view second = ahead.Word();
    return Is(second, "normal") || Is(second, "outer");
  }

  /** The rest of the line, or the words before a facet or the solid's end if all is on one line. */
  std::string ReadName()
  {
    std::string name;
    const auto isAtEnd = [](TextScanner ahead)
    {
      const std::string_view word = ahead.Word();
      return Is(word, "endsolid") || (Is(word, "end") && Is(ahead.Word(), "solid"));
    };
    while (!this->Scanner.AtLineEnd() && !IsAtFacet(this->Scanner) && !isAtEnd(this->Scanner))
    {
      name += name.empty() ? "" : " ";
      name += this->Scanner.Word();
    }
    return ToUtf8(name);
  }

  /** After `endsolid`: the rest of the line, up to the next solid on it. */
  void SkipNameAtEnd()
  {
    TextScanner ahead(this->Scanner);
    while (!ahead.AtLineEnd() && !IsAtFacet(ahead))
    {
      ahead.Word();
    }
    const bool hasFacetBehind = !ahead.AtLineEnd();
    const auto isAtSolid = [](TextScanner next) { return Is(next.Word(), "solid"); };
    while (!this->Scanner.AtLineEnd() && !(hasFacetBehind && isAtSolid(this->Scanner)))
    {
      this->Scanner.Word();
    }
  }

  /** Read facets from this word on, to the end of the solid. @return the next word */
  std::string_view ReadFacets(std::string_view word, const std::string& name)
  {
    const std::size_t before = this->GroupIds.size();
    while (Is(word, "facet"))
    {
      this->ReadFacet();
      word = this->NextBehind("endfacet", { "facet", "endsolid", "solid" });
    }
    if (Is(word, "endsolid"))
    {
      this->SkipNameAtEnd();
      word = this->Next();
    }
    else if (word.empty() || Is(word, "solid"))
    {
      this->Odd.Note(
        this->Scanner, "a solid does not end with 'endsolid': facets of it may be missing");
    }
    else
    {
      this->Scanner.Fail("expected 'facet' or 'endsolid', found " + Quoted(word));
    }
    if (this->GroupIds.size() > before)
    {
      this->Names.push_back(name);
    }
    return word;
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
    const std::string_view word = this->NextBehind("endloop", { "endfacet" });
    if (!Is(word, "endfacet"))
    {
      this->Scanner.Fail(word.empty() ? "the file ends within a facet: it is truncated"
                                      : "expected 'endfacet', found " + Quoted(word));
    }
    CheckCount(this->File, this->Surface.Points.size(), "points");
    ClosePolygon(this->File, this->Surface);
    this->GroupIds.push_back(static_cast<std::int32_t>(this->Names.size()));
  }

  /**
   * The normal follows from the corners; in files it may be missing or invalid. Ends after `outer`.
   */
  void SkipNormal()
  {
    std::string_view word = this->NextOfFacet();
    for (int i = 0; i < 4 && !Is(word, "outer"); ++i)
    {
      word = this->NextOfFacet();
    }
    if (!Is(word, "outer"))
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
    this->Surface.Corners.push_back(static_cast<Id>(this->Surface.Points.size()));
    this->Surface.Points.push_back(point);
  }

  const FileContent& File;
  TextScanner Scanner;
  PolygonSurface Surface;
  Oddities Odd;
  std::vector<std::int32_t> GroupIds;
  std::vector<std::string> Names; ///< names of the solids that have facets
};
} // namespace

bool LooksLikeText(const FileContent& file)
{
  constexpr std::uint64_t looked = 1024; // binary files titled "solid" have other bytes there
  constexpr char endOfFile = '\x1a';     // line ends of old systems
  const char* const end = file.Begin() + std::min<std::uint64_t>(file.Size, looked);
  return std::none_of(file.Begin(), end,
    [](char c)
    {
      const auto byte = static_cast<unsigned char>(c);
      return byte < ' ' && c != endOfFile && !(c >= '\t' && c <= '\r');
    });
}

bool BeginsAsStlText(const FileContent& file, Monitor& monitor)
{
  TextScanner scanner(file, file.TextBegin(), 1, {}, monitor);
  while (scanner.SkipToContent())
  {
    const std::string_view word = scanner.Word();
    if (!IsComment(word))
    {
      return Is(word.substr(0, 5), "solid") || Is(word, "facet");
    }
    scanner.SkipLine();
  }
  return false;
}

PolygonSurface ReadStlText(const FileContent& file, Monitor& monitor)
{
  return StlTextReader(file, monitor).Read();
}
} // namespace insideout
