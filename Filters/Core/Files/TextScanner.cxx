// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/TextScanner.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace insideout
{
namespace
{
// Bytes between calls of the monitor: a call costs little, but more than a line.
constexpr std::int64_t LinesBetweenChecks = 1 << 15;

bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool IsNewline(char c)
{
  return c == '\n' || c == '\r';
}

/**
 * Whether a decimal number that does not fit a double overflows rather than underflows, by the
 * power of ten of its first nonzero digit.
 */
bool IsHuge(const char* at, const char* end)
{
  const char* const mantissaEnd =
    std::find_if(at, end, [](char c) { return c == 'e' || c == 'E'; });
  const char* const point = std::find(at, mantissaEnd, '.');
  const char* const leading =
    std::find_if(at, mantissaEnd, [](char c) { return c >= '1' && c <= '9'; });
  const std::int64_t power = point - leading;
  if (mantissaEnd == end)
  {
    return power > 0;
  }
  const char* const digits = mantissaEnd[1] == '+' ? mantissaEnd + 2 : mantissaEnd + 1;
  std::int64_t exponent = 0;
  if (std::from_chars(digits, end, exponent).ec != std::errc())
  {
    return *digits != '-';
  }
  return exponent > -power;
}

/** Skip a plus sign, which from_chars rejects; null if another sign follows it. */
const char* SkipPlus(const char* at, const char* end)
{
  if (at == end || *at != '+')
  {
    return at;
  }
  ++at;
  return at != end && *at == '-' ? nullptr : at;
}

/** The end of the number at `at`, null if there is none. */
const char* ParseDouble(const char* at, const char* end, double& value)
{
  at = SkipPlus(at, end);
  if (!at)
  {
    return nullptr;
  }
  const std::from_chars_result result = std::from_chars(at, end, value);
  if (result.ec == std::errc::result_out_of_range)
  {
    const double size = IsHuge(at, result.ptr) ? std::numeric_limits<double>::infinity() : 0.0;
    value = *at == '-' ? -size : size;
  }
  return result.ec == std::errc::invalid_argument ? nullptr : result.ptr;
}
} // namespace

TextScanner::TextScanner(
  const FileContent& file, const char* begin, std::int64_t line, Syntax syntax, Monitor& monitor)
  : File(file)
  , At(begin)
  , End(file.End())
  , Line(line)
  , Rules(syntax)
  , Watch(monitor)
{
}

bool TextScanner::HasLines(std::uint64_t count) const
{
  std::uint64_t lines = 0;
  const char* at = this->At;
  while (lines < count && at != this->End)
  {
    at = std::find_if_not(at, this->End, [](char c) { return IsBlank(c) || IsNewline(c); });
    if (at != this->End && !(this->Rules.Comments && *at == '#'))
    {
      ++lines;
    }
    at = std::find_if(at, this->End, IsNewline);
  }
  return lines >= count;
}

bool TextScanner::AtLineEnd()
{
  this->SkipBlanks();
  return this->At == this->End || IsNewline(*this->At) ||
    (this->Rules.Comments && *this->At == '#');
}

void TextScanner::SkipLine()
{
  while (!this->AtLineEnd())
  {
    this->Word();
  }
  this->At = std::find_if(this->At, this->End, IsNewline);
  if (this->At != this->End)
  {
    this->ConsumeNewline();
  }
}

bool TextScanner::SkipToContent()
{
  while (this->AtLineEnd())
  {
    if (this->At == this->End)
    {
      return false;
    }
    this->SkipLine();
  }
  return true;
}

std::string_view TextScanner::Word()
{
  if (this->AtLineEnd())
  {
    return {};
  }
  const char* const begin = this->At;
  while (this->At != this->End && !IsBlank(*this->At) && !IsNewline(*this->At) &&
    !this->IsContinuation(this->At))
  {
    ++this->At;
  }
  return { begin, static_cast<std::size_t>(this->At - begin) };
}

std::string TextScanner::RestOfLine()
{
  std::string rest;
  while (!this->AtLineEnd())
  {
    rest += rest.empty() ? "" : " ";
    rest += this->Word();
  }
  return rest;
}

double TextScanner::Number()
{
  this->SkipBlanks();
  const char* const word = this->At;
  const double value = this->LeadingNumber();
  if (!this->AtWordEnd())
  {
    this->FailAtWord("a number", word);
  }
  return value;
}

double TextScanner::LeadingNumber()
{
  this->SkipBlanks();
  double value = 0.0;
  const char* const end = ParseDouble(this->At, this->End, value);
  if (!end)
  {
    this->FailAtWord("a number", this->At);
  }
  this->At = end;
  return value;
}

std::int64_t TextScanner::Integer()
{
  this->SkipBlanks();
  const char* const word = this->At;
  const std::int64_t value = this->LeadingInteger();
  if (!this->AtWordEnd())
  {
    this->FailAtWord("an integer", word);
  }
  return value;
}

std::int64_t TextScanner::LeadingInteger()
{
  this->SkipBlanks();
  std::int64_t value = 0;
  const char* const begin = SkipPlus(this->At, this->End);
  const std::from_chars_result result =
    std::from_chars(begin ? begin : this->End, this->End, value);
  if (result.ec != std::errc())
  {
    this->FailAtWord("an integer", this->At);
  }
  this->At = result.ptr;
  return value;
}

bool TextScanner::Accept(char c)
{
  const bool accepted = this->At != this->End && *this->At == c;
  this->At += accepted ? 1 : 0;
  return accepted;
}

void TextScanner::ExpectWordEnd() const
{
  if (!this->AtWordEnd())
  {
    this->FailAtWord("a blank", this->At);
  }
}

void TextScanner::Fail(const std::string& what) const
{
  throw Error(ErrorCode::FileMalformed,
    this->File.Name + ", line " + std::to_string(this->Line) + ": " + what);
}

bool TextScanner::EndsWord(const char* at) const
{
  return at == this->End || IsBlank(*at) || IsNewline(*at) ||
    (this->Rules.Comments && *at == '#') || this->IsContinuation(at);
}

bool TextScanner::IsContinuation(const char* at) const
{
  return this->Rules.Continuation && *at == '\\' && this->End - at > 1 && IsNewline(at[1]);
}

void TextScanner::SkipBlanks()
{
  while (this->At != this->End)
  {
    if (IsBlank(*this->At))
    {
      ++this->At;
    }
    else if (this->IsContinuation(this->At))
    {
      ++this->At;
      this->ConsumeNewline();
    }
    else
    {
      return;
    }
  }
}

void TextScanner::ConsumeNewline()
{
  const bool two = *this->At == '\r' && this->End - this->At > 1 && this->At[1] == '\n';
  this->At += two ? 2 : 1;
  if (++this->Line % LinesBetweenChecks == 0)
  {
    this->File.ReportPosition(this->At, this->Watch);
  }
}

void TextScanner::FailAtWord(const char* expected, const char* word) const
{
  const char* const end =
    std::find_if(word, this->End, [](char c) { return IsBlank(c) || IsNewline(c); });
  const std::string found =
    word == end ? "the end of the line" : Quoted({ word, static_cast<std::size_t>(end - word) });
  this->Fail(std::string("expected ") + expected + ", found " + found);
}

std::string Quoted(std::string_view text)
{
  constexpr std::size_t longest = 40;
  std::string quoted = "'";
  for (const char c : text.substr(0, longest))
  {
    quoted += c >= ' ' && c <= '~' ? c : '?';
  }
  return quoted + (text.size() > longest ? "...'" : "'");
}

bool EqualsIgnoringCase(std::string_view word, std::string_view lower)
{
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}
} // namespace insideout
