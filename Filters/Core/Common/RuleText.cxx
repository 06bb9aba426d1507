// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/RuleText.h"

#include "Common/Error.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace insideout
{
namespace
{
constexpr const char* Blanks = " \t\r\n";
}

std::vector<std::string> SplitText(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

std::string Trimmed(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(Blanks);
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

HeadAndTail SplitHead(const std::string& trimmed)
{
  const std::string head = trimmed.substr(0, trimmed.find_first_of(Blanks));
  return { head, Trimmed(trimmed.substr(head.size())) };
}

void RefuseRule(const std::string& rule, const std::string& words)
{
  throw Error(ErrorCode::InvalidParameter, "the rule " + rule + " " + words);
}

std::vector<double> NumbersOf(const std::string& text, const std::string& rule)
{
  std::string numbers = text;
  std::replace(numbers.begin(), numbers.end(), ',', ' ');
  std::istringstream words(numbers);
  std::vector<double> found;
  for (std::string one; words >> one;)
  {
    std::istringstream stream(one);
    stream.imbue(std::locale::classic());
    double number = 0;
    if (!(stream >> number) || !stream.eof() || !std::isfinite(number))
    {
      RefuseRule(rule, "has \"" + one + "\" in place of a number");
    }
    found.push_back(number);
  }
  return found;
}
} // namespace insideout
