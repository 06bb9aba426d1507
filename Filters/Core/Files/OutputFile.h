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
 * @brief a file that is written whole or not at all
 *
 * It is written beside its final name and put there when it is closed: until then, and whatever
 * fails, an earlier file of that name stays as it was. A symbolic link stays, and what it leads to
 * is replaced; permissions and, where the user may give it away, the owner of an earlier file are
 * kept. Devices, pipes and descriptors (`/dev/stdout`) cannot be replaced: they are written at
 * once.
 *
 * A failure is an Error FileUnwritable, with the file and the system's reason. The monitor is told
 * of Stages::Writing, and may stop the writing until the file is in its place.
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

  /** Has to be called last: only then is the file there. */
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

  const std::string Path; ///< as the user gave it
  Monitor& Progress;
  std::string Target;                   ///< what the path leads to
  std::optional<UnfinishedFile> Beside; ///< what is to take the target's place
  int Descriptor = -1;                  ///< of that, or of a target that cannot be replaced
  std::string Buffer;
};
} // namespace insideout
