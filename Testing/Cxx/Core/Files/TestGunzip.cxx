// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/Gunzip.h"

#include "Support/SurfaceFileSamples.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <zlib.h>

using namespace insideout;
using namespace surfacefilesamples;
using testfiles::TemporaryFile;

namespace
{
std::string Compressed(const std::string& text)
{
  constexpr int gzip = 15 + 16;
  z_stream stream = {};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip, 8, Z_DEFAULT_STRATEGY);
  std::string compressed(deflateBound(&stream, text.size()) + 100, '\0');
  std::string source = text;
  stream.next_in = reinterpret_cast<Bytef*>(source.data());
  stream.avail_in = static_cast<uInt>(source.size());
  stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
  stream.avail_out = static_cast<uInt>(compressed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  compressed.resize(stream.total_out);
  deflateEnd(&stream);
  return compressed;
}

PolygonSurface Read(const std::string& name, const std::string& content)
{
  const TemporaryFile file(name, content);
  Monitor monitor;
  return ReadSurface(file.Path, monitor);
}

void ExpectFailure(const std::string& content, const std::string& part)
{
  const TemporaryFile file("a.off.gz", content);
  Monitor monitor;
  try
  {
    ReadSurface(file.Path, monitor);
    ADD_FAILURE() << "was read";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::FileMalformed) << error.what();
    EXPECT_EQ(std::string(error.what()).find(file.Name), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

FileContent InMemory(const std::string& bytes)
{
  FileContent file;
  file.Name = "a.gz";
  file.Bytes.reset(new char[bytes.size()]);
  std::copy(bytes.begin(), bytes.end(), file.Bytes.get());
  file.Size = bytes.size();
  return file;
}
} // namespace

TEST(Gunzip, ReadsEveryFormat)
{
  const std::pair<const char*, std::string> files[] = { { "a.ply.gz", PlyOfEveryType(2) },
    { "a.off.gz", TetrahedronOff }, { "a.stl.gz", AsciiStl }, { "A.STL.GZ", BinaryStl("") },
    { "a.obj.gz", SquareObj }, { "a.obj.Gz", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n" } };
  for (const auto& [name, content] : files)
  {
    const std::string plain(name, std::string(name).size() - 3);
    const PolygonSurface surface = Read(name, Compressed(content));
    const PolygonSurface expected = Read(plain, content);
    EXPECT_EQ(surface.Points, expected.Points) << name;
    EXPECT_EQ(surface.Corners, expected.Corners) << name;
    EXPECT_EQ(surface.Warnings.size(), expected.Warnings.size()) << name;
  }
}

TEST(Gunzip, ReadsAllMembersAndTheZerosOfTapes)
{
  const std::string text = TetrahedronOff;
  const std::string members = Compressed(text.substr(0, 20)) + Compressed("") +
    Compressed(text.substr(20)) + std::string(1000, '\0');
  EXPECT_EQ(Read("a.off.gz", members).Offsets.size(), 5u);
}

TEST(Gunzip, WarnsOfNamesThatSayOtherwise)
{
  const PolygonSurface compressed = Read("a.off", Compressed(TetrahedronOff));
  ASSERT_EQ(compressed.Warnings.size(), 1u);
  EXPECT_NE(compressed.Warnings[0].find("its name does not end in .gz"), std::string::npos);
  const PolygonSurface plain = Read("a.off.gz", TetrahedronOff);
  ASSERT_EQ(plain.Warnings.size(), 1u);
  EXPECT_NE(plain.Warnings[0].find("is not compressed"), std::string::npos);
}

TEST(Gunzip, SaysWhatIsMissingOrDamaged)
{
  const std::string whole = Compressed(TetrahedronOff);
  for (std::size_t length = 2; length < whole.size(); ++length)
  {
    ExpectFailure(whole.substr(0, length), "is compressed with gzip, and its end is missing");
  }
  for (const std::size_t at : { whole.size() - 8, whole.size() - 1, whole.size() / 2 })
  {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(~damaged[at]);
    ExpectFailure(damaged, "is compressed with gzip, and ");
  }
  ExpectFailure(whole + "more", "4 bytes after the compressed content are ignored");
  ExpectFailure(Compressed(""), "is empty");
}

TEST(Gunzip, TakesNoMemoryForMoreThanItMayHold)
{
  const FileContent bomb = InMemory(Compressed(std::string(50000000, '\0')));
  EXPECT_LT(bomb.Size, 60000u);
  Monitor monitor;
  EXPECT_EQ(Gunzip(bomb, 50000000, monitor).Size, 50000000u);
  try
  {
    Gunzip(bomb, 49999999, monitor);
    ADD_FAILURE() << "was decompressed";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::TooLarge);
    EXPECT_NE(std::string(error.what()).find("holds more than 49999999 bytes"), std::string::npos);
  }
}
