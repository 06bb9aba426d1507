// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace insideout
{
/**
 * @class UnfinishedFile
 * @brief a new file under a temporary name, which ends by becoming another or not at all
 *
 * The name is `.insideout-`, the process's number and a count. Only a process that is killed leaves
 * such a file behind.
 */
class UnfinishedFile
{
public:
  /** Create it in a folder, with the permissions that new files get there.
   * @throws std::system_error */
  explicit UnfinishedFile(const std::string& folder);

  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  /** Close it, and remove it unless it became another. */
  ~UnfinishedFile();

  int GetDescriptor() const { return this->Descriptor; }

  /** Close it, with all that was written safely on the disk.
   * @throws std::system_error */
  void Close();

  /** When it is closed, put it in the place of another file in the folder, or of none.
   * @throws std::system_error, with the other file as it was */
  void Become(const std::string& path);

  /** Remove all that there are in this process, which is about to end: whoever begins or finishes
   * one from now on waits for that. */
  static void RemoveAllForGood();

private:
  std::string Path;
  int Descriptor = -1;
};
} // namespace insideout
