// SPDX-License-Identifier: GPL-3.0-or-later
// STL as other programs write it: what is odd is read, and a warning says what it was.
#include "Files/SurfaceFile.h"

#include "Support/SurfaceFileSamples.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

using namespace insideout;
using namespace surfacefilesamples;
using testfiles::TemporaryFile;

namespace
{
const std::string Plain = "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                          "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
                          "facet normal 0 0 1\nouter loop\nvertex 1 0 0\n"
                          "vertex 1 1 0\nvertex 0 1 0.5\nendloop\nendfacet\nendsolid part\n";

PolygonSurface Read(const std::string& content)
{
  const TemporaryFile file("a.stl", content);
  Monitor monitor;
  PolygonSurface surface = ReadSurface(file.Path, monitor);
  for (std::string& warning : surface.Warnings)
  {
    EXPECT_EQ(warning.find(file.Name), 0u) << warning;
    warning = warning.substr(file.Name.size());
  }
  return surface;
}

std::string ErrorOf(const std::string& content)
{
  const TemporaryFile file("a.stl", content);
  Monitor monitor;
  try
  {
    ReadSurface(file.Path, monitor);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::FileMalformed);
    const std::string message = error.what();
    EXPECT_EQ(message.find(file.Name), 0u) << message;
    return message.substr(file.Name.size());
  }
  ADD_FAILURE() << content << " was read";
  return {};
}

std::string Replaced(std::string text, const std::string& before, const std::string& after)
{
  for (std::size_t at = 0; (at = text.find(before, at)) != std::string::npos; at += after.size())
  {
    text.replace(at, before.size(), after);
  }
  return text;
}

/** The file is the plain one but for what the warnings say. */
void ExpectPlain(const std::string& content, const std::vector<std::string>& warnings)
{
  const PolygonSurface surface = Read(content);
  EXPECT_EQ(surface.Points, Read(Plain).Points) << content;
  EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 1, 2, 3, 4, 5 })) << content;
  EXPECT_EQ(surface.Warnings, warnings) << content;
}

std::vector<std::string> NamesOf(const PolygonSurface& surface)
{
  return surface.Names.empty() ? std::vector<std::string>() : surface.Names[0].Values;
}

/** The spare bytes of the facets of a binary file. */
std::string WithSpareBytes(std::string binary, const std::vector<std::uint16_t>& bits)
{
  for (std::size_t facet = 0; facet < bits.size(); ++facet)
  {
    binary.replace(84 + 50 * facet + 48, 2, Binary(bits[facet]));
  }
  return binary;
}
} // namespace

TEST(StlOfOthers, HasAnyWhitespaceAndCase)
{
  ExpectPlain(Plain, {});
  ExpectPlain(Replaced(Plain, "\n", "\r\n"), {});
  ExpectPlain(Replaced(Plain, "\n", "\r"), {});
  ExpectPlain(Replaced(Plain, "\n", "\n\n  \t"), {});
  ExpectPlain(Replaced(Plain, " ", "\t \v\f"), {});
  ExpectPlain("\xEF\xBB\xBF" + Plain, {});
  std::string upper = Plain;
  std::transform(upper.begin(), upper.end(), upper.begin(), ::toupper);
  ExpectPlain(upper, {});
  ExpectPlain(Replaced(Plain, "1 1 0", "+1.0E+000 1.e0 -0.0e-5"), {});
  ExpectPlain(Plain.substr(0, Plain.size() - 1), {});
}

TEST(StlOfOthers, StandsOnOneLine)
{
  ExpectPlain(Replaced(Plain, "\n", " "), {});
  const std::string two = Replaced(Plain + Replaced(Plain, "part", "a solid piece"), "\n", " ");
  const PolygonSurface surface = Read(two);
  EXPECT_EQ(surface.Offsets.size(), 5u);
  EXPECT_EQ(NamesOf(surface), (std::vector<std::string>{ "part", "a solid piece" }));
  EXPECT_TRUE(surface.Warnings.empty());
  EXPECT_EQ(Read("solid nothing endsolid nothing solid nothing end solid").Offsets.size(), 1u);
}

TEST(StlOfOthers, PartsEndTagsInTwo)
{
  ExpectPlain(
    Replaced(Plain, "endsolid", "end solid"), { ", line 16: 'end solid' was read as 'endsolid'" });
  ExpectPlain(Replaced(Replaced(Plain, "endloop", "end loop"), "endfacet", "END FACET"),
    { ", line 7: 'end loop' was read as 'endloop' (2 times)",
      ", line 8: 'end facet' was read as 'endfacet' (2 times)" });
}

TEST(StlOfOthers, HasWordsBehindEndTags)
{
  ExpectPlain(Replaced(Plain, "endfacet", "endfacet 17 of red"),
    { ", line 8: content after 'endfacet' was skipped (6 times)" });
  ExpectPlain(Replaced(Plain, "endloop", "endloop normal"),
    { ", line 7: content after 'endloop' was skipped (2 times)" });
  ExpectPlain(
    Plain + "that was all\n\x1a", { ", line 17: text outside of any solid was skipped (2 times)" });
  ExpectPlain("made by me\n" + Plain, { ", line 1: text outside of any solid was skipped" });
}

