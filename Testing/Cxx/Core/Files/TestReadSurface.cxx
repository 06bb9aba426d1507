// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceFile.h"

#include "Files/TextScanner.h"
#include "Support/SurfaceFileSamples.h"
#include "Support/TemporaryFile.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <clocale>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <random>

using namespace insideout;
using namespace surfacefilesamples;
using testfiles::TemporaryFile;

namespace
{
PolygonSurface Read(const std::string& name, const std::string& content)
{
  const TemporaryFile file(name, content);
  Monitor monitor;
  return ReadSurface(file.Path, monitor);
}

/** The code and message that reading ends with; the message without the file's unique prefix. */
struct Failure
{
  ErrorCode Code;
  std::string Message;
};

Failure FailureOf(const std::string& name, const std::string& content)
{
  const TemporaryFile file(name, content);
  Monitor monitor;
  try
  {
    ReadSurface(file.Path, monitor);
  }
  catch (const Error& error)
  {
    std::string message = error.what();
    const std::size_t at = message.find(file.Name);
    return { error.Code,
      at == 0 ? message.substr(file.Name.size() - name.size()) : "no file name: " + message };
  }
  ADD_FAILURE() << name << " was read";
  return { ErrorCode::Inconsistent, "" };
}

void ExpectMalformed(
  const std::string& name, const std::string& content, const std::string& message)
{
  const Failure failure = FailureOf(name, content);
  EXPECT_EQ(failure.Code, ErrorCode::FileMalformed) << failure.Message;
  EXPECT_EQ(failure.Message, name + message);
}

std::uint64_t Bits(double x)
{
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof(x));
  return bits;
}

void ExpectSamePoints(const std::vector<Point>& points, const std::vector<Point>& expected)
{
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(Bits(points[p][axis]), Bits(expected[p][axis])) << "point " << p;
    }
  }
}

template <typename T>
const std::vector<T>& ValuesOf(
  const std::vector<Attribute>& attributes, const std::string& name, int components)
{
  static const std::vector<T> none;
  for (const Attribute& attribute : attributes)
  {
    if (attribute.Name == name)
    {
      EXPECT_EQ(attribute.Components, components) << name;
      const std::vector<T>* const values = std::get_if<std::vector<T>>(&attribute.Values);
      EXPECT_NE(values, nullptr) << name << " has another type";
      return values ? *values : none;
    }
  }
  ADD_FAILURE() << "no attribute " << name;
  return none;
}

using Words = std::vector<std::string>;

Words NamesOf(const PolygonSurface& surface, const std::string& name)
{
  for (const AttributeNames& names : surface.Names)
  {
    if (names.Name == name)
    {
      return names.Values;
    }
  }
  return {};
}

bool HasAttribute(const std::vector<Attribute>& attributes, const std::string& name)
{
  return std::any_of(attributes.begin(), attributes.end(),
    [&name](const Attribute& attribute) { return attribute.Name == name; });
}

bool HasWarning(const PolygonSurface& surface, const std::string& text)
{
  return std::any_of(surface.Warnings.begin(), surface.Warnings.end(),
    [&text](const std::string& warning) { return warning.find(text) != std::string::npos; });
}
} // namespace

TEST(ReadSurface, ReadsObjCornersOfEveryKind)
{
  for (const char* corners :
    { "f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/2/1 3/3/1 4/4/1",
      "f -4 -3 -2 -1", "f 1 2 \\\n 3 4 # rest", "f 1 2\\\r\n3 4\r" })
  {
    const PolygonSurface surface = Read("a.obj",
      std::string("v 0 0 0\nv 1 0 0 1.0\r\nv 1 1 0\n\tv 0 1 .5\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                  "vn 0 0 1\n") +
        corners + "\n");
    ExpectSamePoints(surface.Points, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0.5 } });
    EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 1, 2, 3 })) << corners;
    EXPECT_EQ(surface.Offsets, (std::vector<Id>{ 0, 4 }));
    EXPECT_TRUE(surface.Warnings.empty()) << corners;
  }
}

TEST(ReadSurface, ReadsObjAttributes)
{
  const PolygonSurface surface = Read("a.obj", SquareObj);
  EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 1, 2, 0, 2, 3 }));
  EXPECT_EQ(surface.Points.size(), 4u);
  EXPECT_EQ(ValuesOf<double>(surface.PointAttributes, "TCoords", 2),
    (std::vector<double>{ 0, 0, 1, 0, 1, 1, 0, 1 }));
  EXPECT_EQ(ValuesOf<double>(surface.PointAttributes, "Normals", 3),
    (std::vector<double>{ 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 }));
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PointAttributes, "Colors", 3),
    (std::vector<unsigned char>{ 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255 }));
  EXPECT_EQ(ValuesOf<std::int32_t>(surface.PolygonAttributes, "GroupIds", 1),
    (std::vector<std::int32_t>{ 0, 0 }));
  EXPECT_EQ(ValuesOf<std::int32_t>(surface.PolygonAttributes, "MaterialIds", 1),
    (std::vector<std::int32_t>{ 0, 1 }));
  EXPECT_EQ(NamesOf(surface, "GroupNames"), Words{ "Thing" });
  EXPECT_EQ(NamesOf(surface, "MaterialNames"), (Words{ "red", "blue" }));
  EXPECT_TRUE(surface.Warnings.empty());
}

