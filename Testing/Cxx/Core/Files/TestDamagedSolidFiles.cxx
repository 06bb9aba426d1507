// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SolidFile.h"

#include "Common/Error.h"
#include "Support/MutatedText.h"
#include "Support/SolidSamples.h"
#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <random>

using namespace insideout;
using namespace solidsamples;
using testfiles::TemporaryFile;

namespace
{
struct Sample
{
  const char* Name;
  MshVersion Version;
  bool IsQuadratic;
};

constexpr Sample Samples[] = { { "a.msh", MshVersion::Msh41, false },
  { "a.msh", MshVersion::Msh22, true }, { "a.inp", MshVersion::Msh41, false },
  { "a.inp", MshVersion::Msh41, true }, { "a.mesh", MshVersion::Msh41, true },
  { "a.mesh", MshVersion::Msh41, false } };

std::string ContentOf(const Sample& sample)
{
  const TemporaryFile file(sample.Name);
  Monitor monitor;
  const SolidMesh solid = TwoRegions();
  WriteSolid(file.Path, sample.IsQuadratic ? Quadratic(solid) : solid, sample.Version, monitor);
  return file.Read();
}

template <typename Elements>
void ExpectInRange(const Elements& elements, std::size_t points)
{
  EXPECT_TRUE(elements.Midpoints.empty() || elements.Midpoints.size() == elements.Cells.size());
  ASSERT_EQ(elements.GroupOf.size(), elements.Cells.size());
  const auto expectIds = [points](const auto& cells)
  {
    for (const auto& cell : cells)
    {
      for (const Id point : cell)
      {
        EXPECT_GE(point, 0);
        EXPECT_LT(static_cast<std::size_t>(point), points);
      }
    }
  };
  expectIds(elements.Cells);
  expectIds(elements.Midpoints);
  for (const Id group : elements.GroupOf)
  {
    EXPECT_GE(group, 0);
    EXPECT_LT(static_cast<std::size_t>(group), elements.Groups.size());
  }
  for (const SolidGroup& group : elements.Groups)
  {
    EXPECT_GE(group.Number, 1);
  }
}

/** Whether a solid is read that holds together; else there is one error in one line. */
bool IsRead(const TemporaryFile& file)
{
  Monitor monitor;
  try
  {
    const SolidContent solid = ReadSolid(file.Path, monitor);
    ExpectInRange(solid.Tetrahedra, solid.Points.size());
    ExpectInRange(solid.Triangles, solid.Points.size());
    return true;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::FileMalformed) << error.what();
    EXPECT_EQ(std::string(error.what()).find(file.Name), 0u) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return false;
  }
}
} // namespace

TEST(DamagedSolidFiles, AreAValidSolidOrAnError)
{
  constexpr int triesPerSample = 700;
  std::mt19937 random(20130813);
  for (const Sample& sample : Samples)
  {
    const std::string content = ContentOf(sample);
    const TemporaryFile file(sample.Name);
    int solids = 0;
    for (int i = 0; i < triesPerSample; ++i)
    {
      file.Write(testfiles::Mutated(content, random));
      solids += IsRead(file) ? 1 : 0;
    }
    // Both ends have to be reached for the test to mean anything.
    EXPECT_GT(solids, triesPerSample / 50) << sample.Name;
    EXPECT_LT(solids, triesPerSample - triesPerSample / 50) << sample.Name;
  }
}

TEST(DamagedSolidFiles, AreAnErrorWhereTheyEndEarly)
{
  for (const Sample& sample : Samples)
  {
    const std::string content = ContentOf(sample);
    const std::string name = sample.Name;
    // An .inp file may end behind any line, and what follows the elements in a .msh file is a
    // comment.
    const std::size_t whole = name == "a.msh" ? content.find("$EndElements") + 12
      : name == "a.mesh"                      ? content.rfind("End") + 3
                                              : content.find("*ELEMENT");
    const TemporaryFile file(name);
    for (std::size_t length = 1; length <= content.size(); ++length)
    {
      file.Write(content.substr(0, length));
      const bool isRead = IsRead(file);
      EXPECT_FALSE(isRead && length < whole) << name << " of " << length << " bytes";
    }
    EXPECT_TRUE(IsRead(file));
  }
}
