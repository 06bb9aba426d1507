// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Reads options that are lists of rules in text, separated by semicolons. */
#pragma once

#include <string>
#include <vector>

namespace insideout
{
/** The parts of a text between separators; one part without any. */
std::vector<std::string> SplitText(const std::string& text, char separator);

/** The text without blanks at its ends. */
std::string Trimmed(const std::string& text);

/** The first word of a trimmed text, and what follows that. */
struct HeadAndTail
{
  std::string Head;
  std::string Tail;
};
HeadAndTail SplitHead(const std::string& trimmed);

/** @throws Error InvalidParameter, that names the rule */
[[noreturn]] void RefuseRule(const std::string& rule, const std::string& words);

/**
 * Finite numbers separated by blanks or commas.
 * @throws Error that names the rule and the invalid number
 */
std::vector<double> NumbersOf(const std::string& text, const std::string& rule);
} // namespace insideout
