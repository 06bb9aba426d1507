// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/TagRules.h"

#include "Common/Error.h"

#include <gtest/gtest.h>

#include <set>

namespace
{
using namespace insideout;

/** The cube from 0 to 1, two triangles for each of low x, high x, low y, high y, low z, high z. */
TaggedSurface Cube()
{
  TaggedSurface cube;
  for (int p = 0; p < 8; ++p)
  {
    cube.Points.push_back({ { double(p & 1), double(p >> 1 & 1), double(p >> 2 & 1) } });
  }
  cube.Triangles = { { { 0, 4, 6 } }, { { 0, 6, 2 } }, { { 1, 3, 7 } }, { { 1, 7, 5 } },
    { { 0, 1, 5 } }, { { 0, 5, 4 } }, { { 2, 6, 7 } }, { { 2, 7, 3 } }, { { 0, 2, 3 } },
    { { 0, 3, 1 } }, { { 4, 5, 7 } }, { { 4, 7, 6 } } };
  cube.Sources.assign(12, None);
  cube.IsIn = [](const std::string& array, Id triangle)
  { return array == "Odd" && triangle % 2 == 1; };
  return cube;
}

std::set<Id> Matched(const std::string& condition)
{
  std::set<Id> matched;
  const std::vector<TagMatch> matches = MatchTagRules(ReadTagRules("a=" + condition), Cube());
  for (std::size_t t = 0; t < matches.size(); ++t)
  {
    if (matches[t].Rule == 0)
    {
      matched.insert(static_cast<Id>(t));
    }
  }
  return matched;
}

const std::set<Id> HighX = { 2, 3 };
const std::set<Id> HighZ = { 10, 11 };
} // namespace

TEST(TagRules, ConditionsMeanTrianglesOfTheBoundary)
{
  EXPECT_EQ(Matched("normal 1 0 0"), HighX);
  EXPECT_EQ(Matched("normal 1,0,0.1"), HighX);
  EXPECT_EQ(Matched("normal 1 0 1 46").size(), 4u);
  EXPECT_EQ(Matched("normal 1 0 1 44").size(), 0u);
  EXPECT_EQ(Matched("box 2 2 2 0.9 0 0"), HighX);
  EXPECT_EQ(Matched("sphere 0.5 0.5 1 0.3"), HighZ);
  EXPECT_EQ(Matched("plane 5 5 1 0 0 -3"), HighZ);
  EXPECT_EQ(Matched("plane 0 0 0.9 0 0 1"), std::set<Id>{});
  EXPECT_EQ(Matched("plane 0 0 0.9 0 0 1 0.11"), HighZ);
  EXPECT_EQ(Matched("face 0.5 0.5 1.2"), HighZ);
  EXPECT_EQ(Matched("face 0.5 0.5 1.2 91").size(), 12u);
  EXPECT_EQ(Matched("array Odd & normal 0 0 1"), std::set<Id>{ 11 });
  EXPECT_EQ(Matched("faces & normal 0 0 1"), HighZ);
}

TEST(TagRules, EachFaceHasANumber)
{
  const std::vector<TagMatch> matches =
    MatchTagRules(ReadTagRules("f=faces; g=faces 91 & normal 0 0 1"), Cube());
  for (Id t = 0; t < 12; ++t)
  {
    EXPECT_EQ(matches[t].Rule, t < 10 ? 0 : 1);
    EXPECT_EQ(matches[t].Face, t < 10 ? t / 2 : 0);
  }
}

TEST(TagRules, TheLastRuleAndTheNearestPointCount)
{
  const std::vector<TagMatch> matches = MatchTagRules(
    ReadTagRules("low = nearest 0.5 0.5 -1; high=nearest 0.5 0.5 2;; low=normal 0 0 1"), Cube());
  EXPECT_EQ(matches[8].Rule, 0);
  EXPECT_EQ(matches[10].Rule, 2);
  EXPECT_EQ(
    MatchTagRules(ReadTagRules("low = nearest 0.5 0.5 -1; high=nearest 0.5 0.5 2"), Cube())[10]
      .Rule,
    1);
}

TEST(TagRules, PiecesOfAFacetAreOfOneFaceAndPointsAtOnePlaceAreOne)
{
  TaggedSurface surface = Cube();
  // Pieces of one facet about a point that is there twice, with normals that differ a little.
  surface.Points.push_back({ { 0.5, 0.5, 1 + 1e-9 } });
  surface.Triangles[10] = { { 4, 5, 8 } };
  surface.Triangles.push_back({ { 5, 7, 8 } });
  surface.Points.push_back({ { 0.5, 0.5, 1 + 1e-9 } });
  surface.Triangles[11] = { { 4, 9, 6 } };
  surface.Triangles.push_back({ { 9, 7, 6 } });
  surface.Sources.assign(14, 5);
  std::fill_n(surface.Sources.begin(), 10, None);
  const std::vector<TagMatch> matches =
    MatchTagRules(ReadTagRules("f=face 0.5 0.5 2 0; n=array None"), surface);
  for (Id t = 0; t < 14; ++t)
  {
    EXPECT_EQ(matches[t].Rule, t < 10 ? None : 0) << t;
  }
}

TEST(TagRules, BadRulesAreNamed)
{
  const auto message = [](const std::string& text) -> std::string
  {
    try
    {
      ReadTagRules(text);
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("inlet"), "the rule inlet is not a name, an equals sign and a condition");
  EXPECT_EQ(message("a=box 0 0 0 1 1 1; b=wall 3"),
    "the rule b=wall 3 begins with \"wall\"; it can be normal, box, sphere, plane, face, faces, "
    "nearest, or array");
  EXPECT_EQ(message("a=box 0 0 0"),
    "the rule a=box 0 0 0 has 3 numbers behind box, which takes X Y Z X Y Z");
  EXPECT_EQ(
    message("a=sphere 0 0 0 1e"), "the rule a=sphere 0 0 0 1e has \"1e\" in place of a number");
  EXPECT_EQ(message("a=normal 0 0 0"), "the rule a=normal 0 0 0 has a direction without a length");
  EXPECT_EQ(message("a=plane 1 1 1 0 0 0"),
    "the rule a=plane 1 1 1 0 0 0 has a direction without a length");
  EXPECT_EQ(message("a=normal 0 0 1 -4"), "the rule a=normal 0 0 1 -4 ends with a number below 0");
  EXPECT_EQ(message("a=array"), "the rule a=array names no array");
  EXPECT_EQ(
    message("a=normal 0 0 1 & "), "the rule a=normal 0 0 1 & has a condition without a word");
}
