// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SetExpression.h"

#include "Common/Error.h"

#include <gtest/gtest.h>

#include <functional>

namespace
{
using namespace insideout;

const std::vector<std::string> Four = { "A", "B", "C", "D" };

/** What an expression of A to D says of all 16 kinds of places, in bits. */
unsigned TableOf(const SetExpression& expression)
{
  unsigned table = 0;
  for (unsigned place = 0; place < 16; ++place)
  {
    std::vector<char> isIn;
    for (const Id body : expression.Bodies())
    {
      isIn.push_back(place >> body & 1);
    }
    table |= static_cast<unsigned>(expression.Holds(isIn)) << place;
  }
  return table;
}

unsigned TableOf(const std::string& text, const std::vector<std::string>& names = Four)
{
  return TableOf(SetExpression(text, names));
}

/** The same by a rule on whether a place is in A, B, C, D. */
unsigned TableOf(const std::function<bool(bool, bool, bool, bool)>& rule)
{
  unsigned table = 0;
  for (unsigned place = 0; place < 16; ++place)
  {
    table |= static_cast<unsigned>(rule(place & 1, place & 2, place & 4, place & 8)) << place;
  }
  return table;
}

std::string ErrorOf(const std::string& text, const std::vector<std::string>& names = Four)
{
  try
  {
    SetExpression expression(text, names);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    return error.what();
  }
  return "no error";
}

bool Names(const std::string& message, const std::string& column)
{
  return message.find("column " + column + ":") != std::string::npos;
}

TEST(SetExpression, HoldsWhatItsOperatorsSay)
{
  EXPECT_EQ(TableOf("A | B"), TableOf([](bool a, bool b, bool, bool) { return a || b; }));
  EXPECT_EQ(TableOf("A + B"), TableOf("A | B"));
  EXPECT_EQ(TableOf("A & B"), TableOf([](bool a, bool b, bool, bool) { return a && b; }));
  EXPECT_EQ(TableOf("A - B"), TableOf([](bool a, bool b, bool, bool) { return a && !b; }));
  EXPECT_EQ(TableOf("A ^ B"), TableOf([](bool a, bool b, bool, bool) { return a != b; }));
  EXPECT_EQ(TableOf(" C\t"), TableOf([](bool, bool, bool c, bool) { return c; }));
}

TEST(SetExpression, HasThePrecedenceOfPythonAndCxx)
{
  EXPECT_EQ(TableOf("A - (B | C) ^ D"),
    TableOf([](bool a, bool b, bool c, bool d) { return (a && !(b || c)) != d; }));
  EXPECT_EQ(TableOf("A | B ^ C & D"), TableOf("A | (B ^ (C & D))"));
  EXPECT_EQ(TableOf("A & B - C"), TableOf("A & (B - C)"));
  EXPECT_EQ(TableOf("A + B & C"), TableOf("(A + B) & C"));
  EXPECT_EQ(TableOf("A - B - C"), TableOf("(A - B) - C"));
  EXPECT_EQ(TableOf("A + B - C"), TableOf("(A | B) - C"));
  EXPECT_EQ(TableOf("A - B + C"), TableOf("(A - B) | C"));
  EXPECT_NE(TableOf("A - (B - C)"), TableOf("A - B - C"));
}

/** Random expressions against what C++ makes of the same operators on bits. */
TEST(SetExpression, IsWhatTheOperatorsOfBitsAre)
{
  unsigned state = 5;
  const auto random = [&state](unsigned below)
  {
    state = state * 1664525u + 1013904223u;
    return (state >> 16) % below;
  };
  const std::array<unsigned, 4> bits = { { 0xAAAA, 0xCCCC, 0xF0F0, 0xFF00 } };
  const std::function<std::pair<std::string, unsigned>(int)> make =
    [&](int depth) -> std::pair<std::string, unsigned>
  {
    if (depth == 0)
    {
      const unsigned body = random(4);
      return { Four[body], bits[body] };
    }
    const auto [first, a] = make(static_cast<int>(random(depth)));
    const auto [second, b] = make(static_cast<int>(random(depth)));
    const std::array<unsigned, 4> results = { { a | b, a & b, a & ~b, a ^ b } };
    const unsigned operation = random(4);
    const char sign = "|&-^"[operation];
    return { "(" + first + ") " + sign + "(" + second + ")", results[operation] };
  };
  for (int round = 0; round < 300; ++round)
  {
    const auto [text, table] = make(6);
    EXPECT_EQ(TableOf(text), table) << text;
  }
}

TEST(SetExpression, CallsBodiesByNameNumberOrLetter)
{
  const std::vector<std::string> names = { "left lung", "B", "heart_1", "8" };
  EXPECT_EQ(TableOf("'left lung' - heart_1", names), TableOf("A - C"));
  EXPECT_EQ(TableOf("\"left lung\" - #3", names), TableOf("A - C"));
  EXPECT_EQ(TableOf("A&#4", names), TableOf("A & D"));
  EXPECT_EQ(TableOf("8", names), TableOf("D"));
  EXPECT_EQ(TableOf("B", { "x", "y", "B", "z" }), TableOf("C")); // a name goes before a letter
  EXPECT_EQ(SetExpression("D - B", Four).Bodies(), (std::vector<Id>{ 1, 3 }));
}

TEST(SetExpression, NamesThePlaceOfWhatIsWrong)
{
  EXPECT_TRUE(Names(ErrorOf(""), "1"));
  EXPECT_TRUE(Names(ErrorOf("A - "), "5"));
  EXPECT_TRUE(Names(ErrorOf("A - (B | C"), "5"));
  EXPECT_TRUE(Names(ErrorOf("A) - B"), "2"));
  EXPECT_TRUE(Names(ErrorOf("A B"), "3"));
  EXPECT_TRUE(Names(ErrorOf("A - - B"), "5"));
  EXPECT_TRUE(Names(ErrorOf("A - ()"), "6"));
  EXPECT_TRUE(Names(ErrorOf("A - #5"), "5"));
  EXPECT_TRUE(Names(ErrorOf("A - #0"), "5"));
  EXPECT_TRUE(Names(ErrorOf("A - #"), "5"));
  EXPECT_TRUE(Names(ErrorOf("#99999999999999999999"), "1"));
  EXPECT_TRUE(Names(ErrorOf("A - 'B"), "5"));
  EXPECT_TRUE(Names(ErrorOf("A * B"), "3"));
  EXPECT_TRUE(Names(ErrorOf("A - E"), "5"));
  EXPECT_NE(ErrorOf("A - E").find("no body is called E; there are A, B, C, D"), std::string::npos);
  EXPECT_TRUE(Names(ErrorOf("L\xC3\xA4nge - x", { "L\xC3\xA4nge", "y" }), "9")); // of characters
  EXPECT_NE(ErrorOf("A & x", { "x", "x" }).find("several bodies are called x"), std::string::npos);
}

TEST(SetExpression, IsNotTooDeepForAnything)
{
  const std::size_t deep = 100000;
  EXPECT_EQ(TableOf(std::string(deep, '(') + "B" + std::string(deep, ')')), TableOf("B"));
}

TEST(SetExpression, OfAllBodiesIsTheChainOfOneOperation)
{
  EXPECT_EQ(TableOf(SetExpression(SetOperation::Union, 4)), TableOf("A | B | C | D"));
  EXPECT_EQ(TableOf(SetExpression(SetOperation::Intersection, 4)), TableOf("A & B & C & D"));
  EXPECT_EQ(TableOf(SetExpression(SetOperation::Difference, 4)), TableOf("A - B - C - D"));
  EXPECT_EQ(TableOf(SetExpression(SetOperation::SymmetricDifference, 4)), TableOf("A ^ B ^ C ^ D"));
  EXPECT_EQ(TableOf(SetExpression(SetOperation::Difference, 1)), TableOf("A"));
}
} // namespace
