// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/OutputFile.h"

#include "Support/TemporaryFile.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace insideout;
using testfiles::TemporaryFile;

namespace
{
/** Wants to stop when it is asked for the time `Last`. */
class StopAt : public Monitor
{
public:
  explicit StopAt(int last)
    : Last(last)
  {
  }

  bool Continue(const char*, double) override { return this->Last-- > 0; }

private:
  int Last;
};

/** The temporary files of this process in the folder of another. */
std::vector<std::string> UnfinishedBeside(const std::string& path)
{
  std::vector<std::string> found;
  const std::string prefix = ".insideout-" + std::to_string(getpid()) + "-";
  for (const auto& entry :
    std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()))
  {
    if (entry.path().filename().string().compare(0, prefix.size(), prefix) == 0)
    {
      found.push_back(entry.path().string());
    }
  }
  return found;
}
} // namespace

TEST(OutputFile, IsThereWhenItIsClosed)
{
  const TemporaryFile file("a.txt", "earlier");
  Monitor monitor;
  {
    OutputFile output(file.Path, monitor);
    output.Text("new");
    EXPECT_EQ(file.Read(), "earlier");
    EXPECT_EQ(UnfinishedBeside(file.Path).size(), 1u);
    output.Close();
    EXPECT_EQ(file.Read(), "new");
  }
  EXPECT_EQ(file.Read(), "new");
  EXPECT_TRUE(UnfinishedBeside(file.Path).empty());
}

TEST(OutputFile, LeavesTheEarlierFileUntilThen)
{
  const TemporaryFile file("a.txt", "earlier");
  Monitor monitor;
  {
    OutputFile output(file.Path, monitor);
    output.Text(std::string(3000000, 'x'));
  }
  EXPECT_EQ(file.Read(), "earlier");
  EXPECT_TRUE(UnfinishedBeside(file.Path).empty());
}

TEST(OutputFile, CanBeStoppedUntilTheLastMoment)
{
  const TemporaryFile file("a.txt", "earlier");
  int times = 0;
  for (bool stopped = true; stopped; ++times)
  {
    EXPECT_EQ(file.Read(), "earlier");
    StopAt monitor(times);
    try
    {
      OutputFile output(file.Path, monitor);
      output.Text(std::string(3000000, 'x'));
      output.Close();
      stopped = false;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped);
    }
    EXPECT_TRUE(UnfinishedBeside(file.Path).empty());
  }
  EXPECT_GE(times, 3);
  EXPECT_EQ(file.Read(), std::string(3000000, 'x'));
}

TEST(OutputFile, OfAProcessThatEndsAtOnceIsRemoved)
{
  const TemporaryFile file("a.txt", "earlier");
  EXPECT_EXIT(
    {
      Monitor monitor;
      OutputFile output(file.Path, monitor);
      output.Text(std::string(3000000, 'x'));
      const std::size_t begun = UnfinishedBeside(file.Path).size();
      UnfinishedFile::RemoveAllForGood();
      _exit(begun == 1 && UnfinishedBeside(file.Path).empty() ? 7 : 8);
    },
    testing::ExitedWithCode(7), "");
  EXPECT_EQ(file.Read(), "earlier");
}
