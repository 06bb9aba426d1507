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
  /** The name of the next polygons. */
  void Choose(const std::string& name);

  /** Whether any name was chosen, used or not. */
  bool Any() const { return this->AnyChosen; }

  /** The number of the name that was chosen last, which is used from now on. */
  std::int32_t Current();

  /** The names that were used, by their numbers. */
  const std::vector<std::string>& Used() const { return this->Names; }

private:
  std::string Name;
  std::int32_t Number = None;
  bool AnyChosen = false;
  std::map<std::string, std::int32_t> Numbers;
  std::vector<std::string> Names;
};

/**
 * OBJ's names of pairs of an object and a group in it, which a line end parts: the object's where
 * it tells all of them apart, else the group's where that does, else OBJECT/GROUP. Where one has no
 * name it is the other's, and default, as in OBJ, where neither has.
 */
std::vector<std::string> NamesOfGroups(const std::vector<std::string>& pairs);

/** The same for names alone. */
std::vector<std::string> NamesOrDefault(std::vector<std::string> names);

/** A text of unknown encoding in UTF-8: as it is where it is that already, else read as Latin-1. */
std::string ToUtf8(const std::string& text);
} // namespace insideout
