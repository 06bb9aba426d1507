// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SurfaceFile.h"

#include "Support/MutatedText.h"
#include "Support/SurfaceFileSamples.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <random>

using namespace insideout;
using namespace surfacefilesamples;
using testfiles::Mutated;
using testfiles::TemporaryFile;

namespace
{
void ExpectIdsInRange(const PolygonSurface& surface)
{
  ASSERT_FALSE(surface.Offsets.empty());
  EXPECT_EQ(surface.Offsets.front(), 0);
  EXPECT_EQ(static_cast<std::size_t>(surface.Offsets.back()), surface.Corners.size());
  for (std::size_t p = 0; p + 1 < surface.Offsets.size(); ++p)
  {
    EXPECT_GE(surface.Offsets[p + 1] - surface.Offsets[p], 3);
  }
  for (const Id corner : surface.Corners)
  {
    EXPECT_GE(corner, 0);
    EXPECT_LT(static_cast<std::size_t>(corner), surface.Points.size());
  }
}

void ExpectAttributesComplete(const std::vector<Attribute>& attributes, std::size_t count)
{
  for (const Attribute& attribute : attributes)
  {
    const std::size_t length =
      std::visit([](const auto& values) { return values.size(); }, attribute.Values);
    EXPECT_EQ(length, count * static_cast<std::size_t>(attribute.Components)) << attribute.Name;
  }
}
} // namespace

TEST(DamagedSurfaceFiles, AreAValidSurfaceOrAnError)
{
  const std::string coff = "STCNOFF\n3 2 0\n0 0 0 0 0 1 1 0 0 0.25 0.75\n"
                           "1 0 0 0 0 1 0 1 0 0.5 0.5\n0 1 0 0 0 1 0 0 1 0 1\n"
                           "3 0 1 2 255 0 0 128\n3 0 2 1 0 255 0 255\n";
  const std::vector<std::pair<std::string, std::string>> seeds = { { "a.obj", SquareObj },
    { "a.off", TetrahedronOff }, { "a.off", coff }, { "a.ply", PlyOfEveryType(0) },
    { "a.ply", PlyOfEveryType(1) }, { "a.ply", PlyOfEveryType(2) }, { "a.stl", AsciiStl },
    { "a.stl", BinaryStl("solid") } };
  constexpr int triesPerSeed = 800;
  std::mt19937 random(20130813);
  Monitor monitor;
  for (const auto& [name, content] : seeds)
  {
    const TemporaryFile file(name);
    int surfaces = 0;
    int errors = 0;
    for (int i = 0; i < triesPerSeed; ++i)
    {
      file.Write(Mutated(content, random));
      try
      {
        const PolygonSurface surface = ReadSurface(file.Path, monitor);
        ++surfaces;
        ExpectIdsInRange(surface);
        ExpectAttributesComplete(surface.PointAttributes, surface.Points.size());
        ExpectAttributesComplete(surface.PolygonAttributes, surface.Offsets.size() - 1);
      }
      catch (const Error& error)
      {
        ++errors;
        EXPECT_EQ(error.Code, ErrorCode::FileMalformed) << error.what();
        EXPECT_EQ(std::string(error.what()).find(file.Name), 0u) << error.what();
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
    }
    // Both ends have to be reached for the test to mean anything.
    EXPECT_GT(surfaces, triesPerSeed / 50) << name;
    EXPECT_GT(errors, triesPerSeed / 50) << name;
  }
}
