// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/UnfinishedFile.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <mutex>
#include <set>
#include <system_error>
#include <unistd.h>

namespace insideout
{
namespace
{
/** The unfinished files of this process. */
struct Registry
{
  std::mutex Mutex;
  std::set<std::string> Paths;
  unsigned long Created = 0;
};

/** Never destroyed: threads may still write while the process ends. */
Registry& GetRegistry()
{
  static auto* const registry = new Registry;
  return *registry;
}

void FailUnless(bool succeeded)
{
  if (!succeeded)
  {
    throw std::system_error(errno, std::generic_category());
  }
}
} // namespace

UnfinishedFile::UnfinishedFile(const std::string& folder)
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  const std::string prefix = folder + "/.insideout-" + std::to_string(getpid()) + "-";
  do
  {
    // The name may be taken by a process of another machine, or by a killed one.
    this->Path = prefix + std::to_string(registry.Created++);
    constexpr mode_t lessTheUmask = 0666;
    this->Descriptor =
      open(this->Path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, lessTheUmask);
  } while (this->Descriptor < 0 && (errno == EEXIST || errno == EINTR));
  FailUnless(this->Descriptor >= 0);
  registry.Paths.insert(this->Path);
}

UnfinishedFile::~UnfinishedFile()
{
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
  }
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  if (registry.Paths.erase(this->Path) > 0)
  {
    unlink(this->Path.c_str());
  }
}

void UnfinishedFile::Close()
{
  // Some file systems do not support fsync, and report that.
  FailUnless(fsync(this->Descriptor) == 0 || errno == EINVAL || errno == ENOTSUP);
  const int descriptor = this->Descriptor;
  this->Descriptor = -1;
  FailUnless(close(descriptor) == 0 || errno == EINTR);
}

void UnfinishedFile::Become(const std::string& path)
{
  Registry& registry = GetRegistry();
  const std::lock_guard<std::mutex> lock(registry.Mutex);
  FailUnless(std::rename(this->Path.c_str(), path.c_str()) == 0);
  registry.Paths.erase(this->Path);
}

void UnfinishedFile::RemoveAllForGood()
{
  Registry& registry = GetRegistry();
  registry.Mutex.lock();
  for (const std::string& path : registry.Paths)
  {
    unlink(path.c_str());
  }
}
} // namespace insideout