TEST(StlOfOthers, HasComments)
{
  const std::string comment = "a comment, which STL does not have, was skipped";
  for (const char* mark : { "#", "# ", "// ", ";", "!" })
  {
    ExpectPlain(mark + std::string("made by me\n") + Plain, { ", line 1: " + comment });
  }
  ExpectPlain(
    Replaced(Plain, "outer", "# from here\nouter"), { ", line 3: " + comment + " (2 times)" });
  const PolygonSurface surface = Read(Replaced(Plain, "part", "part #3") + Plain);
  EXPECT_EQ(NamesOf(surface), (std::vector<std::string>{ "part #3", "part" }));
  EXPECT_TRUE(surface.Warnings.empty());
}

TEST(StlOfOthers, LacksTagsOfSolids)
{
  const std::string open = Plain.substr(0, Plain.find("endsolid"));
  const std::string missing = "a solid does not end with 'endsolid': facets of it may be missing";
  ExpectPlain(open, { ", line 16: " + missing });
  const PolygonSurface two = Read(open + Plain);
  EXPECT_EQ(two.Offsets.size(), 5u);
  EXPECT_EQ(NamesOf(two).size(), 2u);
  EXPECT_EQ(two.Warnings, (std::vector<std::string>{ ", line 16: " + missing }));
  ExpectPlain(
    Plain.substr(Plain.find("facet")), { ", line 1: a facet outside of any solid was read" });
}

TEST(StlOfOthers, CountsTooFewTriangles)
{
  const std::string binary = BinaryStl("of others");
  const PolygonSurface whole = Read(binary);
  for (const std::uint32_t count : { 0u, 1u, 11u })
  {
    std::string wrong = binary;
    wrong.replace(80, 4, Binary(count));
    const PolygonSurface surface = Read(wrong);
    EXPECT_EQ(surface.Points, whole.Points);
    EXPECT_EQ(surface.Warnings,
      (std::vector<std::string>{
        ": " + std::to_string(count) + " triangles announced, 12 present, and all were read" }));
  }
  std::string none = binary + "tail";
  none.replace(80, 4, Binary(0u));
  EXPECT_EQ(Read(none).Points, whole.Points);
  EXPECT_EQ(Read(none).Warnings.size(), 2u) << "the tail is no triangle";
  const std::string zeros(100, '\0');
  EXPECT_EQ(Read(binary + zeros).Points, whole.Points)
    << "zeros fill a block, and are no triangles";
  EXPECT_EQ(Read(binary + zeros).Warnings,
    (std::vector<std::string>{ ": 100 bytes after the last triangle were skipped" }));
}

TEST(StlOfOthers, HasColorsInSpareBytes)
{
  const auto colors = [](const PolygonSurface& surface)
  {
    const bool any = !surface.PolygonAttributes.empty();
    EXPECT_TRUE(!any || surface.PolygonAttributes[0].Name == "Colors");
    return any ? std::get<std::vector<unsigned char>>(surface.PolygonAttributes[0].Values)
               : std::vector<unsigned char>();
  };
  std::vector<std::uint16_t> bits(12, 0x8000 | 31 << 10); // red, as VisCAM has it
  bits[1] = 0x8000 | 31;
  std::vector<unsigned char> found = colors(Read(WithSpareBytes(BinaryStl("x"), bits)));
  ASSERT_EQ(found.size(), 36u);
  EXPECT_EQ(std::vector<unsigned char>(found.begin(), found.begin() + 6),
    (std::vector<unsigned char>{ 255, 0, 0, 0, 0, 255 }));

  bits[2] = 31;
  const PolygonSurface some = Read(WithSpareBytes(BinaryStl("x"), bits));
  EXPECT_TRUE(colors(some).empty());
  EXPECT_EQ(some.Warnings,
    (std::vector<std::string>{
      ": colors of 11 of 12 triangles were skipped, because the others have none" }));

  found = colors(Read(WithSpareBytes(BinaryStl("by Magics COLOR=\x01\x02\x03\x04"), bits)));
  ASSERT_EQ(found.size(), 36u);
  EXPECT_EQ(std::vector<unsigned char>(found.begin() + 3, found.begin() + 9),
    (std::vector<unsigned char>{ 1, 2, 3, 255, 0, 0 }));
}

TEST(StlOfOthers, IsNamedForWhatItIsInstead)
{
  EXPECT_EQ(ErrorOf("Dear reader,\nthis is a letter.\n"),
    ": is text, but no STL, which begins with 'solid': it begins with 'Dear'");
  EXPECT_EQ(ErrorOf("<!DOCTYPE html>\n<p>404\n"),
    ": is text, but no STL, which begins with 'solid': it begins with '<!DOCTYPE'");
  EXPECT_EQ(
    ErrorOf(std::string("\xFF\xFEs\0o\0l\0i\0d\0", 12)), ": is text in UTF-16; save it in UTF-8");
  EXPECT_EQ(ErrorOf(" \n"), ": is text, but no STL, which begins with 'solid': it is blank");
}
