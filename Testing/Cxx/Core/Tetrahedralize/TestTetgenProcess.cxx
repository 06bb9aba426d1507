// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Statistics.h"
#include "Tetrahedralize/TetgenProcess.h"

#include "Support/StandInHelper.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

using namespace insideout;
using namespace insideout::tetgenprotocol;
using namespace standin;

namespace
{
RawTetrahedra RunOn(
  const TriangleSoup& soup, Monitor& monitor, const TetrahedralizerBudget& budget = {})
{
  return RunTetgen(soup.Points, soup.Triangles, {}, budget, monitor);
}

const TriangleSoup& UnitBox()
{
  static const TriangleSoup box = testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 });
  return box;
}

void ExpectError(ErrorCode code, const std::string& part, const TriangleSoup& soup = UnitBox(),
  const TetrahedralizerBudget& budget = {})
{
  const NothingIsLeft check;
  Monitor monitor;
  try
  {
    RunOn(soup, monitor, budget);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

/** Many points: more bytes than any socket holds. */
TriangleSoup BigSoup(int points)
{
  TriangleSoup soup;
  soup.Points = testmeshes::RandomSoup(7, points / 3).Points;
  return soup;
}

void ExpectStopped(const TriangleSoup& soup)
{
  const NothingIsLeft check;
  Stopper stopper(3);
  try
  {
    RunOn(soup, stopper);
    FAIL() << "not stopped";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, ErrorCode::Stopped) << error.what();
  }
}

/** An answer of one cell to the unit box, with what a test wants to be wrong. */
std::string SmallAnswer(std::int32_t corner, std::int32_t faceCorner, std::int32_t facet)
{
  return BytesOf(AnswerHeader{ AnswerMagic, 0, 0, 8, 1, 1 }) + BytesOf(UnitBox().Points) +
    BytesOf(std::vector<std::int32_t>{ 0, 1, 2, corner, 0, 1, faceCorner, facet });
}
} // namespace

TEST(TetgenProcess, FindsTheHelperByItself)
{
  const NothingIsLeft check;
  Monitor monitor;
  const RawTetrahedra answer = RunOn(UnitBox(), monitor);
  EXPECT_EQ(answer.Points, UnitBox().Points);
  EXPECT_EQ(answer.Faces.size(), 12u);
  EXPECT_GE(answer.Cells.size(), 5u);
}

TEST(TetgenProcess, SaysWhereAMissingHelperWasLookedFor)
{
  setenv("INSIDEOUT_TETGEN", "/nonexistent/helper", 1);
  ExpectError(ErrorCode::TetrahedralizerDied,
    "cannot be started: /nonexistent/helper: No such file or directory");
  unsetenv("INSIDEOUT_TETGEN");
}

TEST(TetgenProcess, SaysThatAHelperIsNotExecutable)
{
  const StandIn standIn("exit 0");
  fs::permissions(standIn.Path, fs::perms::owner_read);
  ExpectError(ErrorCode::TetrahedralizerDied, "cannot be started: " + standIn.Path);
}

TEST(TetgenProcess, SaysHowAHelperEnded)
{
  {
    const StandIn standIn("exit 1");
    ExpectError(ErrorCode::TetrahedralizerDied, "exited with status 1 before answering");
  }
  {
    const StandIn standIn("kill -ABRT $$");
    ExpectError(ErrorCode::TetrahedralizerDied, "was ended by signal 6 (Aborted)");
  }
  {
    const StandIn standIn("kill -SEGV $$");
    ExpectError(ErrorCode::TetrahedralizerDied, "was ended by signal 11 (Segmentation fault)");
  }
  {
    const StandIn standIn("exec <&- >&-; sleep infinity");
    ExpectError(ErrorCode::TetrahedralizerDied, "closed its output before answering");
  }
}

TEST(TetgenProcess, SurvivesAHelperThatDoesNotRead)
{
  const StandIn standIn("exit 3");
  ExpectError(
    ErrorCode::TetrahedralizerDied, "exited with status 3 before answering", BigSoup(1000000));
}

TEST(TetgenProcess, RefusesGarbage)
{
  const StandIn standIn("yes garbage | head -c 100000");
  ExpectError(ErrorCode::TetrahedralizerDied,
    "sent a malformed answer: it does not begin with the protocol's mark");
}

