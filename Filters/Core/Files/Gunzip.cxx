// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/Gunzip.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <string_view>

#define ZLIB_CONST
#include <zlib.h>

// The format: RFC 1952, GZIP file format specification (1996).

namespace insideout
{
namespace
{
constexpr std::string_view Magic = "\x1f\x8b";

std::string_view BytesBetween(const char* begin, const char* end)
{
  return { begin, static_cast<std::size_t>(end - begin) };
}

class Inflation
{
public:
  explicit Inflation(const FileContent& file)
    : File(file)
    , At(file.Begin())
  {
    constexpr int gzipOfAnyWindow = 15 + 16;
    if (inflateInit2(&this->Stream, gzipOfAnyWindow) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }

  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
  ~Inflation() { inflateEnd(&this->Stream); }

  /** Fill the buffer; less only at the end. @return the number of bytes */
  std::size_t Fill(char* room, std::size_t length)
  {
    std::size_t filled = 0;
    while (filled < length && !this->Ended)
    {
      filled += this->Inflate(room + filled, length - filled);
    }
    return filled;
  }

private:
  std::size_t Inflate(char* room, std::size_t length)
  {
    const auto left = static_cast<std::size_t>(this->File.End() - this->At);
    this->Stream.next_in = reinterpret_cast<const Bytef*>(this->At);
    this->Stream.avail_in = AsMuchAsPossible(left);
    this->Stream.next_out = reinterpret_cast<Bytef*>(room);
    this->Stream.avail_out = AsMuchAsPossible(length);
    const int result = inflate(&this->Stream, Z_NO_FLUSH);
    this->At = reinterpret_cast<const char*>(this->Stream.next_in);
    if (result == Z_STREAM_END)
    {
      this->GoToNextMember();
    }
    else if (result == Z_MEM_ERROR)
    {
      throw std::bad_alloc();
    }
    else if (result == Z_BUF_ERROR) // the buffer was not filled, so bytes are missing
    {
      throw Malformed(this->File, "is compressed with gzip, and its end is missing");
    }
    else if (result != Z_OK)
    {
      const char* const what = this->Stream.msg;
      throw Malformed(this->File,
        std::string("is compressed with gzip, and damaged") + (what ? ": " : "") +
          (what ? what : ""));
    }
    return static_cast<std::size_t>(reinterpret_cast<char*>(this->Stream.next_out) - room);
  }

  /** A file may have several members; zeros pad the blocks of tapes. */
  void GoToNextMember()
  {
    const std::string_view rest = BytesBetween(this->At, this->File.End());
    if (rest.find_first_not_of('\0') == std::string_view::npos)
    {
      this->Ended = true;
    }
    else if (rest.substr(0, Magic.size()) == Magic)
    {
      inflateReset(&this->Stream);
    }
    else
    {
      throw Malformed(this->File,
        std::to_string(rest.size()) + " bytes after the compressed content are ignored");
    }
  }

  static uInt AsMuchAsPossible(std::size_t length)
  {
    return static_cast<uInt>(std::min<std::size_t>(length, std::numeric_limits<uInt>::max()));
  }

  const FileContent& File;
  const char* At;
  z_stream Stream = {};
  bool Ended = false;
};

/** The length of the content, after checking that it is complete and within the limit. */
std::size_t LengthOfContent(const FileContent& file, double most, Monitor& monitor)
{
  std::vector<char> room(std::size_t(1) << 20);
  Inflation inflation(file);
  std::size_t length = 0;
  for (std::size_t got = room.size(); got == room.size(); length += got)
  {
    file.ReportPosition(file.Begin(), monitor);
    got = inflation.Fill(room.data(), room.size());
    if (static_cast<double>(length + got) > most)
    {
      throw Error(ErrorCode::TooLarge,
        file.Name + ": is compressed with gzip, and holds more than " +
          std::to_string(static_cast<std::uint64_t>(most)) + " bytes, too many for this machine");
    }
  }
  return length;
}
} // namespace

bool IsGzip(const FileContent& file)
{
  return BytesBetween(file.Begin(), file.End()).substr(0, Magic.size()) == Magic;
}

FileContent Gunzip(const FileContent& file, double most, Monitor& monitor)
{
  constexpr std::size_t piece = std::size_t(1) << 24;
  FileContent content;
  content.Name = file.Name;
  const std::size_t length = LengthOfContent(file, most, monitor);
  content.Bytes.reset(new char[length]);
  Inflation inflation(file);
  while (content.Size < length)
  {
    file.ReportPosition(file.Begin(), monitor);
    content.Size +=
      inflation.Fill(content.Bytes.get() + content.Size, std::min(piece, length - content.Size));
  }
  return content;
}
} // namespace insideout
