// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace insideout
{
/**
 * Reads words and numbers from a text that may end anywhere, and counts lines. Lines end with LF,
 * CR LF or CR. Numbers do not depend on the locale and are rounded correctly. Reading never goes
 * beyond the text.
 */
class TextScanner
{
public:
  struct Syntax
  {
    bool Comments = false;     ///< a `#` begins a comment, up to the end of the line
    bool Continuation = false; ///< a backslash joins a line with the next
  };

  /** Scan `file` from `begin` (a byte of it, on line `line`) to its end. */
  TextScanner(
    const FileContent& file, const char* begin, std::int64_t line, Syntax syntax, Monitor& monitor);

  /** The line of the next byte, counted from 1. */
  std::int64_t GetLine() const { return this->Line; }

  /** The next byte. */
  const char* Position() const { return this->At; }

  /** The number of bytes left. */
  std::uint64_t Left() const { return static_cast<std::uint64_t>(this->End - this->At); }

  /** Whether at least `count` lines are left that are neither blank nor a comment. */
  bool HasLines(std::uint64_t count) const;

  /** Skip blanks; true if the rest of the line is empty or a comment. */
  bool AtLineEnd();

  /** Go to the beginning of the next line. */
  void SkipLine();

  /** Skip blanks, comments and line ends; false at the end of the text. */
  bool SkipToContent();

  /** The next word on the line; empty at its end. */
  std::string_view Word();

  /** The remaining words of the line, separated by single blanks. */
  std::string RestOfLine();

  /**
   * The next number on the line. Overflow becomes infinite, underflow 0.
   * @throws Error FileMalformed if there is none
   */
  double Number();

  /** The number at the beginning of the next word, for numbers separated by commas. */
  double LeadingNumber();

  /**
   * The next number on the line, which has to be an integer.
   * @throws Error FileMalformed if there is none
   */
  std::int64_t Integer();

  /** The integer at the beginning of the next word, for words such as 1/2/3; see ExpectWordEnd. */
  std::int64_t LeadingInteger();

  /** Skip the next byte if it is `c`. */
  bool Accept(char c);

  /** Whether a blank, a line end or a comment comes next. */
  bool AtWordEnd() const { return this->EndsWord(this->At); }

  /** @throws Error FileMalformed unless AtWordEnd() */
  void ExpectWordEnd() const;

  /** @throws Error FileMalformed: the file's name, the current line, then `what` */
  [[noreturn]] void Fail(const std::string& what) const;

private:
  bool EndsWord(const char* at) const;
  bool IsContinuation(const char* at) const;
  void SkipBlanks();
  void ConsumeNewline();
  [[noreturn]] void FailAtWord(const char* expected, const char* word) const;

  const FileContent& File;
  const char* At;
  const char* const End;
  std::int64_t Line;
  const Syntax Rules;
  Monitor& Watch;
};

/** The text in quotes, for messages: shortened, without non-printing characters. */
std::string Quoted(std::string_view text);

/** Whether two words are equal up to the case of ASCII letters; `lower` is in lower case. */
bool EqualsIgnoringCase(std::string_view word, std::string_view lower);
} // namespace insideout
