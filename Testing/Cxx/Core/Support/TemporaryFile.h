// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace testfiles
{
/** A file in the temporary folder that no other test uses, and that is removed in the end. */
class TemporaryFile
{
public:
  /** The file is called `name`, behind something unique. It exists once it is written. */
  explicit TemporaryFile(const std::string& name)
    : Name(UniquePrefix() + name)
    , Path(testing::TempDir() + Name)
  {
  }

  TemporaryFile(const std::string& name, const std::string& content)
    : TemporaryFile(name)
  {
    this->Write(content);
  }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::remove(this->Path.c_str()); }

  void Write(const std::string& content) const
  {
    // A file system may wait for the disk when a file is overwritten, but not when it is new.
    std::remove(this->Path.c_str());
    std::ofstream(this->Path, std::ios::binary)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
  }

  std::string Read() const
  {
    std::ifstream file(this->Path, std::ios::binary);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }

  const std::string Name;
  const std::string Path;

private:
  static std::string UniquePrefix()
  {
    static int count = 0;
    return "insideout-" + std::to_string(getpid()) + "-" + std::to_string(count++) + "-";
  }
};
} // namespace testfiles
