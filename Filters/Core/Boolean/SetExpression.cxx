// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SetExpression.h"

#include "Common/Error.h"
#include "Common/SortUniquely.h"

#include <algorithm>

namespace insideout
{
namespace
{
bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/**
 * Whether a name may contain this byte: letters, digits, underscores, and all bytes outside ASCII.
 */
bool IsOfName(char c)
{
  return IsDigit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
    static_cast<unsigned char>(c) >= 128;
}

/** Whether a byte continues a character of UTF-8. */
bool Continues(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/** The precedence of an operator; 0 for other characters. */
int PrecedenceOf(char c)
{
  switch (c)
  {
    case '+':
    case '-':
      return 4;
    case '&':
      return 3;
    case '^':
      return 2;
    case '|':
      return 1;
    default:
      return 0;
  }
}

SetOperation OperationOf(char c)
{
  switch (c)
  {
    case '-':
      return SetOperation::Difference;
    case '&':
      return SetOperation::Intersection;
    case '^':
      return SetOperation::SymmetricDifference;
    default:
      return SetOperation::Union;
  }
}
} // namespace

/**
 * The shunting yard (Dijkstra 1961): operators wait until none with higher precedence can follow.
 */
class SetExpressionParser
{
public:
  SetExpressionParser(const std::string& text, const std::vector<std::string>& names)
    : Text(text)
    , Names(names)
  {
  }

  std::vector<SetExpression::Step> Parse();

private:
  struct Waiting
  {
    char What; ///< an operator or an opening parenthesis
    std::size_t At;
  };

  void TakeBody();
  void TakeOperator();
  Id BodyInQuotes();
  Id BodyByNumber();
  Id BodyByWord();
  Id BodyCalled(const std::string& name, std::size_t at) const;
  void Work(int precedence);
  std::string CharacterAt(std::size_t at) const;
  [[noreturn]] void Fail(std::size_t at, const std::string& what) const;