TEST(ReadSurface, NumbersObjGroupsByObjectAndGroupInOrderOfUse)
{
  const PolygonSurface surface = Read("a.obj",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\ng unused\nf 1 2 3\no A\ng x\nf 1 2 3\no B\nf 1 2 3\no A\nf 1 2 "
    "3\n");
  EXPECT_EQ(ValuesOf<std::int32_t>(surface.PolygonAttributes, "GroupIds", 1),
    (std::vector<std::int32_t>{ 0, 1, 2, 1 }));
  EXPECT_EQ(NamesOf(surface, "GroupNames"), (Words{ "unused", "A", "B" }));
}

TEST(ReadSurface, CallsObjGroupsByWhatTellsThemApart)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string f = "f 1 2 3\n";
  const auto names = [&](const std::string& text, const char* of = "GroupNames")
  { return NamesOf(Read("a.obj", points + text), of); };
  EXPECT_EQ(names("o part\ng a\n" + f + "g b\n" + f), (Words{ "a", "b" })) << "one object";
  EXPECT_EQ(names("o p\ng a\n" + f + "o q\n" + f), (Words{ "p", "q" })) << "one group";
  EXPECT_EQ(names("o p\ng a\n" + f + "o q\ng b\n" + f), (Words{ "p", "q" })) << "both";
  EXPECT_EQ(names("o p\ng a\n" + f + "g b\n" + f + "o q\n" + f), (Words{ "p/a", "p/b", "q/b" }));
  EXPECT_EQ(names("o p\n" + f + "g a\n" + f), (Words{ "p", "a" })) << "without a group at first";
  EXPECT_EQ(names(f + "g a\n" + f + "o p\n" + f), (Words{ "default", "a", "p" }));
  EXPECT_EQ(
    names(f + "o p\n" + f + "g a\n" + f + "o q\n" + f), (Words{ "default", "p", "p/a", "q/a" }));
  EXPECT_EQ(names("g left  wing # a comment\n" + f), Words{ "left wing" });
  EXPECT_EQ(names("g\n" + f + "usemtl m\n" + f, "GroupNames"), Words{ "default" });
  EXPECT_EQ(names(f + "usemtl m\n" + f, "MaterialNames"), (Words{ "default", "m" }));
  EXPECT_TRUE(Read("a.obj", points + f).Names.empty());
}

TEST(ReadSurface, GivesNamesInUtf8WhateverTheFileHas)
{
  const auto name = [](const std::string& text)
  {
    return NamesOf(
      Read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\ng " + text + "\nf 1 2 3\n"), "GroupNames")
      .at(0);
  };
  for (const char* kept : { "Geh\xC3\xA4use", "\xE2\x82\xAC", "\xF0\x9F\x90\x8D", "\xEE\x80\x80" })
  {
    EXPECT_EQ(name(kept), kept);
  }
  EXPECT_EQ(name("Geh\xE4use"), "Geh\xC3\xA4use") << "Latin-1";
  EXPECT_EQ(name("\xC3"), "\xC3\x83") << "a character that ends too early";
  EXPECT_EQ(name("\xC0\xAF"), "\xC3\x80\xC2\xAF") << "a longer code than need be";
  EXPECT_EQ(name("\xE0\x80\xAF"), "\xC3\xA0\xC2\x80\xC2\xAF") << "the same";
  EXPECT_EQ(name("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80") << "half a character of UTF-16";
  EXPECT_EQ(name("\xF4\x90\x80\x80"), "\xC3\xB4\xC2\x90\xC2\x80\xC2\x80") << "beyond the last";
}

TEST(ReadSurface, CopiesObjPointsThatHaveSeveralTextureCoordinates)
{
  const PolygonSurface surface = Read("a.obj",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nvt 0 0\nvt 1 0\nvt 0 1\nvt 5 5\n"
    "f 1/1 2/2 3/3\nf 1/4 3/3 2/2\nf 2/2 1/4 3/1\n");
  EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 1, 2, 4, 2, 1, 1, 4, 5 }));
  ExpectSamePoints(surface.Points,
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 9, 9, 9 }, { 0, 0, 0 }, { 0, 1, 0 } });
  EXPECT_EQ(ValuesOf<double>(surface.PointAttributes, "TCoords", 2),
    (std::vector<double>{ 0, 0, 1, 0, 0, 1, 0, 0, 5, 5, 0, 0 }));
}

TEST(ReadSurface, PassesOverObjTextureCoordinatesThatAreNotThere)
{
  const PolygonSurface none =
    Read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1/1 2/1/1 3/1/1\nf 1/7/1 3/1/1 2/1/1\n");
  EXPECT_EQ(none.Corners, (std::vector<Id>{ 0, 1, 2, 0, 2, 1 }));
  EXPECT_TRUE(none.PointAttributes.empty());
  EXPECT_EQ(none.Warnings.size(), 2u);
  EXPECT_TRUE(HasWarning(none, "a.obj, line 4: face refers to texture coordinates"));
  EXPECT_TRUE(HasWarning(none, "a.obj, line 4: face refers to normals"));
  const PolygonSurface some =
    Read("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 1 3 2\n");
  EXPECT_TRUE(some.PointAttributes.empty());
  EXPECT_TRUE(HasWarning(some, "texture coordinates were passed over, as 3 corners have none"));
}

TEST(ReadSurface, ReadsObjFacesBeforeTheirPoints)
{
  const PolygonSurface surface =
    Read("a.obj", "f 1/1 2/2 3/3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n");
  EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 1, 2 }));
  EXPECT_TRUE(HasAttribute(surface.PointAttributes, "TCoords"));
}

