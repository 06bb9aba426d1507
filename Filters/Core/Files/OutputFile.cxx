// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/OutputFile.h"

#include "Common/Stages.h"

#include <cerrno>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <new>
#include <poll.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace insideout
{
namespace
{
namespace fs = std::filesystem;

/** Whether a link is `/proc/self/fd/1` or the like, which stands for an open file. */
bool IsDescriptor(const fs::path& link)
{
  std::error_code ignored;
  return fs::equivalent(link.parent_path(), "/proc/self/fd", ignored);
}

/** The target of a path after resolving all links; it need not exist. */
fs::path FollowLinks(fs::path path)
{
  constexpr int longestChain = 40; // Linux's limit
  for (int links = 0; fs::is_symlink(fs::symlink_status(path)); ++links)
  {
    if (IsDescriptor(path))
    {
      return path;
    }
    if (links == longestChain)
    {
      throw std::system_error(ELOOP, std::generic_category());
    }
    path = path.parent_path() / fs::read_symlink(path); // an absolute path replaces the folder
  }
  return path;
}

/**
 * Blocks the signals that would end the process on writing beyond a limit or to a closed pipe: for
 * this thread, so that write() reports the error instead.
 */
class HeldBackSignals
{
public:
  HeldBackSignals()
  {
    sigset_t pending;
    sigpending(&pending);
    sigemptyset(&this->Ours);
    for (const int signal : { SIGXFSZ, SIGPIPE })
    {
      if (!sigismember(&pending, signal))
      {
        sigaddset(&this->Ours, signal);
      }
    }
    pthread_sigmask(SIG_BLOCK, &this->Ours, &this->Before);
  }

  HeldBackSignals(const HeldBackSignals&) = delete;
  HeldBackSignals& operator=(const HeldBackSignals&) = delete;

  ~HeldBackSignals()
  {
    const int error = errno;
    const timespec now = {};
    while (sigtimedwait(&this->Ours, nullptr, &now) > 0 || errno == EINTR)
    {
    }
    pthread_sigmask(SIG_SETMASK, &this->Before, nullptr);
    errno = error;
  }

private:
  sigset_t Ours;
  sigset_t Before;
};
} // namespace

OutputFile::OutputFile(const std::string& path, Monitor& monitor)
  : Path(path)
  , Progress(monitor)
{
  try
  {
    this->Buffer.reserve(BufferLength + 4096);
    this->Open();
  }
  catch (const std::system_error& error) // also errors of the file system
  {
    this->Fail(error.code().value());
  }
}

OutputFile::~OutputFile()
{
  if (!this->Beside && this->Descriptor >= 0)
  {
    close(this->Descriptor);
  }
}

void OutputFile::Open()
{
  const fs::path target = FollowLinks(fs::absolute(this->Path));
  this->Target = target.string();
  const fs::file_status status = fs::status(target);
  if (fs::is_directory(status))
  {
    this->Fail(EISDIR);
  }
  if (fs::is_symlink(fs::symlink_status(target)) ||
    (fs::exists(status) && !fs::is_regular_file(status)))
  {
    this->OpenInPlace();
  }
  else
  {
    this->OpenBeside();
  }
}

void OutputFile::OpenInPlace()
{
  const fs::path target = this->Target;
  if (IsDescriptor(target))
  {
    // Reopened, a file would be written from its beginning, over its content.
    this->Descriptor = fcntl(std::stoi(target.filename().string()), F_DUPFD_CLOEXEC, 0);
  }
  else
  {
    // Opening a pipe waits for its reader.
    while ((this->Descriptor = open(target.c_str(), O_WRONLY | O_CLOEXEC)) < 0 && errno == EINTR)
    {
      this->CheckMonitor(0);
    }
  }
  if (this->Descriptor < 0)
  {
    this->Fail(errno);
  }
}

void OutputFile::OpenBeside()
{
  struct stat earlier;
  const bool exists = stat(this->Target.c_str(), &earlier) == 0;
  if (exists && faccessat(AT_FDCWD, this->Target.c_str(), W_OK, AT_EACCESS) != 0)
  {
    this->Fail(errno);
  }
  this->Beside.emplace(fs::path(this->Target).parent_path().string());
  this->Descriptor = this->Beside->GetDescriptor();
  if (exists)
  {
    // Only some users may change the owner; others keep the group if they can. Permissions are set
    // last, because a change of the owner clears some.
    constexpr auto same = static_cast<uid_t>(-1);
    static_cast<void>(fchown(this->Descriptor, earlier.st_uid, earlier.st_gid) == 0 ||
      fchown(this->Descriptor, same, earlier.st_gid) == 0);
    constexpr mode_t permissions = 0777;
    if (fchmod(this->Descriptor, earlier.st_mode & permissions) != 0)
    {
      this->Fail(errno);
    }
  }
}

void OutputFile::Close()
{
  this->Flush();
  if (!this->Beside)
  {
    const int descriptor = this->Descriptor;
    this->Descriptor = -1;
    if (close(descriptor) != 0 && errno != EINTR)
    {
      this->Fail(errno);
    }
    return;
  }
  try
  {
    this->Beside->Close();
    this->CheckMonitor(1);
    this->Beside->Become(this->Target);
  }
  catch (const std::system_error& error)
  {
    this->Fail(error.code().value());
  }
}

void OutputFile::Flush()
{
  for (std::string_view rest = this->Buffer; !rest.empty();)
  {
    this->CheckMonitor(0);
    rest.remove_prefix(this->WriteSome(rest));
  }
  this->Buffer.clear();
}

std::size_t OutputFile::WriteSome(std::string_view text)
{
  const HeldBackSignals signals;
  const ssize_t written = write(this->Descriptor, text.data(), text.size());
  if (written > 0)
  {
    return static_cast<std::size_t>(written);
  }
  if (written < 0 && errno == EAGAIN)
  {
    this->WaitUntilWritable();
  }
  else if (written == 0 || errno != EINTR)
  {
    this->Fail(written == 0 ? EIO : errno);
  }
  return 0;
}

void OutputFile::WaitUntilWritable()
{
  constexpr int betweenChecks = 200; // milliseconds between calls of the monitor
  pollfd pipe = { this->Descriptor, POLLOUT, 0 };
  poll(&pipe, 1, betweenChecks);
}

void OutputFile::CheckMonitor(double fraction)
{
  this->Progress.Check(Stages::Writing, fraction);
}

void OutputFile::Fail(int error) const
{
  throw Error(
    ErrorCode::FileUnwritable, this->Path + ": " + std::generic_category().message(error));
}
} // namespace insideout