TEST(TetgenProcess, NoticesThatAnAnswerIsCutOff)
{
  // Cut within the header, the points, the cells, the faces.
  for (const int bytes : { 20, 60, 250, 400 })
  {
    const StandIn standIn("\"" INSIDEOUT_TETGEN_PATH "\" | head -c " + std::to_string(bytes));
    ExpectError(ErrorCode::TetrahedralizerDied, "before answering");
  }
}

TEST(TetgenProcess, ChecksCountsBeforeItBelievesThem)
{
  for (const std::int64_t count : { INT64_MIN, std::int64_t(-1), MaximumCount + 1, INT64_MAX })
  {
    for (const AnswerHeader& header : { AnswerHeader{ AnswerMagic, 0, 0, count, 1, 0 },
           AnswerHeader{ AnswerMagic, 0, 0, 8, count, 0 },
           AnswerHeader{ AnswerMagic, 0, 0, 8, 1, count },
           AnswerHeader{ AnswerMagic, 3, count, 0, 0, 0 } })
    {
      const StandInAnswer standIn(BytesOf(header));
      ExpectError(
        ErrorCode::TetrahedralizerDied, "sent a malformed answer: " + std::to_string(count));
    }
  }
  const StandInAnswer fewerPoints(BytesOf(AnswerHeader{ AnswerMagic, 0, 0, 7, 1, 0 }));
  ExpectError(ErrorCode::TetrahedralizerDied, "sent a malformed answer: 7 points");
}

TEST(TetgenProcess, AllocatesNoMoreThanArrives)
{
  const StandInAnswer standIn(
    BytesOf(AnswerHeader{ AnswerMagic, 0, 0, MaximumCount, MaximumCount, MaximumCount }));
  const double before = PeakMemory();
  ExpectError(ErrorCode::TetrahedralizerDied, "exited with status 0 before answering");
  // It claimed many GiB.
  EXPECT_LT(PeakMemory() - before, 1024);
}

TEST(TetgenProcess, ChecksEveryId)
{
  Monitor monitor;
  {
    const StandInAnswer good(SmallAnswer(3, 2, 11));
    EXPECT_EQ(RunOn(UnitBox(), monitor).FacetOfFaces, std::vector<Id>{ 11 });
  }
  for (const std::int32_t id : { INT32_MIN, -1, 8, INT32_MAX })
  {
    const StandInAnswer cell(SmallAnswer(id, 2, 0));
    ExpectError(ErrorCode::TetrahedralizerDied,
      "sent a malformed answer: cell 0 refers to point " + std::to_string(id) + " of 8");
    const StandInAnswer face(SmallAnswer(3, id, 0));
    ExpectError(ErrorCode::TetrahedralizerDied,
      "sent a malformed answer: face 0 refers to point " + std::to_string(id) + " of 8");
  }
  for (const std::int32_t id : { INT32_MIN, -1, 12, INT32_MAX })
  {
    const StandInAnswer facet(SmallAnswer(3, 2, id));
    ExpectError(ErrorCode::TetrahedralizerDied,
      "sent a malformed answer: a face refers to facet " + std::to_string(id) + " of 12");
  }
}

TEST(TetgenProcess, PassesOnWhatTetGenReports)
{
  const std::string words = "it met two facets too close to each other";
  const StandInAnswer standIn(
    BytesOf(AnswerHeader{ AnswerMagic, 5, static_cast<std::int64_t>(words.size()), 0, 0, 0 }) +
    words);
  ExpectError(ErrorCode::TetrahedralizerFailed, words);
}

TEST(TetgenProcess, StopsAHelperThatSleeps)
{
  const StandIn standIn(SleepForEver);
  ExpectStopped(UnitBox());
}

TEST(TetgenProcess, StopsAHelperThatSleepsAndDoesNotRead)
{
  const StandIn standIn(SleepForEver);
  ExpectStopped(BigSoup(1000000));
}

TEST(TetgenProcess, StopsTheChildrenOfAHelperToo)
{
  const StandIn standIn("sleep infinity & echo $! > \"$(dirname \"$0\")/child\"; wait");
  ExpectStopped(UnitBox());
  pid_t child = 0;
  std::ifstream(standIn.Folder.Path / "child") >> child;
  ASSERT_GT(child, 0);
  WaitUntil([child]() { return HasEnded(child); });
}