TEST(ReadSurface, CountsWhatItPassesOverInObj)
{
  const PolygonSurface surface = Read("a.obj",
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nmg 1 0.5\ns off\nl 1 2\np 1\nl 2 3\nf 1 2 3\nf 1 2\nf 3\nxyz 1\n");
  EXPECT_EQ(surface.Offsets, (std::vector<Id>{ 0, 3 }));
  EXPECT_EQ(surface.Warnings.size(), 3u);
  EXPECT_TRUE(HasWarning(surface, "3 lines and points were passed over, the first on line 6: 'l'"));
  EXPECT_TRUE(HasWarning(surface, "2 faces with fewer than 3 corners"));
  EXPECT_TRUE(HasWarning(surface, "1 unknown statements were passed over, the first on line 12"));
}

TEST(ReadSurface, NamesTheLineOfAnIdOutOfRange)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  ExpectMalformed("a.obj", points + "f 1 2 99\n", ", line 4: face refers to point 99 of 3");
  ExpectMalformed("a.obj", "f 1 2 4\n" + points, ", line 1: face refers to point 4 of 3");
  ExpectMalformed("a.obj", points + "\nf 1 2 -4\n", ", line 5: face refers to point -4 of 3");
  ExpectMalformed(
    "a.obj", points + "f 1 2 3000000000\n", ", line 4: face refers to point 3000000000 of 3");
  ExpectMalformed(
    "a.obj", points + "f 0 1 2\n", ", line 4: face refers to point 0, but OBJ counts from 1");
  ExpectMalformed(
    "a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", ", line 6: face refers to point 3 of 3");
  ExpectMalformed("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
    ", line 6: face refers to point -1 of 3");
  ExpectMalformed("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
    "0 0 0\n3 0 0 -2\n",
    ", line 11: face 0 refers to point -2 of 1");
  std::string binary = PlyOfEveryType(1);
  binary[binary.find(Binary(std::uint32_t(2)) + Binary(std::uint32_t(0)))] = 3;
  ExpectMalformed("a.ply", binary, ": face 0 refers to point 3 of 3");
}

TEST(ReadSurface, NamesTheLineOfWhatIsNoNumber)
{
  ExpectMalformed("a.obj", "v 0 0 0\nv 1 x 0\n", ", line 2: expected a number, found 'x'");
  ExpectMalformed(
    "a.obj", "v 0 0\nv 1 0 0\n", ", line 1: expected a number, found the end of the line");
  for (const char* garbage :
    { "1,5", "1d5", "0x10", "--1", "+-1", "++1", "1.5.2", "+", "e5", "1e" })
  {
    ExpectMalformed("a.obj", std::string("v 0 0 ") + garbage + "\n",
      std::string(", line 1: expected a number, found '") + garbage + "'");
  }
  ExpectMalformed("a.obj", "v 0 0 0\nf 1.5 1 1\n", ", line 2: expected a blank, found '.5'");
  ExpectMalformed("a.obj", "v 0 0 0\nf 1/x 1 1\n", ", line 2: expected an integer, found 'x'");
  ExpectMalformed(
    "a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 zero\n", ", line 4: expected an integer, found 'zero'");
  ExpectMalformed("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 o\n",
    ", line 4: expected a number, found 'o'");
  ExpectMalformed("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property uchar z\nend_header\n0 0 256\n",
    ", line 8: a number is not of its type uchar");
}

TEST(ReadSurface, KeepsEveryBitOfADecimalNumber)
{
  std::mt19937_64 random(1);
  std::string text;
  std::vector<Point> expected;
  for (int p = 0; p < 2000; ++p)
  {
    Point point;
    text += "v";
    for (double& x : point)
    {
      do
      {
        const std::uint64_t bits = random();
        std::memcpy(&x, &bits, sizeof(x));
      } while (!std::isfinite(x));
      char digits[40];
      std::snprintf(digits, sizeof(digits), " %.17g", x);
      text += digits;
    }
    text += "\n";
    expected.push_back(point);
  }
  ExpectSamePoints(Read("a.obj", text).Points, expected);
}

TEST(ReadSurface, ReadsNumbersThatDoNotFitADouble)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::string zeros(400, '0');
  const PolygonSurface surface = Read("a.obj",
    "v 1e400 -1e400 1e-400\n"
    "v inf -Infinity -1e-99999999999999999999\n"
    "v 0." +
      zeros + "1 1" + zeros + " +5e99999999999999999999\n" + "v 1" + zeros + "e-100000 0." + zeros +
      "1e100000 4.9e-324\n" + "v 1" + zeros + zeros + "e-400 0." + zeros + zeros + "1e400 1" +
      zeros + "e-400\n");
  ExpectSamePoints(surface.Points,
    { { infinite, -infinite, 0.0 }, { infinite, -infinite, -0.0 }, { 0.0, infinite, infinite },
      { 0.0, infinite, 4.9e-324 }, { infinite, 0.0, 1.0 } });
  EXPECT_TRUE(std::isnan(Read("a.obj", "v nan 0 0\n").Points[0][0]));
}

TEST(ReadSurface, DoesNotDependOnTheLocale)
{
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : { "de_DE.UTF-8", "de_DE", "fr_FR.UTF-8" })
  {
    std::setlocale(LC_ALL, name); // where none is installed, the test still tests the C locale
  }
  const PolygonSurface surface = Read("a.obj", "v 0.5 1e-400 2.25\n");
  std::setlocale(LC_ALL, before.c_str());
  ExpectSamePoints(surface.Points, { { 0.5, 0.0, 2.25 } });
}

