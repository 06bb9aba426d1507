// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFile.h"

#include <string>
#include <vector>

namespace insideout
{
/** The names that a format allows. */
struct NameRules
{
  std::size_t Longest; ///< limit of bytes
  bool WordsOnly;      ///< a letter, then letters, digits and underscores, all of ASCII
  bool CaseCounts;     ///< whether `Wall` and `wall` are different names
};

/** The names of all groups as valid in a format. */
struct GroupNames
{
  std::vector<std::string> Regions;
  std::vector<std::string> Tags;
};

/**
 * Unique names for the groups of a solid. They are unique among regions and tags together, because
 * some formats and readers do not distinguish these. An invalid character becomes `_`, a too long
 * name is truncated, and the later of equal names get the suffixes `_2`, `_3` and so on.
 *
 * @param[in] taken names that no group may have
 */
GroupNames ValidNames(
  const SolidMesh& solid, const NameRules& rules, const std::vector<std::string>& taken = {});

/** The text as valid UTF-8 in one line: invalid bytes, quotes, backslashes and non-printing
 * characters become `_`. */
std::string PrintableText(const std::string& text);
} // namespace insideout