TEST(TetgenProcess, EndsAHelperThatTakesTooLong)
{
  const NothingIsLeft check;
  for (const char* script :
    { SleepForEver, "cat > /dev/null; sleep infinity", "while :; do :; done" })
  {
    const StandIn standIn(script);
    Stopwatch watch;
    ExpectError(ErrorCode::TetrahedralizerFailed,
      "insideout-tetgen took more than the 0.25 s that it may", UnitBox(), { 0.25 });
    EXPECT_GE(watch.Lap(), 0.25);
  }
}

TEST(TetgenProcess, EndsAHelperThatComputesTooLong)
{
  const StandIn standIn("while :; do :; done");
  ExpectError(ErrorCode::TetrahedralizerFailed,
    "insideout-tetgen computed more than the 0.25 s that it may", UnitBox(), { HUGE_VAL, 0.25 });
}

TEST(TetgenProcess, EndsAHelperThatComputesNothingWhereOnlyComputingIsLimited)
{
  const StandIn standIn(SleepForEver);
  // To start takes some milliseconds of computing on a slow machine.
  ExpectError(ErrorCode::TetrahedralizerFailed, "insideout-tetgen took more than the 5 s",
    UnitBox(), { HUGE_VAL, 0.05 });
}

TEST(TetgenProcess, EndsAHelperThatHoldsTooMuch)
{
  // tail keeps what it reads until the end of a line, which never comes.
  const StandIn standIn("exec tail /dev/zero");
  ExpectError(ErrorCode::TetrahedralizerFailed,
    "insideout-tetgen held more than the 100 MiB that it may", UnitBox(),
    { HUGE_VAL, HUGE_VAL, 100 });
}

TEST(TetgenProcess, RefusesMoreThanTheMemoryBudgetBeforeItComes)
{
  const StandInAnswer standIn(BytesOf(AnswerHeader{ AnswerMagic, 0, 0, 8, 10000000, 0 }));
  ExpectError(ErrorCode::TetrahedralizerFailed,
    "insideout-tetgen sends more than the 100 MiB that it may", UnitBox(),
    { HUGE_VAL, HUGE_VAL, 100 });
}

TEST(TetgenProcess, EndsWhatAHelperThatEndedLeftBehind)
{
  const StandIn standIn("sleep infinity & echo $! > \"$(dirname \"$0\")/child\"; exit 0");
  ExpectError(ErrorCode::TetrahedralizerDied, "exited with status 0 before answering");
  pid_t child = 0;
  std::ifstream(standIn.Folder.Path / "child") >> child;
  ASSERT_GT(child, 0);
  WaitUntil([child]() { return HasEnded(child); });
}

TEST(TetgenProcess, StopsTetGenAtWork)
{
  ExpectStopped(BigSoup(600000));
}

TEST(TetgenProcess, LeavesNothingWhenTheMonitorThrows)
{
  class Thrower : public Monitor
  {
    bool Continue(const char*, double) override { throw std::runtime_error("mine"); }
  };
  const NothingIsLeft check;
  const StandIn standIn(SleepForEver);
  Thrower thrower;
  EXPECT_THROW(RunOn(UnitBox(), thrower), std::runtime_error);
}

TEST(TetgenProcess, StartsTheHelperWithFreshSignals)
{
  // Blocked and ignored signals would be inherited: the shell could then not end itself by one.
  sigset_t set;
  sigset_t before;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigprocmask(SIG_BLOCK, &set, &before);
  const auto handler = std::signal(SIGHUP, SIG_IGN);
  {
    const StandIn standIn("kill -TERM $$; sleep 1");
    ExpectError(ErrorCode::TetrahedralizerDied, "was ended by signal 15");
  }
  {
    const StandIn standIn("kill -HUP $$; sleep 1");
    ExpectError(ErrorCode::TetrahedralizerDied, "was ended by signal 1 ");
  }
  std::signal(SIGHUP, handler);
  sigprocmask(SIG_SETMASK, &before, nullptr);
}