TEST(ReadSurface, ReadsEveryLineEnd)
{
  for (const char* end : { "\n", "\r\n", "\r" })
  {
    const auto withEnd = [end](const std::string& text)
    {
      std::string changed;
      for (const char c : text)
      {
        changed += c == '\n' ? std::string(end) : std::string(1, c);
      }
      return changed;
    };
    for (const auto& [name, text] : { std::pair<const char*, const char*>{ "a.obj", SquareObj },
           { "a.off", TetrahedronOff }, { "a.stl", AsciiStl } })
    {
      EXPECT_EQ(Read(name, withEnd(text)).Corners, Read(name, text).Corners) << name;
    }
    EXPECT_EQ(Read("a.ply", withEnd(PlyOfEveryType(0))).Corners, (std::vector<Id>{ 2, 0, 1 }));
    ExpectMalformed(
      "a.obj", withEnd("v 0 0 0\n\nf 1 1 9\n"), ", line 3: face refers to point 9 of 1");
  }
}

TEST(ReadSurface, ReadsOffWithEveryHeader)
{
  const std::string counts = "4 4 6\n";
  const std::string faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  const std::vector<std::string> heads = { "OFF\n" + counts, "OFF 4 4\n", "OFF4 4 6\n", counts,
    "off\n\n4 4\n", "\xEF\xBB\xBFOFF\n" + counts, "# first\nOFF # word\n# numbers\n" + counts };
  for (const std::string& head : heads)
  {
    const PolygonSurface surface = Read("a.off", head + points + faces);
    ExpectSamePoints(surface.Points, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 })) << head;
    EXPECT_EQ(surface.Offsets, (std::vector<Id>{ 0, 3, 6, 9, 12 }));
    EXPECT_TRUE(surface.Warnings.empty()) << head;
  }
}

TEST(ReadSurface, ReadsOffWithoutLines)
{
  std::string text = TetrahedronOff;
  text = "OFF 4 4 6 " + text.substr(text.find("0 0 0"));
  text.erase(text.find('#'), 7);
  std::replace(text.begin(), text.end(), '\n', ' ');
  const PolygonSurface surface = Read("a.off", text);
  EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
  ExpectSamePoints(surface.Points, { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
}

TEST(ReadSurface, ReadsOffAttributes)
{
  const PolygonSurface surface = Read("a.off",
    "STCNOFF\n3 2 0\n0 0 0 0 0 1 1 0 0 0.25 0.75\n1 0 0 0 0 1 0 1 0 0.5 0.5\n"
    "0 1 0 0 0 1 0 0 1 0 1\n3 0 1 2 255 0 0 128\n3 0 2 1 0 255 0 255\n");
  EXPECT_EQ(ValuesOf<double>(surface.PointAttributes, "Normals", 3),
    (std::vector<double>{ 0, 0, 1, 0, 0, 1, 0, 0, 1 }));
  EXPECT_EQ(ValuesOf<double>(surface.PointAttributes, "TCoords", 2),
    (std::vector<double>{ 0.25, 0.75, 0.5, 0.5, 0, 1 }));
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PointAttributes, "Colors", 3),
    (std::vector<unsigned char>{ 255, 0, 0, 0, 255, 0, 0, 0, 255 }));
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PolygonAttributes, "Colors", 4),
    (std::vector<unsigned char>{ 255, 0, 0, 128, 0, 255, 0, 255 }));
}

TEST(ReadSurface, PassesOverOffColorsThatSomeFacesLack)
{
  const PolygonSurface surface = Read("a.off",
    "COFF\n3 3 0\n0 0 0 0.5 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 0 1 2 255 0 0\n3 0 2 1\n2 0 1 9 9 "
    "9\n");
  EXPECT_EQ(surface.Offsets, (std::vector<Id>{ 0, 3, 6 }));
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PointAttributes, "Colors", 3),
    (std::vector<unsigned char>{ 128, 0, 0, 0, 255, 0, 0, 0, 255 }));
  EXPECT_TRUE(surface.PolygonAttributes.empty());
  EXPECT_TRUE(HasWarning(surface, "numbers behind some faces were passed over"));
  EXPECT_TRUE(HasWarning(surface, "1 faces with fewer than 3 corners"));
}

