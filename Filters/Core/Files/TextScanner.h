// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SurfaceReaders.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace insideout
{
/**
 * Reads words and numbers from a text that ends anywhere, and knows the line it is on. Lines end
 * with LF, CR LF or CR. Numbers do not depend on the locale and are rounded correctly. Nothing here
 * reads beyond the text, whatever is in it.
 */
class TextScanner
{
public:
  struct Syntax
  {
    bool Comments = false;     ///< a `#` begins a comment, which the end of the line ends
    bool Continuation = false; ///< a backslash joins a line with the next
  };

  /** Scan `file` from `begin` (a byte of it, on line `line`) to its end. */
  TextScanner(
    const FileContent& file, const char* begin, std::int64_t line, Syntax syntax, Monitor& monitor);

  /** The line of the next byte, counted from 1. */
  std::int64_t GetLine() const { return this->Line; }

  /** The next byte. */
  const char* Position() const { return this->At; }

  /** The bytes that are left. */
  std::uint64_t Left() const { return static_cast<std::uint64_t>(this->End - this->At); }

  /** Whether at least `count` lines are left that are neither blank nor a comment. */
  bool HasLines(std::uint64_t count) const;

  /** Skip blanks; true when nothing else is left on the line, comments aside. */
  bool AtLineEnd();

  /** Go to the beginning of the next line. */
  void SkipLine();

  /** Skip blanks, comments and line ends; false when nothing else is left. */
  bool SkipToContent();

  /** The next word on the line; empty at its end. */
  std::string_view Word();

  /** The words that are left on the line, with single blanks. */
  std::string RestOfLine();

  /**
   * The next number on the line. What does not fit a double becomes infinite or 0.
   * @throws Error FileMalformed when there is none
   */
  double Number();

  /** The number that the next word begins with, for numbers that commas part. */
  double LeadingNumber();

  /**
   * The next number on the line, which has to be an integer.
   * @throws Error FileMalformed when there is none
   */
  std::int64_t Integer();

  /** The integer that the next word begins with, for words such as 1/2/3; see ExpectWordEnd. */
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

/** The text in quotes, for messages: shortened, and without what does not print. */
std::string Quoted(std::string_view text);

/** Whether two words are the same but for the case of ASCII letters; `lower` is in lower case. */
bool EqualsIgnoringCase(std::string_view word, std::string_view lower);
} // namespace insideout