TEST(TetgenProcess, WorksWhereTheCallerIgnoresItsChildren)
{
  const auto handler = std::signal(SIGCHLD, SIG_IGN);
  Monitor monitor;
  EXPECT_EQ(RunOn(UnitBox(), monitor).Points, UnitBox().Points);
  {
    const StandIn standIn("exit 1");
    ExpectError(ErrorCode::TetrahedralizerDied, "before answering");
  }
  std::signal(SIGCHLD, handler);
}

TEST(TetgenProcess, NeedsNoStandardInputOrOutput)
{
  // Then the socket may have number 0 or 1 itself.
  const int input = dup(STDIN_FILENO);
  const int output = dup(STDOUT_FILENO);
  close(STDIN_FILENO);
  close(STDOUT_FILENO);
  Monitor monitor;
  RawTetrahedra answer;
  std::string problem;
  try
  {
    answer = RunOn(UnitBox(), monitor);
  }
  catch (const Error& error)
  {
    problem = error.what();
  }
  if (input >= 0)
  {
    dup2(input, STDIN_FILENO);
    close(input);
  }
  dup2(output, STDOUT_FILENO);
  close(output);
  EXPECT_EQ(problem, "");
  EXPECT_EQ(answer.Points, UnitBox().Points);
}

TEST(TetgenProcess, GivesThreadsTheSameAsOneAlone)
{
  const NothingIsLeft check;
  const TriangleSoup nested =
    testmeshes::Join(UnitBox(), testmeshes::Box({ 0.25, 0.25, 0.25 }, { 0.5, 0.5, 0.5 }));
  const std::array<TriangleSoup, 2> soups = { BigSoup(3000), nested };
  const auto run = [&soups](std::size_t which)
  {
    Monitor monitor;
    return RunOn(soups[which], monitor).Cells;
  };
  const std::array<std::vector<Tetrahedron>, 2> alone = { run(0), run(1) };
  std::array<bool, 2> same = { true, true };
  std::vector<std::thread> threads;
  for (std::size_t which = 0; which < 2; ++which)
  {
    threads.emplace_back(
      [&, which]()
      {
        for (int again = 0; again < 10; ++again)
        {
          same[which] = same[which] && run(which) == alone[which];
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_TRUE(same[0] && same[1]);
}

TEST(TetgenHelper, RefusesWhatIsNoRequest)
{
  const auto run = [](const std::string& command)
  { return WEXITSTATUS(std::system((command + " > /dev/null").c_str())); };
  const std::string helper = " \"" INSIDEOUT_TETGEN_PATH "\"";
  EXPECT_EQ(run(helper + " < /dev/null"), 2);
  EXPECT_EQ(run("yes garbage | head -c 1000 |" + helper), 2);
  const TemporaryFolder folder;
  const fs::path file = folder.Path / "request";
  for (const std::int64_t count : { INT64_MIN, std::int64_t(-1), MaximumCount + 1, INT64_MAX })
  {
    for (const RequestHeader& header :
      { RequestHeader{ RequestMagic, 0, count, 0 }, RequestHeader{ RequestMagic, 0, 8, count } })
    {
      std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(&header), sizeof(header));
      EXPECT_EQ(run(helper + " < " + file.string()), 2);
    }
  }
  const RequestHeader header = { RequestMagic, 0, 8, 1 };
  std::ofstream(file, std::ios::binary)
    << std::string(reinterpret_cast<const char*>(&header), sizeof(header))
    << BytesOf(UnitBox().Points) << BytesOf(std::vector<std::int32_t>{ 0, 1, 8 });
  EXPECT_EQ(run(helper + " < " + file.string()), 2);
}

#ifdef __linux__
TEST(TetgenHelper, DoesNotOutliveItsParent)
{
  const StandIn standIn("echo $$ > \"$(dirname \"$0\")/pid\"; exec \"" INSIDEOUT_TETGEN_PATH "\"");
  const TriangleSoup soup = BigSoup(600000);
  const pid_t parent = fork();
  if (parent == 0)
  {
    Monitor monitor;
    RunOn(soup, monitor);
    _exit(0);
  }
  pid_t helper = 0;
  WaitUntil(
    [&]()
    {
      std::ifstream(standIn.Folder.Path / "pid") >> helper;
      return helper > 0;
    });
  EXPECT_FALSE(HasEnded(helper));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  WaitUntil([helper]() { return HasEnded(helper); });
}
#endif