TEST(ReadSurface, RejectsOffThatItCannotRead)
{
  ExpectMalformed("a.off", "OFF BINARY\n1 2", ", line 1: binary OFF is not supported");
  ExpectMalformed(
    "a.off", "4OFF\n1 0 0\n1 2 3 4\n", ", line 1: only points of three coordinates can be read");
  ExpectMalformed("a.off", "OFF\n", ", line 2: the number of points is missing");
  ExpectMalformed("a.off", "OFF\n-1 0 0\n", ", line 2: the number of points is negative");
  ExpectMalformed("a.off", "OFF\n2000000000 4 0\n0 0 0\n",
    ": 2000000000 points announced, at most 1 present: the file is truncated");
  ExpectMalformed("a.off", "OFF\n1 2000000000 0\n0 0 0\n",
    ": 2000000000 faces announced, at most 1 present: the file is truncated");
  ExpectMalformed("a.off", "OFF\n1 1 0\n0 0 0\n2000000000 0 0 0\n",
    ", line 4: face 0 announces 2000000000 corners, which are not there");
  ExpectMalformed("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    ": face 1 of 2 is missing: the file is truncated");
  ExpectMalformed("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0.00000\n",
    ": point 2 of 3 is missing: the file is truncated");
}

TEST(ReadSurface, ReadsPlyOfEveryTypeAndFormatToTheSameBits)
{
  for (int format = 0; format < 3; ++format)
  {
    const PolygonSurface surface = Read("a.ply", PlyOfEveryType(format));
    ExpectSamePoints(surface.Points,
      { { 0.1, 0.0, -1.0 / 3.0 * 0 }, { 1.1, 1e-310, -1.0 / 3.0 }, { 2.1, 2e-310, -2.0 / 3.0 } });
    EXPECT_EQ(surface.Corners, (std::vector<Id>{ 2, 0, 1 }));
    const std::vector<Attribute>& points = surface.PointAttributes;
    EXPECT_EQ(ValuesOf<std::int32_t>(points, "i8", 1), (std::vector<std::int32_t>{ 0, -1, -2 }));
    EXPECT_EQ(ValuesOf<std::int32_t>(points, "u16", 1), std::vector<std::int32_t>(3, 65535));
    EXPECT_EQ(ValuesOf<std::int32_t>(points, "u32", 1), std::vector<std::int32_t>(3, 5));
    EXPECT_EQ(ValuesOf<std::int32_t>(points, "i32", 1),
      std::vector<std::int32_t>(3, std::numeric_limits<std::int32_t>::min()));
    EXPECT_EQ(ValuesOf<float>(points, "quality", 1), std::vector<float>(3, 0.25f));
    EXPECT_EQ(ValuesOf<double>(points, "huge", 1), std::vector<double>(3, 4e9));
    EXPECT_EQ(ValuesOf<std::int32_t>(surface.PolygonAttributes, "s16", 1),
      (std::vector<std::int32_t>{ -300 }));
    EXPECT_EQ(ValuesOf<unsigned char>(surface.PolygonAttributes, "Colors", 3),
      (std::vector<unsigned char>{ 255, 128, 0 }));
    EXPECT_EQ(surface.Warnings.size(), 1u);
    EXPECT_TRUE(HasWarning(surface, "2 elements 'material' were passed over"));
  }
}

TEST(ReadSurface, ReadsPlyAttributesByTheirNames)
{
  const PolygonSurface surface = Read("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
    "z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    "property uchar green\nproperty uchar blue\nproperty uchar alpha\nproperty float texture_u\n"
    "property double texture_v\nproperty list uchar int ring\nelement face 2\n"
    "property list uchar int vertex_indices\nproperty float red\nproperty float green\n"
    "property float blue\nproperty int label\nend_header\n"
    "0.1 0 0 0 0 1 1 2 3 4 0.25 0.5 0\n1 0 0 0 0 1 5 6 7 8 0 0 1 7\n0 1 0 0 0 1 9 10 11 12 1 1 0\n"
    "2 0 1 0 0 0 5\n3 0 1 2 1 0.5 0 6\n");
  EXPECT_EQ(Bits(surface.Points[0][0]), Bits(0.1)); // the decimal text tells more than its type
  EXPECT_EQ(ValuesOf<float>(surface.PointAttributes, "Normals", 3),
    (std::vector<float>{ 0, 0, 1, 0, 0, 1, 0, 0, 1 }));
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PointAttributes, "Colors", 4),
    (std::vector<unsigned char>{ 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 }));
  EXPECT_EQ(ValuesOf<double>(surface.PointAttributes, "TCoords", 2),
    (std::vector<double>{ 0.25, 0.5, 0, 0, 1, 1 }));
  EXPECT_EQ(surface.PointAttributes.size(), 3u);
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PolygonAttributes, "Colors", 3),
    (std::vector<unsigned char>{ 255, 128, 0 }));
  EXPECT_EQ(ValuesOf<std::int32_t>(surface.PolygonAttributes, "label", 1),
    (std::vector<std::int32_t>{ 6 }));
  EXPECT_TRUE(HasWarning(surface, "the lists 'ring' of vertex were passed over"));
  EXPECT_TRUE(HasWarning(surface, "1 faces with fewer than 3 corners"));
}

TEST(ReadSurface, ReadsPlyColorsOfWhichSomeAreBytes)
{
  const PolygonSurface surface = Read("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nproperty float red\nproperty float green\nproperty float blue\n"
    "property uchar alpha\nend_header\n0 0 0 1 0.5 0 255\n1 0 0 0 1 0.2 7\n");
  EXPECT_EQ(ValuesOf<unsigned char>(surface.PointAttributes, "Colors", 4),
    (std::vector<unsigned char>{ 255, 128, 0, 255, 0, 255, 51, 7 }));
}

TEST(ReadSurface, FindsTheBinaryBodyBehindEveryLineEnd)
{
  // The first byte of the body is a line feed, and belongs to it.
  const std::string body = Binary(std::uint8_t(10)) + Binary(1.5) + Binary(2.5) + Binary(3.5);
  for (const char* end : { "\n", "\r\n", "\r" })
  {
    std::string header;
    for (const char* line :
      { "ply", "format binary_little_endian 1.0", "element vertex 1", "property uchar n",
        "property double x", "property double y", "property double z", "end_header" })
    {
      header += std::string(line) + end;
    }
    for (const char* mark : { "", "\xEF\xBB\xBF" })
    {
      const PolygonSurface surface = Read("a.ply", mark + header + body);
      ExpectSamePoints(surface.Points, { { 1.5, 2.5, 3.5 } });
      EXPECT_EQ(ValuesOf<unsigned char>(surface.PointAttributes, "n", 1),
        (std::vector<unsigned char>{ 10 }));
    }
  }
}

TEST(ReadSurface, PassesOverPlyStatementsThatItDoesNotKnow)
{
  const PolygonSurface surface = Read("a.ply",
    "ply\nformat ascii 1.0\nCreated by a program: \nelement vertex 1\nproperty float x\n"
    "property float y\nproperty float z\nversion 2\nend_header\n1 2 3\n");
  ExpectSamePoints(surface.Points, { { 1, 2, 3 } });
  EXPECT_TRUE(HasWarning(surface,
    "a.ply: 2 unknown statements were passed over in the header, the first on line 3: 'Created'"));
}

