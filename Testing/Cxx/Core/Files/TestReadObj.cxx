// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/SurfaceFileReading.h"
#include "Support/SurfaceFileSamples.h"

using namespace insideout;
using namespace surfacefilereading;
using namespace surfacefilesamples;

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
  EXPECT_TRUE(HasWarning(some, "texture coordinates were skipped, because 3 corners have none"));
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
  EXPECT_TRUE(HasWarning(surface, "3 lines and points were skipped, the first on line 6: 'l'"));
  EXPECT_TRUE(HasWarning(surface, "2 faces with fewer than 3 corners"));
  EXPECT_TRUE(HasWarning(surface, "1 unknown statements were skipped, the first on line 12"));
}
