// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/TextScanner.h"
#include "Support/SurfaceFileReading.h"
#include "Support/SurfaceFileSamples.h"
#include "Support/TestMeshes.h"

#include <cctype>
#include <clocale>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

using namespace insideout;
using namespace surfacefilereading;
using namespace surfacefilesamples;

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
  EXPECT_TRUE(HasWarning(surface, "numbers after some faces were skipped"));
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
    EXPECT_TRUE(HasWarning(longer, "4 bytes after the last triangle were skipped"));
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