TEST(ReadSurface, TakesPlyTriangleStripsApart)
{
  const auto read = [](const std::string& elements, const std::string& body)
  {
    return Read("a.ply",
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\n" +
        elements + "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n" + body);
  };
  const std::string strips = "element tristrips 2\nproperty list int int vertex_indices\n";
  const PolygonSurface surface = read(strips, "9 0 1 2 3 4 -1 1 0 2\n5 4 4 3 2 1\n");
  EXPECT_EQ(
    surface.Corners, (std::vector<Id>{ 0, 1, 2, 2, 1, 3, 2, 3, 4, 1, 0, 2, 3, 4, 2, 3, 2, 1 }));
  EXPECT_EQ(surface.Offsets, (std::vector<Id>{ 0, 3, 6, 9, 12, 15, 18 }));
  EXPECT_TRUE(surface.Warnings.empty());

  const PolygonSurface none =
    read("element face 0\nproperty list uchar int vertex_indices\nproperty uchar mark\n" + strips,
      "3 0 1 2\n3 2 1 3\n");
  EXPECT_EQ(none.Corners, (std::vector<Id>{ 0, 1, 2, 2, 1, 3 }));
  EXPECT_TRUE(none.PolygonAttributes.empty()); // of 0 faces: no values for the triangles

  const PolygonSurface both =
    read("element face 1\nproperty list uchar int vertex_indices\n" + strips,
      "3 0 1 2\n3 0 1 2\n3 2 1 3\n");
  EXPECT_EQ(both.Corners, (std::vector<Id>{ 0, 1, 2 }));
  EXPECT_TRUE(HasWarning(both, "2 elements 'tristrips' were passed over"));

  ExpectMalformed("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\n" +
      strips + "end_header\n0 0 0\n3 0 1 -2\n0\n",
    ", line 11: tristrips 0 refers to point 1 of 1");
}

TEST(ReadSurface, RejectsPlyHeadersThatSayNothing)
{
  const std::string begin = "ply\nformat ascii 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  ExpectMalformed("a.ply", "plu\n", ", line 1: does not begin with 'ply'");
  ExpectMalformed("a.ply", "ply\nformat ebcdic 1.0\n", ", line 2: unknown format 'ebcdic'");
  ExpectMalformed("a.ply", begin, ", line 3: the header has no end_header");
  ExpectMalformed("a.ply", begin + "elephant\n", ", line 4: the header has no end_header");
  ExpectMalformed(
    "a.ply", begin + "element vertex -1\n", ", line 3: the number of elements is negative");
  ExpectMalformed("a.ply", begin + "element vertex 99999999999999999999\n",
    ", line 3: expected an integer, found '99999999999999999999'");
  ExpectMalformed(
    "a.ply", begin + "property float x\n", ", line 3: a property comes before the first element");
  ExpectMalformed(
    "a.ply", begin + "element vertex 1\nproperty quad x\n", ", line 4: unknown type 'quad'");
  ExpectMalformed("a.ply", begin + "element vertex 1\nproperty float x\nproperty float x\n",
    ", line 5: property 'x' has no name, or another's");
  ExpectMalformed("a.ply", begin + "element vertex 1\nelement vertex 1\n",
    ", line 4: element 'vertex' has no name, or another's");
  ExpectMalformed("a.ply", begin + "end_header\n", ": the header has no element vertex");
  ExpectMalformed("a.ply", begin + "element vertex 1\nproperty float x\nend_header\n",
    ": vertices have no number y");
  ExpectMalformed(
    "a.ply", "ply\nelement vertex 1\n" + xyz + "end_header\n", ": the header names no format");
  ExpectMalformed("a.ply",
    begin + "element vertex 0\n" + xyz + "element face 1\nproperty int a\nend_header\n7\n",
    ": faces have no list vertex_indices");
}

TEST(ReadSurface, RejectsPlyFacesWithoutProperties)
{
  ExpectMalformed("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nend_header\n0 0 0\n\n",
    ": faces have no list vertex_indices");
}

TEST(ReadSurface, RejectsPlyFacesOfPointsThatNoIdCounts)
{
  const Failure failure = FailureOf("a.ply",
    "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar uint vertex_indices\n"
    "element vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\n"
    "end_header\n3 0 1 3000000000\n0 0 0\n");
  EXPECT_EQ(failure.Code, ErrorCode::TooLarge);
  EXPECT_EQ(failure.Message, "a.ply: has more than 2147483647 points");
}

TEST(ReadSurface, WarnsOfNoListsOfPlyFacesThatAreNotThere)
{
  const PolygonSurface surface = Read("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
    "property float z\nelement face 0\nproperty list uchar int vertex_indices\n"
    "property list uchar float texcoord\nend_header\n1 2 3\n");
  ExpectSamePoints(surface.Points, { { 1, 2, 3 } });
  EXPECT_TRUE(surface.Warnings.empty());
}

