// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Tetrahedralize/TetgenProtocol.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

/** Programs in the place of insideout-tetgen, and proofs that nothing of them is left. */
namespace standin
{
namespace fs = std::filesystem;

/** A folder of its own that goes with the test. */
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string name = (fs::temp_directory_path() / "insideout.XXXXXX").string();
    this->Path = mkdtemp(&name[0]);
  }
  ~TemporaryFolder() { fs::remove_all(this->Path); }

  fs::path Path;
};

/** A shell script in the helper's place. */
class StandIn
{
public:
  explicit StandIn(const std::string& script)
    : Path((this->Folder.Path / "helper").string())
  {
    std::ofstream(this->Path) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(this->Path, fs::perms::owner_all);
    setenv("INSIDEOUT_TETGEN", this->Path.c_str(), 1);
  }
  ~StandIn() { unsetenv("INSIDEOUT_TETGEN"); }

  const TemporaryFolder Folder;
  const std::string Path;
};

/** A helper that answers with given bytes, whatever it is asked. */
class StandInAnswer : public StandIn
{
public:
  explicit StandInAnswer(const std::string& bytes)
    : StandIn("cat \"$(dirname \"$0\")/answer\"")
  {
    std::ofstream(this->Folder.Path / "answer", std::ios::binary) << bytes;
  }
};

inline std::size_t OpenDescriptors()
{
  return static_cast<std::size_t>(
    std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

/** Proves at its end that no child and no descriptor is left. */
class NothingIsLeft
{
public:
  ~NothingIsLeft()
  {
    EXPECT_EQ(OpenDescriptors(), this->Descriptors);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
  }

private:
  const std::size_t Descriptors = OpenDescriptors();
};

/** Whether a process runs no more; whoever inherits it may take its time to reap it. */
inline bool HasEnded(pid_t process)
{
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  stat >> word >> word >> word;
  return !stat || word == "Z" || word == "X";
}

/** Waits as long as it takes: a condition that never holds ends the test by its time limit. */
template <typename Condition>
void WaitUntil(Condition condition)
{
  while (!condition())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/** What a helper that has to be ended does: nothing, for longer than any test may take. */
constexpr const char* SleepForEver = "exec sleep infinity";

/** Says stop at a report of this number, and proves that it is the last one. */
class Stopper : public insideout::Monitor
{
public:
  explicit Stopper(int report)
    : Report(report)
  {
  }
  ~Stopper() override { EXPECT_EQ(this->Reports, this->Report); }

  bool Continue(const char* stage, double fraction) override
  {
    EXPECT_STREQ(stage, "tetrahedralizing");
    EXPECT_GE(fraction, this->Last);
    EXPECT_LE(fraction, 1);
    this->Last = fraction;
    return ++this->Reports < this->Report;
  }

private:
  const int Report;
  int Reports = 0;
  double Last = 0;
};

inline std::string BytesOf(const insideout::tetgenprotocol::AnswerHeader& header)
{
  return std::string(reinterpret_cast<const char*>(&header), sizeof(header));
}

template <typename T>
std::string BytesOf(const std::vector<T>& values)
{
  return std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}
} // namespace standin
