// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/GroupNames.h"

#include <gtest/gtest.h>

using namespace insideout;

namespace
{
constexpr NameRules AnyText = { 100, false, true };
constexpr NameRules Words = { 12, true, false };

/** What becomes of names of tags, beside one region. */
std::vector<std::string> NamesOfTags(const std::vector<std::string>& names, const NameRules& rules,
  const std::string& region = "solid", const std::vector<std::string>& taken = {})
{
  SolidMesh solid;
  solid.Regions = { { region, 1 } };
  for (const std::string& name : names)
  {
    solid.Tags.push_back({ name, static_cast<Id>(solid.Tags.size()) + 1 });
  }
  return ValidNames(solid, rules, taken).Tags;
}

using Names = std::vector<std::string>;
} // namespace

TEST(GroupNames, KeepsWhatAFormatTakes)
{
  EXPECT_EQ(
    NamesOfTags({ "Wall 1", "größe", "wall 1" }, AnyText), (Names{ "Wall 1", "größe", "wall 1" }));
  EXPECT_EQ(NamesOfTags({ "Wall_1", "x" }, Words), (Names{ "Wall_1", "x" }));
}

TEST(GroupNames, ReplacesWhatItDoesNot)
{
  EXPECT_EQ(NamesOfTags({ "a\"b\\c\nd", "" }, AnyText), (Names{ "a_b_c_d", "group" }));
  EXPECT_EQ(NamesOfTags({ "a b-c,d", "größe", "1st", "_x", "" }, Words),
    (Names{ "a_b_c_d", "gr__e", "group_1st", "group__x", "group_" }));
}

TEST(GroupNames, CutsWhatIsTooLongButNoCharacter)
{
  const NameRules five = { 5, false, true };
  EXPECT_EQ(
    NamesOfTags({ "abcdefg", "abcdö", "abcdefg" }, five), (Names{ "abcde", "abcd", "abc_2" }));
}

TEST(GroupNames, GivesEachANameOfItsOwn)
{
  EXPECT_EQ(NamesOfTags({ "a", "a", "a", "a_2", "solid" }, AnyText),
    (Names{ "a", "a_2", "a_3", "a_2_2", "solid_2" }));
  EXPECT_EQ(NamesOfTags({ "a", "A", "nALL", "Solid" }, Words, "solid", { "Nall" }),
    (Names{ "a", "A_2", "nALL_2", "Solid_2" }));
  EXPECT_EQ(NamesOfTags({ "a long name of 1", "a long name of 2" }, Words),
    (Names{ "a_long_name_", "a_long_nam_2" }));
}

TEST(GroupNames, LeavesOnlyValidText)
{
  EXPECT_EQ(PrintableText("größe € 𝄞"), "größe € 𝄞");
  EXPECT_EQ(PrintableText("gr\xf6\xdf"
                          "e"),
    "gr__e");
  EXPECT_EQ(PrintableText("\xc3"), "_");
  EXPECT_EQ(PrintableText("\xe2\x82z"), "__z");
  EXPECT_EQ(PrintableText("\xc0\xaf \xed\xa0\x80 \xf4\x90\x80\x80 \xe0\x80\x80 \xf0\x80\x80\x80"),
    "__ ___ ____ ___ ____");
  EXPECT_EQ(PrintableText(std::string("\0\t\x7f", 3)), "___");
}