TEST(ReadSurface, NamesTheFirstPlyElementThatIsMissing)
{
  const std::string little = "ply\nformat binary_little_endian 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 2\nproperty list int int vertex_indices\nend_header\n";
  ExpectMalformed("a.ply",
    little + "element vertex 1000\n" + xyz + "end_header\n" + std::string(812 * 12 + 5, 'a'),
    ": vertex 812 of 1000 is missing: the file is truncated");
  ExpectMalformed("a.ply", little + "element vertex 2000000000\n" + xyz + "end_header\n",
    ": vertex 0 of 2000000000 is missing: the file is truncated");
  for (const char* body : { "", "0 0 0\n" })
  {
    ExpectMalformed("a.ply",
      "ply\nformat ascii 1.0\nelement vertex 4000000000000000000\n" + xyz + "end_header\n" + body,
      std::string(": vertex ") + (*body ? "1" : "0") +
        " of 4000000000000000000 is missing: the file is truncated");
  }
  const std::string triangle = little + "element vertex 1\n" + xyz + faces + std::string(12, '\0') +
    Binary(3) + Binary(0) + Binary(0) + Binary(0);
  ExpectMalformed("a.ply", triangle + "a", ": face 1 of 2 is missing: the file is truncated");
  ExpectMalformed("a.ply", triangle + Binary(2000000000),
    ": face 1 announces a list of 2000000000 numbers that are not there: the file is truncated or "
    "damaged");
  ExpectMalformed(
    "a.ply", triangle + Binary(-1), ": face 1 announces a list of negative or fractional length");
  ExpectMalformed("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\n" + xyz +
      "end_header\n0 0 0.000000\n1 0 0.0000\n1 0\n",
    ": vertex 2 of 3 is missing: the file is truncated");
}

TEST(ReadSurface, RefusesPlyWhoseCountsAreWrongWhereEveryNumberIsShifted)
{
  const std::string rows = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  ExpectMalformed("a.ply",
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
      rows,
    ", line 17: more follows than the header describes: one of its counts is wrong");
}

TEST(ReadSurface, WarnsOfWhatFollowsThePlyElements)
{
  EXPECT_TRUE(HasWarning(Read("a.ply", PlyOfEveryType(1) + "x"), "more was in the file"));
  EXPECT_TRUE(HasWarning(Read("a.ply", PlyOfEveryType(0) + "x"), "more was in the file"));
  const PolygonSurface extras = Read("a.ply",
    "ply \nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n1 2 3 4 5\n6 7 8\n");
  ExpectSamePoints(extras.Points, { { 1, 2, 3 }, { 6, 7, 8 } });
  EXPECT_TRUE(HasWarning(extras, "more was in the file"));
}

TEST(ReadSurface, ReadsBinaryStlWhateverItsTitle)
{
  for (const char* title : { "", "solid", "solid name\nfacet normal" })
  {
    const PolygonSurface surface = Read("a.stl", BinaryStl(title));
    ASSERT_EQ(surface.Points.size(), 36u);
    EXPECT_EQ(surface.Offsets.size(), 13u);
    EXPECT_EQ(surface.Corners[35], 35);
    ExpectSamePoints({ surface.Points[4] }, { { 1, 2, 0 } });
    EXPECT_EQ(Bits(surface.Points[6][2]), Bits(double(0.1f)));
    EXPECT_TRUE(surface.Warnings.empty());
    const PolygonSurface longer = Read("a.stl", BinaryStl(title) + "tail");
    ExpectSamePoints(longer.Points, surface.Points);
    EXPECT_TRUE(HasWarning(longer, "4 bytes behind the last triangle were passed over"));
    ExpectMalformed(
      "a.stl", BinaryStl(title).substr(0, 84 + 5 * 50 + 49), ": 12 triangles announced, 5 present");
  }
}

