// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFile.h"

#include <string>
#include <vector>

namespace insideout
{
/** What names a format takes. */
struct NameRules
{
  std::size_t Longest; ///< in bytes
  bool WordsOnly;      ///< a letter, then letters, digits and underscores, all of ASCII
  bool CaseCounts;     ///< whether `Wall` and `wall` are two names
};

/** The names of all groups as a format takes them. */
struct GroupNames
{
  std::vector<std::string> Regions;
  std::vector<std::string> Tags;
};

/**
 * Names for the groups of a solid, each another than all others, regions' and tags' alike, for some
 * formats and readers do not tell these apart. A character that is not valid becomes `_`, a name
 * that is too long is cut, and the later of equal names end in `_2`, `_3` and so on.
 *
 * @param[in] taken names that no group may have
 */
GroupNames ValidNames(
  const SolidMesh& solid, const NameRules& rules, const std::vector<std::string>& taken = {});

/** The text as valid UTF-8 in one line: bytes that are none, quotes, backslashes and what does not
 * print become `_`. */
std::string PrintableText(const std::string& text);
} // namespace insideout
