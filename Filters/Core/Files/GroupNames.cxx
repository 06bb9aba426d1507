// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/GroupNames.h"

#include <algorithm>
#include <set>

namespace insideout
{
namespace
{
bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool IsOfWord(char c)
{
  return IsLetter(c) || (c >= '0' && c <= '9') || c == '_';
}

bool IsContinuation(char c)
{
  return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u;
}

/** The number of bytes of the UTF-8 character at a position, 0 if there is none. */
std::size_t LengthOfCharacter(const std::string& text, std::size_t at)
{
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80u ? 1
    : first >= 0xC2u && first < 0xE0u      ? 2
    : first >= 0xE0u && first < 0xF0u      ? 3
    : first >= 0xF0u && first < 0xF5u      ? 4
                                           : 0;
  if (length == 0 || at + length > text.size() ||
    !std::all_of(text.begin() + static_cast<std::ptrdiff_t>(at) + 1,
      text.begin() + static_cast<std::ptrdiff_t>(at + length), IsContinuation))
  {
    return 0;
  }
  // Overlong encodings, surrogates, and code points beyond Unicode are invalid.
  const auto second = length > 1 ? static_cast<unsigned char>(text[at + 1]) : 0u;
  const bool none = (first == 0xE0u && second < 0xA0u) || (first == 0xEDu && second >= 0xA0u) ||
    (first == 0xF0u && second < 0x90u) || (first == 0xF4u && second >= 0x90u);
  return none ? 0 : length;
}

/** The longest prefix of at most a number of bytes that ends between characters. */
std::string Beginning(const std::string& text, std::size_t longest)
{
  std::size_t length = std::min(text.size(), longest);
  while (length > 0 && length < text.size() && IsContinuation(text[length]))
  {
    --length;
  }
  return text.substr(0, length);
}

std::string ValidName(const std::string& name, const NameRules& rules)
{
  std::string valid = PrintableText(name);
  if (rules.WordsOnly)
  {
    // Keep one replacement for a character of several bytes.
    valid.erase(std::remove_if(valid.begin(), valid.end(), IsContinuation), valid.end());
    std::replace_if(
      valid.begin(), valid.end(), [](char c) { return !IsOfWord(c); }, '_');
    valid = valid.empty() || !IsLetter(valid.front()) ? "group_" + valid : valid;
  }
  return Beginning(valid.empty() ? "group" : valid, rules.Longest);
}

/** The key by which a format compares two names. */
std::string Essence(std::string name, const NameRules& rules)
{
  for (char& c : name)
  {
    c = !rules.CaseCounts && IsLetter(c) ? static_cast<char>(c | 0x20) : c;
  }
  return name;
}

class Names
{
public:
  Names(const NameRules& rules, const std::vector<std::string>& taken)
    : Rules(rules)
  {
    for (const std::string& name : taken)
    {
      this->Taken.insert(Essence(name, rules));
    }
  }

  std::vector<std::string> For(const std::vector<SolidGroup>& groups)
  {
    std::vector<std::string> names;
    for (const SolidGroup& group : groups)
    {
      names.push_back(this->Free(ValidName(group.Name, this->Rules)));
    }
    return names;
  }

private:
  std::string Free(const std::string& wanted)
  {
    std::string name = wanted;
    for (int count = 2; !this->Taken.insert(Essence(name, this->Rules)).second; ++count)
    {
      const std::string end = "_" + std::to_string(count);
      name = Beginning(wanted, this->Rules.Longest - end.size()) + end;
    }
    return name;
  }

  const NameRules Rules;
  std::set<std::string> Taken;
};
} // namespace

GroupNames ValidNames(
  const SolidMesh& solid, const NameRules& rules, const std::vector<std::string>& taken)
{
  Names names(rules, taken);
  GroupNames result;
  result.Regions = names.For(solid.Regions);
  result.Tags = names.For(solid.Tags);
  return result;
}

std::string PrintableText(const std::string& text)
{
  std::string printable;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = LengthOfCharacter(text, at);
    const char c = text[at];
    const bool isPlain = length == 1 && c >= ' ' && c <= '~' && c != '"' && c != '\\';
    printable += isPlain || length > 1 ? text.substr(at, length) : "_";
    at += std::max<std::size_t>(length, 1);
  }
  return printable;
}
} // namespace insideout
