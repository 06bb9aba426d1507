// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/SizeRules.h"

#include "Common/Error.h"

#include <gtest/gtest.h>

using namespace insideout;

TEST(SizeRules, AreRead)
{
  const std::vector<SizeRule> rules =
    ReadSizeRules(" curvature=24;gap = 3;; tag a wall=of brick = 0.5; region 2=1e-3;"
                  "point 1 2 3=4;point 0,0,-1 .5 = 2");
  ASSERT_EQ(rules.size(), 6u);
  EXPECT_EQ(rules[0].What, SizeRule::Kind::Curvature);
  EXPECT_EQ(rules[0].Value, 24);
  EXPECT_EQ(rules[1].What, SizeRule::Kind::Gap);
  EXPECT_EQ(rules[1].Text, "gap = 3");
  EXPECT_EQ(rules[2].What, SizeRule::Kind::Tag);
  EXPECT_EQ(rules[2].Name, "a wall=of brick");
  EXPECT_EQ(rules[2].Value, 0.5);
  EXPECT_EQ(rules[3].What, SizeRule::Kind::Region);
  EXPECT_EQ(rules[3].Name, "2");
  EXPECT_EQ(rules[4].What, SizeRule::Kind::Point);
  EXPECT_EQ(rules[4].Center, (Point{ { 1, 2, 3 } }));
  EXPECT_EQ(rules[4].Radius, 0);
  EXPECT_EQ(rules[5].Radius, 0.5);
  EXPECT_TRUE(ReadSizeRules("").empty());
}

TEST(SizeRules, BadOnesAreNamed)
{
  const std::vector<std::array<std::string, 2>> cases = {
    { { "wall=3", "the rule wall=3 is none of curvature=EDGES, gap=CELLS" } },
    { { "curvature", "the rule curvature is none of" } },
    { { "gap=3; curvature 24", "the rule curvature 24 is none of" } },
    { { "gap=", "the rule gap= does not end with one number above 0" } },
    { { "gap=-1", "the rule gap=-1 does not end with one number above 0" } },
    { { "gap=0", "does not end with one number above 0" } },
    { { "gap=1 2", "does not end with one number above 0" } },
    { { "gap=nan", "has \"nan\" in place of a number" } },
    { { "gap 4=3", "the rule gap 4=3 is not of the form gap=CELLS" } },
    { { "tag=3", "is not of the form tag NAME=LENGTH" } },
    { { "region =3", "is not of the form region NAME=LENGTH" } },
    { { "tag a=2%", "has \"2%\" in place of a number" } },
    { { "point 1 2=3", "is not of the form point X Y Z [RADIUS]=LENGTH" } },
    { { "point 1 2 3 4 5=3", "is not of the form point X Y Z [RADIUS]=LENGTH" } },
    { { "point 1 2 x=3", "has \"x\" in place of a number" } },
    { { "point 1 2 3 -4=3", "has a radius below 0" } },
  };
  for (const auto& [text, expected] : cases)
  {
    SCOPED_TRACE(text);
    try
    {
      ReadSizeRules(text);
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    }
  }
}
