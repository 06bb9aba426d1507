// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Error.h"
#include "Files/ByteOrder.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>

namespace insideout
{
/** A file that is written through a buffer; what fails is an Error. */
class OutputFile
{
public:
  explicit OutputFile(const std::string& path)
    : Path(path)
    , File(std::fopen(path.c_str(), "wb"), &std::fclose)
  {
    this->FailUnless(this->File != nullptr);
    this->Buffer.reserve(BufferLength + 4096);
  }

  void Text(std::string_view text)
  {
    this->Buffer += text;
    if (this->Buffer.size() >= BufferLength)
    {
      this->Flush();
    }
  }

  /** The shortest text that is read back as the same number. */
  template <typename T>
  void Decimal(T value)
  {
    std::array<char, 32> text;
    const std::to_chars_result result =
      std::to_chars(text.data(), text.data() + text.size(), value);
    this->Text({ text.data(), static_cast<std::size_t>(result.ptr - text.data()) });
  }

  template <typename T>
  void Binary(T value)
  {
    std::array<char, sizeof(T)> bytes;
    StoreLittleEndian(bytes.data(), value);
    this->Text({ bytes.data(), bytes.size() });
  }

  /** Has to be called last: only then is everything known to be written. */
  void Close()
  {
    this->Flush();
    this->FailUnless(std::fclose(this->File.release()) == 0);
  }

private:
  static constexpr std::size_t BufferLength = std::size_t(1) << 20;

  void Flush()
  {
    const std::size_t written =
      std::fwrite(this->Buffer.data(), 1, this->Buffer.size(), this->File.get());
    this->FailUnless(written == this->Buffer.size());
    this->Buffer.clear();
  }

  void FailUnless(bool succeeded) const
  {
    if (!succeeded)
    {
      throw Error(
        ErrorCode::FileUnwritable, this->Path + ": " + std::generic_category().message(errno));
    }
  }

  const std::string Path;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> File;
  std::string Buffer;
};
} // namespace insideout
