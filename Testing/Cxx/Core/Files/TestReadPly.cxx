// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/SurfaceFileReading.h"
#include "Support/SurfaceFileSamples.h"

using namespace insideout;
using namespace surfacefilereading;
using namespace surfacefilesamples;

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
    EXPECT_TRUE(HasWarning(surface, "2 elements 'material' were skipped"));
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
  EXPECT_TRUE(HasWarning(surface, "the lists 'ring' of vertex were skipped"));
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
    "a.ply: 2 unknown statements were skipped in the header, the first on line 3: 'Created'"));
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
  EXPECT_TRUE(HasWarning(both, "2 elements 'tristrips' were skipped"));

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