TEST(ReadSurface, ReadsAsciiStlOfSeveralSolids)
{
  const PolygonSurface surface = Read("a.stl", AsciiStl);
  ExpectSamePoints(surface.Points,
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0.15, -0.5 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0.1 } });
  EXPECT_EQ(surface.Corners, (std::vector<Id>{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(ValuesOf<std::int32_t>(surface.PolygonAttributes, "GroupIds", 1),
    (std::vector<std::int32_t>{ 0, 1 }));
  EXPECT_EQ(NamesOf(surface, "GroupNames"), (Words{ "a name of facet", "" }));
  const std::string text = AsciiStl;
  EXPECT_EQ(NamesOf(Read("a.stl", "solid empty\nendsolid\n" + text + text), "GroupNames"),
    (Words{ "a name of facet", "", "a name of facet", "" }));
  EXPECT_EQ(ValuesOf<std::int32_t>(
              Read("a.stl", "solid empty\nendsolid\n" + text).PolygonAttributes, "GroupIds", 1),
    (std::vector<std::int32_t>{ 0, 1 }));
  const PolygonSurface alone = Read("a.stl", text.substr(0, text.find("SOLID")));
  EXPECT_TRUE(alone.PolygonAttributes.empty());
  EXPECT_TRUE(alone.Names.empty()) << "of one solid the name is a title";
}

TEST(ReadSurface, NamesTheLineWhereAsciiStlGoesWrong)
{
  const std::string text = AsciiStl;
  ExpectMalformed("a.stl", text.substr(0, text.find("ENDFACET")),
    ", line 17: the file ends within a facet: it is truncated");
  ExpectMalformed("a.stl", text.substr(0, text.find("VERTEX 0 1")),
    ", line 15: the file ends within a facet: it is truncated");
  ExpectMalformed("a.stl", text.substr(0, text.find("vertex 1E0")) + "endloop",
    ", line 5: expected 'vertex', found 'endloop'");
  ExpectMalformed(
    "a.stl", "solid\nsurface\n", ", line 2: expected 'facet' or 'endsolid', found 'surface'");
  ExpectMalformed(
    "a.stl", "solid\nfacet normal 1 2 3 4 outer\n", ", line 2: expected 'outer', found '4'");
  ExpectMalformed("a.stl", std::string("sol\0", 4),
    ": is neither ascii STL, which begins with 'solid', nor has the 84 "
    "bytes that binary STL begins with");
}

TEST(ReadSurface, TellsFormatsByContentBeforeEnding)
{
  EXPECT_EQ(Read("a.dat", TetrahedronOff).Offsets.size(), 5u);
  EXPECT_EQ(Read("a.obj", PlyOfEveryType(2)).Offsets.size(), 2u);
  EXPECT_EQ(Read("a", AsciiStl).Offsets.size(), 3u);
  EXPECT_EQ(Read("a.ply.bak", BinaryStl("")).Offsets.size(), 13u);
  EXPECT_EQ(Read("a.OBJ", SquareObj).Offsets.size(), 3u);
  EXPECT_EQ(Read("a.dat", SquareObj).Offsets.size(), 3u);
  ExpectMalformed("a.dat", "v words", ": neither content nor ending is of .ply .off .stl .obj");
  ExpectMalformed("a.dat", "<VTKFile", ": is an XML file; vtkXMLPolyDataReader reads those of VTK");
  ExpectMalformed("a.obj", "<html>\n", ": holds no point or face of OBJ; line 1: '<html>'");
}

TEST(ReadSurface, WarnsOfNamesThatSayAnotherFormat)
{
  const std::pair<const char*, std::string> formats[] = { { "PLY", PlyOfEveryType(2) },
    { "OFF", TetrahedronOff }, { "STL", AsciiStl }, { "STL", BinaryStl("") },
    { "OBJ", std::string("# of ours\nmtllib a.mtl\no name\n") + SquareObj } };
  for (const char* name :
    { "a.ply", "a.off", "a.stl", "a.obj", "a.vtp", "a.PLY", "a.Off", "a.txt" })
  {
    for (const auto& [format, content] : formats)
    {
      const std::string ending = std::filesystem::path(name).extension().string();
      std::string lower = "." + std::string(format);
      std::transform(lower.begin(), lower.end(), lower.begin(), ::tolower);
      const bool same = EqualsIgnoringCase(ending, lower) || ending == ".txt";
      const TemporaryFile file(name, content);
      Monitor monitor;
      const PolygonSurface surface = ReadSurface(file.Path, monitor);
      EXPECT_GT(surface.Offsets.size(), 1u);
      const std::string warning =
        file.Name + ": holds " + format + ", not what its name says, and was read as such";
      const auto found = std::count(surface.Warnings.begin(), surface.Warnings.end(), warning);
      EXPECT_EQ(found, same ? 0 : 1) << name << " " << format;
    }
  }
}

TEST(ReadSurface, NamesFilesThatItCannotOpen)
{
  Monitor monitor;
  const TemporaryFile missing("missing.obj");
  for (const auto& [path, reason] :
    { std::pair<std::string, std::string>{ missing.Path, "No such file or directory" },
      { testing::TempDir(), "is a directory" }, { "/dev/null", "is not a regular file" } })
  {
    try
    {
      ReadSurface(path, monitor);
      ADD_FAILURE() << path << " was read";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::FileUnreadable);
      EXPECT_EQ(error.what(), path + ": " + reason);
    }
  }
  for (const char* name : { "a.obj", "a.off", "a.ply", "a.stl", "a" })
  {
    ExpectMalformed(name, "", ": is empty");
  }
}

TEST(ReadSurface, SaysWhenAFileDoesNotFitIntoMemory)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer ends the program where memory is refused";
#endif
  struct Stopper : Monitor
  {
    int Left = 4;
    bool Continue(const char*, double) override { return this->Left-- > 0; }
  };
  const TemporaryFile file("a.stl", BinaryStl(""));
  std::error_code error;
  std::filesystem::resize_file(file.Path, std::uintmax_t(1) << 43, error);
  if (error)
  {
    GTEST_SKIP() << "the file system has no sparse files of 8 TiB: " << error.message();
  }
  Stopper monitor;
  try
  {
    ReadSurface(file.Path, monitor);
    ADD_FAILURE() << "was read";
  }
  catch (const Error& caught)
  {
    if (caught.Code == ErrorCode::Stopped)
    {
      GTEST_SKIP() << "the system promises 8 TiB of memory";
    }
    EXPECT_EQ(caught.Code, ErrorCode::TooLarge);
    EXPECT_EQ(caught.what(), file.Path + ": does not fit into memory");
  }
}

TEST(ReadSurface, StopsWhereverTheMonitorAsks)
{
  struct Stopper : Monitor
  {
    int Left = 0;
    int Calls = 0;
    double Last = 0.0;
    bool Continue(const char* stage, double fraction) override
    {
      EXPECT_STREQ(stage, "reading");
      EXPECT_GE(fraction, this->Last);
      EXPECT_LE(fraction, 1.0);
      this->Last = fraction;
      ++this->Calls;
      return this->Left-- > 0;
    }
  };
  std::string text;
  for (int p = 0; p < 100000; ++p)
  {
    text += "v 0 0 " + std::to_string(p) + "\n";
  }
  const TemporaryFile file("a.obj", text);
  Stopper whole;
  whole.Left = 1000;
  EXPECT_EQ(ReadSurface(file.Path, whole).Points.size(), 100000u);
  EXPECT_EQ(whole.Last, 1.0);
  ASSERT_GE(whole.Calls, 4);
  for (int calls = 0; calls < whole.Calls; ++calls)
  {
    Stopper stopper;
    stopper.Left = calls;
    try
    {
      ReadSurface(file.Path, stopper);
      ADD_FAILURE() << "not stopped by call " << calls;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
  }
}
