// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Files/ByteOrder.h"
#include "Files/UnfinishedFile.h"

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace insideout
{
/**
 * @class OutputFile
 * @brief a file that is written atomically
 *
 * It is written next to its final name and renamed when it is closed: until then, and on any error,
 * an earlier file of that name stays unchanged. A symbolic link stays, and its target is replaced.
 * Permissions of an earlier file are kept, and its owner if the user may set it. Devices, pipes and
 * descriptors (`/dev/stdout`) cannot be replaced: they are written directly.
 *
 * A failure is an Error FileUnwritable, with the file and the system's reason. The monitor gets
 * Stages::Writing, and may stop the writing until the file is in place.
 */
class OutputFile
{
public:
  OutputFile(const std::string& path, Monitor& monitor);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  void Text(std::string_view text)
  {
    this->Buffer += text;
    if (this->Buffer.size() >= BufferLength)
    {
      this->Flush();
    }
  }

  /** The shortest text that reads back as the same number. */
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

  /** Has to be called last: only then the file exists. */
  void Close();

private:
  static constexpr std::size_t BufferLength = std::size_t(1) << 20;

  void Open();
  void OpenInPlace();
  void OpenBeside();
  void Flush();
  std::size_t WriteSome(std::string_view text);
  void WaitUntilWritable();
  void CheckMonitor(double fraction);
  [[noreturn]] void Fail(int error) const;

  const std::string Path; ///< as given by the user
  Monitor& Progress;
  std::string Target;                   ///< target of the path
  std::optional<UnfinishedFile> Beside; ///< the file that replaces the target
  /// descriptor of that, or of a target that cannot be replaced
  int Descriptor = -1;
  std::string Buffer;
};
} // namespace insideout
