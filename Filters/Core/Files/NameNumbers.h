// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <map>
#include <string>
#include <vector>

namespace insideout
{
/** Numbers names in the order in which polygons first use them. */
class NameNumbers
{
public:
  /** Set the name of the next polygons. */
  void Choose(const std::string& name);

  /** Whether any name was set, used or not. */
  bool Any() const { return this->AnyChosen; }

  /** The number of the last name set, marked as used. */
  std::int32_t Current();

  /** The used names, by number. */
  const std::vector<std::string>& Used() const { return this->Names; }

private:
  std::string Name;
  std::int32_t Number = None;
  bool AnyChosen = false;
  std::map<std::string, std::int32_t> Numbers;
  std::vector<std::string> Names;
};

/**
 * OBJ's names of pairs of an object and a group in it, separated by a line end: the object's if it
 * is unique, else the group's if that is unique, else OBJECT/GROUP. If one has no name the other's
 * is taken; if neither has, it is `default`, as in OBJ.
 */
std::vector<std::string> NamesOfGroups(const std::vector<std::string>& pairs);

/** The same for single names. */
std::vector<std::string> NamesOrDefault(std::vector<std::string> names);

/** A text of unknown encoding as UTF-8: unchanged if it is valid UTF-8, else read as Latin-1. */
std::string ToUtf8(const std::string& text);
} // namespace insideout
