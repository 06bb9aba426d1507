// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/NameNumbers.h"

#include <algorithm>
#include <set>

namespace insideout
{
namespace
{
/** The number of bytes of the UTF-8 character at `at`, 0 if it is invalid. */
std::size_t LengthInUtf8(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned first = byte(at);
  const std::size_t length = first < 0x80 ? 1
    : first >= 0xC2 && first < 0xE0       ? 2
    : first >= 0xE0 && first < 0xF0       ? 3
    : first >= 0xF0 && first < 0xF5       ? 4
                                          : 0;
  for (std::size_t i = 1; i < length; ++i)
  {
    if (byte(at + i) >> 6 != 2)
    {
      return 0;
    }
  }
  // Some sequences of three and four bytes are overlong, surrogates, or beyond Unicode.
  const unsigned second = byte(at + 1);
  const bool isNone = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
    (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return isNone ? 0 : length;
}

bool IsUtf8(const std::string& text)
{
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = LengthInUtf8(text, at);
    if (length == 0)
    {
      return false;
    }
    at += length;
  }
  return true;
}
} // namespace

void NameNumbers::Choose(const std::string& name)
{
  this->Name = name;
  this->Number = None;
  this->AnyChosen = true;
}

std::int32_t NameNumbers::Current()
{
  if (this->Number == None)
  {
    const auto next = static_cast<std::int32_t>(this->Names.size());
    const auto [found, isNew] = this->Numbers.insert({ this->Name, next });
    this->Number = found->second;
    if (isNew)
    {
      this->Names.push_back(this->Name);
    }
  }
  return this->Number;
}

std::vector<std::string> NamesOfGroups(const std::vector<std::string>& pairs)
{
  std::vector<std::string> byObject;
  std::vector<std::string> byGroup;
  std::vector<std::string> byBoth;
  for (const std::string& pair : pairs)
  {
    const std::size_t end = std::min(pair.find('\n'), pair.size());
    const std::string object = pair.substr(0, end);
    const std::string group = pair.substr(std::min(end + 1, pair.size()));
    byObject.push_back(object.empty() ? group : object);
    byGroup.push_back(group.empty() ? object : group);
    byBoth.push_back(object + (object.empty() || group.empty() ? "" : "/") + group);
  }
  for (std::vector<std::string>* names : { &byObject, &byGroup })
  {
    if (std::set<std::string>(names->begin(), names->end()).size() == names->size())
    {
      return NamesOrDefault(std::move(*names));
    }
  }
  return NamesOrDefault(std::move(byBoth));
}

std::vector<std::string> NamesOrDefault(std::vector<std::string> names)
{
  std::replace(names.begin(), names.end(), std::string(), std::string("default"));
  return names;
}

std::string ToUtf8(const std::string& text)
{
  if (IsUtf8(text))
  {
    return text;
  }
  std::string encoded;
  for (const char c : text)
  {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80)
    {
      encoded += c;
      continue;
    }
    encoded += static_cast<char>(0xC0 | (byte >> 6));
    encoded += static_cast<char>(0x80 | (byte & 0x3F));
  }
  return encoded;
}
} // namespace insideout
