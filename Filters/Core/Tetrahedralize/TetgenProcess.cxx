// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/TetgenProcess.h"

#include "Common/Stages.h"
#include "Tetrahedralize/TetgenProtocol.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <system_error>

#include <dlfcn.h>
#include <link.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace insideout
{
namespace
{
using namespace tetgenprotocol;
using Clock = std::chrono::steady_clock;

/** Polling interval: stops are noticed well within a second. */
constexpr int MillisecondsBetweenChecks = 50;
/** Time that a helper has to end after closing its output before it is killed. */
constexpr std::chrono::seconds GraceToEnd(1);
/** Memory allocated ahead of the received data, regardless of the length that the answer claims. */
constexpr std::size_t LargestLeap = std::size_t(1) << 24;
/** TetGen's usual time per point and facet; for the progress bar only. */
constexpr double SecondsPerElement = 1e-5;
/**
 * Inverse of the least share of a processor that a running helper uses: below it, the helper is
 * blocked.
 */
constexpr double MostSecondsPerProcessorSecond = 100;

[[noreturn]] void ThrowDied(const std::string& what)
{
  throw Error(ErrorCode::TetrahedralizerDied, "insideout-tetgen " + what);
}

[[noreturn]] void ThrowBudget(const std::string& what, double budget, const std::string& unit)
{
  char number[32];
  std::snprintf(number, sizeof(number), "%.4g", budget);
  throw Error(ErrorCode::TetrahedralizerFailed,
    "insideout-tetgen " + what + " more than the " + number + " " + unit + " that it may");
}

std::string ErrorText(int number)
{
  return std::generic_category().message(number);
}

// --- Where the helper is -------------------------------------------------------------------------

std::string RealPath(const std::string& path)
{
  char* resolved = realpath(path.c_str(), nullptr);
  const std::string result = resolved ? resolved : "";
  std::free(resolved);
  return result;
}

/** The library or program that holds this code. */
std::string PathOfThisCode()
{
  Dl_info info;
  link_map* map = nullptr;
  if (!dladdr1(reinterpret_cast<void*>(&PathOfThisCode), &info, reinterpret_cast<void**>(&map),
        RTLD_DL_LINKMAP))
  {
    return "";
  }
  // argv[0] is unreliable, so the main program has no name here.
  return RealPath(map && map->l_name[0] ? map->l_name : "/proc/self/exe");
}

/** The path without its last component; empty if nothing is left. */
std::string FolderOf(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::string FindHelper()
{
  const char* named = std::getenv("INSIDEOUT_TETGEN");
  if (named && *named)
  {
    return named;
  }
  const std::string code = PathOfThisCode();
  std::string folder = FolderOf(code);
  for (int level = 0; level <= 5; ++level)
  {
    const std::string path = folder + "/libexec/insideout-tetgen";
    if (access(path.c_str(), X_OK) == 0)
    {
      return path;
    }
    if (folder.empty())
    {
      break;
    }
    folder = FolderOf(folder);
  }
  ThrowDied("cannot be started: looked in libexec beside " + code +
    " and in the five folders above; the environment variable INSIDEOUT_TETGEN may name it");
}

// --- The helper as a process ---------------------------------------------------------------------

class Descriptor
{
public:
  explicit Descriptor(int number)
    : Number(number)
  {
  }
  ~Descriptor() { this->Close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void Close()
  {
    if (this->Number >= 0)
    {
      close(this->Number);
      this->Number = -1;
    }
  }

  int Number;
};

/** Attributes for posix_spawn: socket on input and output, default signals. */
class SpawnSettings
{
public:
  explicit SpawnSettings(int socket)
  {
    posix_spawn_file_actions_init(&this->Actions);
    posix_spawnattr_init(&this->Attributes);
    posix_spawn_file_actions_adddup2(&this->Actions, socket, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&this->Actions, socket, STDOUT_FILENO);
    sigset_t none;
    sigset_t all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&this->Attributes, &none);
    posix_spawnattr_setsigdefault(&this->Attributes, &all);
    // A process group of its own: the caller handles Ctrl-C, and one kill ends all its processes.
    posix_spawnattr_setpgroup(&this->Attributes, 0);
    posix_spawnattr_setflags(
      &this->Attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  }
  ~SpawnSettings()
  {
    posix_spawn_file_actions_destroy(&this->Actions);
    posix_spawnattr_destroy(&this->Attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  posix_spawn_file_actions_t Actions;
  posix_spawnattr_t Attributes;
};

/** A running helper; the destructor kills and reaps it at the latest. */
class Helper
{
public:
  Helper(const std::string& path, int socket)
  {
    const SpawnSettings settings(socket);
    std::string name = "insideout-tetgen";
    char* arguments[] = { &name[0], nullptr };
    const int failure = posix_spawn(
      &this->Process, path.c_str(), &settings.Actions, &settings.Attributes, arguments, environ);
    if (failure)
    {
      ThrowDied("cannot be started: " + path + ": " + ErrorText(failure));
    }
  }
  ~Helper()
  {
    if (!this->Ended)
    {
      this->Reap();
    }
  }
  Helper(const Helper&) = delete;
  Helper& operator=(const Helper&) = delete;

  bool HasEnded()
  {
    if (!this->Ended)
    {
      siginfo_t info{};
      const int peek =
        waitid(P_PID, static_cast<id_t>(this->Process), &info, WEXITED | WNOHANG | WNOWAIT);
      // ECHILD: the caller ignores SIGCHLD or reaps every child itself, so the helper has ended,
      // too.
      if (peek == 0 ? info.si_pid != 0 : errno == ECHILD)
      {
        this->Reap();
      }
    }
    return this->Ended;
  }

  double ProcessorSeconds() const
  {
    clockid_t clock;
    timespec time{};
    if (clock_getcpuclockid(this->Process, &clock) != 0 || clock_gettime(clock, &time) != 0)
    {
      return 0;
    }
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  /** MiB held in memory and swap; 0 without /proc. */
  double Memory() const
  {
    std::ifstream status("/proc/" + std::to_string(this->Process) + "/status");
    double kibibytes = 0;
    for (std::string word; status >> word;)
    {
      double value;
      if ((word == "VmRSS:" || word == "VmSwap:") && status >> value)
      {
        kibibytes += value;
      }
    }
    return kibibytes / 1024;
  }

  /** How a helper that closed its output ended. */
  std::string DescribeEnd()
  {
    const Clock::time_point patience = Clock::now() + GraceToEnd;
    while (!this->HasEnded())
    {
      if (Clock::now() > patience)
      {
        return "closed its output before answering";
      }
      poll(nullptr, 0, 1);
    }
    if (WIFSIGNALED(this->Status))
    {
      const int signal = WTERMSIG(this->Status);
      const char* words = sigdescr_np(signal);
      return "was ended by signal " + std::to_string(signal) + " (" + (words ? words : "unknown") +
        ")";
    }
    return "exited with status " + std::to_string(WEXITSTATUS(this->Status)) + " before answering";
  }

private:
  /** Kill the whole group: until the helper is reaped, no other group can have its number. */
  void Reap()
  {
    kill(-this->Process, SIGKILL);
    while (waitpid(this->Process, &this->Status, 0) < 0 && errno == EINTR)
    {
    }
    this->Ended = true;
  }

  pid_t Process = -1;
  int Status = 0;
  bool Ended = false;
};

// --- The exchange --------------------------------------------------------------------------------

/** Thrown and caught in this file when the answer ends too early. */
struct EndOfAnswer
{
};

struct Bytes
{
  const char* Data;
  std::size_t Size;
};

/** Send and receive alternately: otherwise both sides could wait for each other. */
class Conversation
{
public:
  Conversation(int socket, Helper& helper, std::vector<Bytes> request,
    const TetrahedralizerBudget& budget, double expectedSeconds, Monitor& monitor)
    : Socket(socket)
    , Child(helper)
    , Unsent(std::move(request))
    , Budget(budget)
    , ExpectedSeconds(expectedSeconds)
    , Caller(monitor)
  {
  }

  void Receive(void* data, std::size_t size)
  {
    char* to = static_cast<char*>(data);
    while (size > 0)
    {
      this->CheckNowAndThen();
      const bool quiet = this->WaitForSocket();
      const ssize_t got = recv(this->Socket, to, size, MSG_DONTWAIT);
      if (got > 0)
      {
        to += got;
        size -= static_cast<std::size_t>(got);
      }
      else if (got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR))
      {
        throw EndOfAnswer();
      }
      else if (quiet && this->ChildEndedBefore)
      {
        // A process that the caller forked meanwhile may keep the helper's end open.
        throw EndOfAnswer();
      }
      else
      {
        this->ChildEndedBefore = quiet && this->Child.HasEnded();
      }
      this->Send();
    }
  }

  /** An array of a length claimed by the helper: memory grows only with the data received. */
  template <typename T>
  void Receive(std::vector<T>& array, std::int64_t count)
  {
    const std::size_t end = static_cast<std::size_t>(count);
    while (array.size() < end)
    {
      const std::size_t begin = array.size();
      const std::size_t leap = std::max(LargestLeap / sizeof(T), begin);
      array.resize(std::min(end, begin + leap));
      this->Receive(array.data() + begin, (array.size() - begin) * sizeof(T));
    }
  }

private:
  /** @return whether the interval passed without any event */
  bool WaitForSocket()
  {
    pollfd watch = { this->Socket, POLLIN, 0 };
    if (!this->Unsent.empty())
    {
      watch.events |= POLLOUT;
    }
    return poll(&watch, 1, MillisecondsBetweenChecks) == 0;
  }

  void Send()
  {
    while (!this->Unsent.empty())
    {
      Bytes& next = this->Unsent.front();
      const ssize_t put = send(this->Socket, next.Data, next.Size, MSG_DONTWAIT | MSG_NOSIGNAL);
      if (put < 0)
      {
        if (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)
        {
          // The helper stopped reading; receiving finds the reason.
          this->Unsent.clear();
        }
        return;
      }
      next.Data += put;
      next.Size -= static_cast<std::size_t>(put);
      if (next.Size == 0)
      {
        this->Unsent.erase(this->Unsent.begin());
      }
    }
  }

  void CheckNowAndThen()
  {
    const Clock::time_point now = Clock::now();
    if (now >= this->NextCheck)
    {
      this->NextCheck = now + std::chrono::milliseconds(MillisecondsBetweenChecks);
      const double seconds = std::chrono::duration<double>(now - this->Start).count();
      // TetGen reports no progress.
      this->Caller.Check(Stages::Tetrahedralizing, seconds / (seconds + this->ExpectedSeconds));
      const double mostSeconds = std::min(
        this->Budget.Seconds, MostSecondsPerProcessorSecond * this->Budget.ProcessorSeconds);
      if (seconds > mostSeconds)
      {
        ThrowBudget("took", mostSeconds, "s");
      }
      if (this->Child.ProcessorSeconds() > this->Budget.ProcessorSeconds)
      {
        ThrowBudget("computed", this->Budget.ProcessorSeconds, "s");
      }
      if (this->Child.Memory() > this->Budget.Mebibytes)
      {
        ThrowBudget("held", this->Budget.Mebibytes, "MiB");
      }
    }
  }

  const int Socket;
  Helper& Child;
  std::vector<Bytes> Unsent;
  const TetrahedralizerBudget Budget;
  const double ExpectedSeconds;
  Monitor& Caller;
  const Clock::time_point Start = Clock::now();
  Clock::time_point NextCheck = Start;
  bool ChildEndedBefore = false;
};

[[noreturn]] void ThrowMalformed(const std::string& what)
{
  ThrowDied("sent a malformed answer: " + what);
}

void CheckHeader(const AnswerHeader& header, std::size_t sentPoints)
{
  if (header.Magic != AnswerMagic)
  {
    ThrowMalformed("it does not begin with the protocol's mark");
  }
  const auto checkCount =
    [](const char* name, std::int64_t count, std::int64_t least, std::int64_t most)
  {
    if (count < least || count > most)
    {
      ThrowMalformed(std::to_string(count) + " " + name);
    }
  };
  const bool mesh = header.Status == 0;
  checkCount("bytes of message", header.MessageLength, mesh ? 0 : 1, MaximumMessageLength);
  checkCount("points", header.NumberOfPoints, mesh ? static_cast<std::int64_t>(sentPoints) : 0,
    mesh ? MaximumCount : 0);
  checkCount("cells", header.NumberOfCells, mesh ? 1 : 0, mesh ? MaximumCount : 0);
  checkCount("faces", header.NumberOfFaces, 0, mesh ? MaximumCount : 0);
}

template <std::size_t Corners>
void CheckIds(
  const char* name, const std::vector<std::array<Id, Corners>>& elements, std::size_t end)
{
  for (std::size_t e = 0; e < elements.size(); ++e)
  {
    for (const Id id : elements[e])
    {
      if (id < 0 || static_cast<std::size_t>(id) >= end)
      {
        ThrowMalformed(std::string(name) + " " + std::to_string(e) + " refers to point " +
          std::to_string(id) + " of " + std::to_string(end));
      }
    }
  }
}

void CheckFacetIds(const std::vector<Id>& facets, std::size_t end)
{
  for (const Id facet : facets)
  {
    if (facet < 0 || static_cast<std::size_t>(facet) >= end)
    {
      ThrowMalformed(
        "a face refers to facet " + std::to_string(facet) + " of " + std::to_string(end));
    }
  }
}

/** Bound the answer by the memory budget: the caller has to hold it. */
void CheckSizeOfAnswer(const AnswerHeader& header, double mebibytes)
{
  const std::int64_t bytes = header.NumberOfPoints * std::int64_t(sizeof(Point)) +
    header.NumberOfCells * std::int64_t(sizeof(Tetrahedron)) +
    header.NumberOfFaces * std::int64_t(sizeof(Triangle) + sizeof(Id));
  if (static_cast<double>(bytes) > mebibytes * 1024 * 1024)
  {
    ThrowBudget("sends", mebibytes, "MiB");
  }
}

RawTetrahedra ReceiveAnswer(Conversation& conversation, std::size_t sentPoints,
  std::size_t sentFacets, const TetrahedralizerBudget& budget)
{
  AnswerHeader header;
  conversation.Receive(&header, sizeof(header));
  CheckHeader(header, sentPoints);
  CheckSizeOfAnswer(header, budget.Mebibytes);
  std::string message(static_cast<std::size_t>(header.MessageLength), ' ');
  conversation.Receive(&message[0], message.size());
  if (header.Status != 0)
  {
    throw Error(
      ErrorCode::TetrahedralizerFailed, "TetGen cannot tetrahedralize the surface: " + message);
  }
  RawTetrahedra answer;
  conversation.Receive(answer.Points, header.NumberOfPoints);
  conversation.Receive(answer.Cells, header.NumberOfCells);
  conversation.Receive(answer.Faces, header.NumberOfFaces);
  conversation.Receive(answer.FacetOfFaces, header.NumberOfFaces);
  CheckIds("cell", answer.Cells, answer.Points.size());
  CheckIds("face", answer.Faces, answer.Points.size());
  CheckFacetIds(answer.FacetOfFaces, sentFacets);
  return answer;
}

void CheckSize(const char* name, std::size_t count)
{
  if (count > static_cast<std::size_t>(MaximumCount))
  {
    throw Error(ErrorCode::TooLarge,
      std::to_string(count) + " " + name + " are more than TetGen can count (" +
        std::to_string(MaximumCount) + ")");
  }
}

template <typename T>
Bytes BytesOf(const std::vector<T>& array)
{
  return { reinterpret_cast<const char*>(array.data()), array.size() * sizeof(T) };
}
} // namespace

RawTetrahedra RunTetgen(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  SurfaceSteinerPoints steiner, const TetrahedralizerBudget& budget, Monitor& monitor)
{
  CheckSize("points", points.size());
  CheckSize("facets", facets.size());
  const std::string path = FindHelper();
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    ThrowDied("cannot be started: socketpair: " + ErrorText(errno));
  }
  const Descriptor ours(sockets[0]);
  Descriptor theirs(sockets[1]);
  Helper helper(path, theirs.Number);
  theirs.Close();

  const RequestHeader header = { RequestMagic, steiner == SurfaceSteinerPoints::Leave,
    static_cast<std::int64_t>(points.size()), static_cast<std::int64_t>(facets.size()) };
  std::vector<Bytes> request = { { reinterpret_cast<const char*>(&header), sizeof(header) },
    BytesOf(points), BytesOf(facets) };
  Conversation conversation(ours.Number, helper, std::move(request), budget,
    SecondsPerElement * static_cast<double>(points.size() + facets.size()), monitor);
  try
  {
    return ReceiveAnswer(conversation, points.size(), facets.size(), budget);
  }
  catch (const EndOfAnswer&)
  {
    ThrowDied(helper.DescribeEnd());
  }
}
} // namespace insideout