  const std::string& Text;
  const std::vector<std::string>& Names;
  std::size_t Place = 0;
  bool IsBodyNext = true;
  std::vector<Waiting> Stack;
  std::vector<SetExpression::Step> Steps;
};

/** The UTF-8 character that begins there. */
std::string SetExpressionParser::CharacterAt(std::size_t at) const
{
  std::size_t end = at + 1;
  while (end < this->Text.size() && Continues(this->Text[end]))
  {
    ++end;
  }
  return this->Text.substr(at, end - at);
}

void SetExpressionParser::Fail(std::size_t at, const std::string& what) const
{
  // Columns are characters.
  const auto column = std::count_if(this->Text.begin(),
    this->Text.begin() + static_cast<std::ptrdiff_t>(std::min(at, this->Text.size())),
    [](char c) { return !Continues(c); });
  throw Error(ErrorCode::InvalidParameter,
    "the expression \"" + this->Text + "\", column " + std::to_string(column + 1) + ": " + what);
}

std::vector<SetExpression::Step> SetExpressionParser::Parse()
{
  for (; this->Place < this->Text.size();)
  {
    if (IsSpace(this->Text[this->Place]))
    {
      ++this->Place;
    }
    else if (this->IsBodyNext)
    {
      this->TakeBody();
    }
    else
    {
      this->TakeOperator();
    }
  }
  if (this->IsBodyNext)
  {
    this->Fail(this->Text.size(), "a body is missing");
  }
  this->Work(1);
  if (!this->Stack.empty())
  {
    this->Fail(this->Stack.back().At, "this parenthesis is never closed");
  }
  return std::move(this->Steps);
}

/** Read a body, or a parenthesis that opens before one. */
void SetExpressionParser::TakeBody()
{
  const char c = this->Text[this->Place];
  if (c == '(')
  {
    this->Stack.push_back({ c, this->Place++ });
    return;
  }
  const bool isQuote = c == '"' || c == '\'';
  if (!isQuote && c != '#' && !IsOfName(c))
  {
    this->Fail(this->Place, "a body is missing before '" + this->CharacterAt(this->Place) + "'");
  }
  const Id body =
    isQuote ? this->BodyInQuotes() : (c == '#' ? this->BodyByNumber() : this->BodyByWord());
  this->Steps.push_back({ body, SetOperation::Union });
  this->IsBodyNext = false;
}

Id SetExpressionParser::BodyInQuotes()
{
  const std::size_t begin = this->Place;
  const std::size_t end = this->Text.find(this->Text[begin], begin + 1);
  if (end == std::string::npos)
  {
    this->Fail(begin, "this quote is never closed");
  }
  this->Place = end + 1;
  return this->BodyCalled(this->Text.substr(begin + 1, end - begin - 1), begin);
}

Id SetExpressionParser::BodyByNumber()
{
  const std::size_t begin = this->Place++;
  Id number = 0;
  while (this->Place < this->Text.size() && IsDigit(this->Text[this->Place]))
  {
    number = std::min<Id>(number * 10 + (this->Text[this->Place++] - '0'), 100'000'000);
  }
  if (number < 1 || number > static_cast<Id>(this->Names.size()))
  {
    this->Fail(begin,
      this->Text.substr(begin, this->Place - begin) + " is not one of #1 to #" +
        std::to_string(this->Names.size()));
  }
  return number - 1;
}

Id SetExpressionParser::BodyByWord()
{
  const std::size_t begin = this->Place;
  while (this->Place < this->Text.size() && IsOfName(this->Text[this->Place]))
  {
    ++this->Place;
  }
  return this->BodyCalled(this->Text.substr(begin, this->Place - begin), begin);
}

Id SetExpressionParser::BodyCalled(const std::string& name, std::size_t at) const
{
  const auto first = std::find(this->Names.begin(), this->Names.end(), name);
  if (first != this->Names.end())
  {
    if (std::find(first + 1, this->Names.end(), name) != this->Names.end())
    {
      this->Fail(at, "several bodies are called " + name + ": give its number, as in #1");
    }
    return static_cast<Id>(first - this->Names.begin());
  }
  const std::size_t letter = name.size() == 1 ? static_cast<std::size_t>(name[0] - 'A') : 26;
  if (letter < 26 && letter < this->Names.size())
  {
    return static_cast<Id>(letter);
  }
  std::string known;
  for (const std::string& other : this->Names)
  {
    known += (known.empty() ? "" : ", ") + other;
  }
  this->Fail(at, "no body is called " + name + "; there are " + known);
}

void SetExpressionParser::TakeOperator()
{
  const char c = this->Text[this->Place];
  if (c == ')')
  {
    this->Work(1);
    if (this->Stack.empty())
    {
      this->Fail(this->Place, "this parenthesis was never opened");
    }
    this->Stack.pop_back();
    ++this->Place;
    return;
  }
  if (PrecedenceOf(c) == 0)
  {
    this->Fail(
      this->Place, "one of | + & - ^ is missing before '" + this->CharacterAt(this->Place) + "'");
  }
  this->Work(PrecedenceOf(c));
  this->Stack.push_back({ c, this->Place++ });
  this->IsBodyNext = true;
}

/** Apply the waiting operators with at least this precedence, back to a parenthesis. */
void SetExpressionParser::Work(int precedence)
{
  while (!this->Stack.empty() && PrecedenceOf(this->Stack.back().What) >= precedence)
  {
    this->Steps.push_back({ None, OperationOf(this->Stack.back().What) });
    this->Stack.pop_back();
  }
}

SetExpression::SetExpression(const std::string& text, const std::vector<std::string>& names)
  : Steps(SetExpressionParser(text, names).Parse())
{
  this->NumberBodies();
}

SetExpression::SetExpression(SetOperation operation, Id numberOfBodies)
{
  for (Id body = 0; body < numberOfBodies; ++body)
  {
    this->Steps.push_back({ body, operation });
    if (body > 0)
    {
      this->Steps.push_back({ None, operation });
    }
  }
  this->NumberBodies();
}

bool SetExpression::Holds(const std::vector<char>& isIn) const
{
  std::vector<char> results;
  for (const Step& step : this->Steps)
  {
    if (step.Body != None)
    {
      results.push_back(isIn[step.Body] != 0);
      continue;
    }
    const bool second = results.back() != 0;
    results.pop_back();
    const bool first = results.back() != 0;
    switch (step.Operation)
    {
      case SetOperation::Union:
        results.back() = first || second;
        break;
      case SetOperation::Intersection:
        results.back() = first && second;
        break;
      case SetOperation::Difference:
        results.back() = first && !second;
        break;
      case SetOperation::SymmetricDifference:
        results.back() = first != second;
        break;
    }
  }
  return !results.empty() && results.back() != 0;
}

/** List the bodies that the steps name, and number them by that list. */
void SetExpression::NumberBodies()
{
  for (const Step& step : this->Steps)
  {
    if (step.Body != None)
    {
      this->Named.push_back(step.Body);
    }
  }
  SortUniquely(this->Named);
  for (Step& step : this->Steps)
  {
    step.Body = step.Body == None ? None : IndexIn(this->Named, step.Body);
  }
}
} // namespace insideout
