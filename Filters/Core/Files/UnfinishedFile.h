// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace insideout
{
/**
 * @class UnfinishedFile
 * @brief a new file under a temporary name, finally renamed or removed
 *
 * The name is `.insideout-`, the process's number and a count. Only a killed process leaves such a
 * file behind.
 */
class UnfinishedFile
{
public:
  /** Create it in a folder, with the permissions that new files get there.
   * @throws std::system_error */
  explicit UnfinishedFile(const std::string& folder);

  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  /** Close it, and remove it unless it was renamed. */
  ~UnfinishedFile();

  int GetDescriptor() const { return this->Descriptor; }

  /** Close it, with all data safely on the disk.
   * @throws std::system_error
   */
  void Close();

  /** After closing, rename it to another name in the folder, replacing any file of that name.
   * @throws std::system_error, with the other file unchanged
   */
  void Become(const std::string& path);

  /** Remove all unfinished files of this process, which is about to end; calls that begin or finish
   * one wait from now on. */
  static void RemoveAllForGood();

private:
  std::string Path;
  int Descriptor = -1;
};
} // namespace insideout
