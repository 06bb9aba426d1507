// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/ResolveSelfIntersections.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Tetrahedralize/Ladder.h"
#include "Tetrahedralize/TetgenProcess.h"
#include "Validate/CountedChain.h"

#include "Support/Corpus.h"
#include "Support/MeshLaws.h"
#include "Support/StandInHelper.h"
#include "Support/TestMeshes.h"
#include "Support/TetrahedralizationFamilies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>

using namespace insideout;
using namespace insideout::tetgenprotocol;
using namespace standin;

namespace
{
/** Enough on any machine for what ends by itself, and little for what has to be ended. */
constexpr double Seconds = 10000;
constexpr double FewSeconds = 0.8;
constexpr double Mebibytes = 100;

constexpr TetrahedralizationEngine TetGen = TetrahedralizationEngine::TetGen;

int LastRung()
{
  int rung = 1;
  while (RungName(rung + 1))
  {
    ++rung;
  }
  return rung;
}

/** The rungs that TetGen is behind: the ones whose names say so. */
int NumberOfTetgenRungs()
{
  int rungs = 0;
  for (int rung = 1; RungName(rung); ++rung)
  {
    rungs += std::string(RungName(rung)).find("TetGen") == 0;
  }
  return rungs;
}

/** Work and temporary files have a folder of their own, which has to be empty at the end. */
class NoFileIsLeft
{
public:
  NoFileIsLeft()
    : Before(fs::current_path())
  {
    fs::current_path(this->Folder.Path);
    setenv("TMPDIR", this->Folder.Path.c_str(), 1);
  }
  ~NoFileIsLeft()
  {
    EXPECT_TRUE(fs::is_empty(this->Folder.Path));
    unsetenv("TMPDIR");
    fs::current_path(this->Before);
  }

private:
  const TemporaryFolder Folder;
  const fs::path Before;
};

FacetComplex UnitBox()
{
  return testmeshes::ToComplex(testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 }));
}

std::string BytesOf(const RawTetrahedra& answer)
{
  return standin::BytesOf(
           AnswerHeader{ AnswerMagic, 0, 0, static_cast<std::int64_t>(answer.Points.size()),
             static_cast<std::int64_t>(answer.Cells.size()),
             static_cast<std::int64_t>(answer.Faces.size()) }) +
    standin::BytesOf(answer.Points) + standin::BytesOf(answer.Cells) +
    standin::BytesOf(answer.Faces) + standin::BytesOf(answer.FacetOfFaces);
}

RawTetrahedra AnswerToUnitBox()
{
  Monitor monitor;
  const FacetComplex box = UnitBox();
  return RunTetgen(box.Points, box.Facets, {}, {}, monitor);
}

/** Whatever the helper does, the box is filled, by a rung that needs no TetGen. */
void ExpectAnswerWithoutTetgen(const std::string& reason, double seconds = Seconds)
{
  const NothingIsLeft nothingIsLeft;
  const NoFileIsLeft noFileIsLeft;
  const FacetComplex box = UnitBox();
  Monitor monitor;
  const Tetrahedralization result =
    ConstrainedDelaunay(box, { seconds, Mebibytes, TetGen }, monitor);
  testmeshes::ExpectMeshLaws(box, result.Mesh);
  ASSERT_GE(result.Failures.size(), static_cast<std::size_t>(NumberOfTetgenRungs()));
  std::size_t failures = 0;
  for (int rung = 1; RungName(rung); ++rung)
  {
    if (std::string(RungName(rung)).find("TetGen") == 0)
    {
      EXPECT_NE(result.Rung, rung);
      const std::string& failure = result.Failures[failures];
      ++failures;
      EXPECT_EQ(failure.find(std::string(RungName(rung)) + ": "), 0u) << failure;
      EXPECT_NE(failure.find(reason), std::string::npos) << failure;
    }
  }
}

/** A script that is TetGen but for its first runs. */
std::string CrashFirst(int crashes)
{
  return "tries=\"$(dirname \"$0\")/tries\"; echo x >> \"$tries\"\n"
         "[ $(wc -l < \"$tries\") -gt " +
    std::to_string(crashes) + " ] || kill -SEGV $$\nexec \"" INSIDEOUT_TETGEN_PATH "\"";
}

void ExpectStoppedAtOnce(const FacetComplex& surface, TetrahedralizationEngine engine = TetGen)
{
  for (const int report : { 1, 2, 3 })
  {
    const NothingIsLeft nothingIsLeft;
    Stopper stopper(report);
    try
    {
      ConstrainedDelaunay(surface, { 0, 0, engine }, stopper);
      FAIL() << "not stopped";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::Stopped) << error.what();
    }
  }
}
} // namespace

TEST(TetrahedralizerFaults, HelperThatHangs)
{
  const StandIn standIn(SleepForEver);
  ExpectAnswerWithoutTetgen("took more than", FewSeconds);
}

TEST(TetrahedralizerFaults, HelperThatReadsAndLoops)
{
  const StandIn standIn("cat > /dev/null; while :; do :; done");
  ExpectAnswerWithoutTetgen("took more than", FewSeconds);
}

TEST(TetrahedralizerFaults, HelperThatAborts)
{
  const StandIn standIn("kill -ABRT $$");
  ExpectAnswerWithoutTetgen("signal 6");
}

TEST(TetrahedralizerFaults, HelperThatSegfaultsAmidItsAnswer)
{
  const StandIn standIn("\"" INSIDEOUT_TETGEN_PATH "\" | head -c 100; kill -SEGV $$");
  ExpectAnswerWithoutTetgen("signal 11");
}

TEST(TetrahedralizerFaults, HelperThatExitsWithoutAWord)
{
  const StandIn standIn("exit 0");
  ExpectAnswerWithoutTetgen("exited with status 0");
}

TEST(TetrahedralizerFaults, HelperThatGivesUp)
{
  const StandInAnswer standIn(
    standin::BytesOf(AnswerHeader{ AnswerMagic, 3, 5, 0, 0, 0 }) + "no no");
  ExpectAnswerWithoutTetgen("no no");
}

TEST(TetrahedralizerFaults, HelperThatSendsGarbage)
{
  const StandIn standIn("yes garbage | head -c 100000");
  ExpectAnswerWithoutTetgen("malformed");
}

TEST(TetrahedralizerFaults, HelperThatSendsTooLittle)
{
  const StandIn standIn("\"" INSIDEOUT_TETGEN_PATH "\" | head -c 250");
  ExpectAnswerWithoutTetgen("before answering");
}

TEST(TetrahedralizerFaults, HelperThatWritesEndlessly)
{
  {
    const StandIn standIn("exec yes");
    ExpectAnswerWithoutTetgen("malformed");
  }
  const std::string header =
    standin::BytesOf(AnswerHeader{ AnswerMagic, 0, 0, 8, MaximumCount, 0 });
  const StandIn standIn("cat \"$(dirname \"$0\")/header\"; exec cat /dev/zero");
  std::ofstream(standIn.Folder.Path / "header", std::ios::binary) << header;
  ExpectAnswerWithoutTetgen("sends more than");
}

TEST(TetrahedralizerFaults, HelperThatSendsZeros)
{
  const StandIn standIn("cat \"$(dirname \"$0\")/header\"; exec cat /dev/zero");
  std::ofstream(standIn.Folder.Path / "header", std::ios::binary)
    << standin::BytesOf(AnswerHeader{ AnswerMagic, 0, 0, 8, 1000, 0 });
  ExpectAnswerWithoutTetgen("inconsistent");
}

TEST(TetrahedralizerFaults, HelperThatEatsMemory)
{
  const StandIn standIn("exec tail /dev/zero");
  const NothingIsLeft nothingIsLeft;
  const FacetComplex box = UnitBox();
  Monitor monitor;
  const Tetrahedralization result =
    ConstrainedDelaunay(box, { Seconds, Mebibytes, TetGen }, monitor);
  testmeshes::ExpectMeshLaws(box, result.Mesh);
  EXPECT_NE(result.Failures[0].find("held more than the 100 MiB"), std::string::npos)
    << result.Failures[0];
}

TEST(TetrahedralizerFaults, HelperThatIsMissing)
{
  setenv("INSIDEOUT_TETGEN", "/nonexistent/helper", 1);
  ExpectAnswerWithoutTetgen("No such file");
  unsetenv("INSIDEOUT_TETGEN");
}

TEST(TetrahedralizerFaults, HelperThatIsNotExecutable)
{
  const StandIn standIn("exit 0");
  fs::permissions(standIn.Path, fs::perms::owner_read);
  ExpectAnswerWithoutTetgen("cannot be started");
}

TEST(TetrahedralizerFaults, HelperThatLeavesAChildWithTheSocket)
{
  const StandIn standIn("sleep infinity & exit 0");
  ExpectAnswerWithoutTetgen("exited with status 0");
}

TEST(TetrahedralizerFaults, CellsThatOverlapOrLeaveGaps)
{
  const RawTetrahedra good = AnswerToUnitBox();
  const auto expect = [](const RawTetrahedra& answer, const std::string& reason)
  {
    const StandInAnswer standIn(BytesOf(answer));
    ExpectAnswerWithoutTetgen(reason);
  };
  RawTetrahedra missing = good;
  missing.Cells.pop_back();
  expect(missing, "inconsistent");
  RawTetrahedra twice = good;
  twice.Cells.push_back(good.Cells[0]);
  expect(twice, "inconsistent");
  RawTetrahedra flat = good;
  flat.Cells[0][0] = flat.Cells[0][1];
  expect(flat, "flat");
  RawTetrahedra moved = good;
  moved.Points[3][0] += 1;
  expect(moved, "moved");
}

TEST(TetrahedralizerFaults, InvertedCells)
{
  // Turned over alone, each cell is as good as before: ids say nothing of how it was meant.
  RawTetrahedra turned = AnswerToUnitBox();
  for (std::size_t c = 0; c < turned.Cells.size(); c += 2)
  {
    std::swap(turned.Cells[c][0], turned.Cells[c][1]);
  }
  const FacetComplex box = UnitBox();
  Monitor monitor;
  {
    const StandInAnswer standIn(BytesOf(turned));
    EXPECT_TRUE(ConstrainedDelaunay(box, { Seconds, Mebibytes, TetGen }, monitor).Failures.empty());
  }
  // A cell folded back over its neighbor: one corner of all cells around it leaves the box's
  // middle.
  TriangleSoup soup = testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 });
  soup.Points.push_back({ { 0.5, 0.5, 0.5 } });
  const FacetComplex withMiddle = testmeshes::ToComplex(soup);
  RawTetrahedra folded = RunTetgen(withMiddle.Points, withMiddle.Facets, {}, {}, monitor);
  folded.Points.push_back({ { 3, 0.5, 0.5 } });
  for (Tetrahedron& cell : folded.Cells)
  {
    std::replace(cell.begin(), cell.end(), 8, 9);
  }
  folded.Cells.push_back({ { 0, 1, 2, 8 } });
  const StandInAnswer standIn(BytesOf(folded));
  const Tetrahedralization result =
    ConstrainedDelaunay(withMiddle, { Seconds, Mebibytes, TetGen }, monitor);
  EXPECT_NE(result.Failures.at(0).find("inconsistent"), std::string::npos) << result.Failures[0];
  testmeshes::ExpectMeshLaws(withMiddle, result.Mesh);
}

TEST(TetrahedralizerFaults, EachRungOfTetgenHasItsTurn)
{
  const FacetComplex box = UnitBox();
  for (int crashes = 0; crashes < NumberOfTetgenRungs(); ++crashes)
  {
    const NothingIsLeft nothingIsLeft;
    const StandIn standIn(CrashFirst(crashes));
    Monitor monitor;
    const Tetrahedralization result = ConstrainedDelaunay(box, { 0, 0, TetGen }, monitor);
    testmeshes::ExpectMeshLaws(box, result.Mesh);
    EXPECT_EQ(std::string(RungName(result.Rung)).find("TetGen"), 0u);
    EXPECT_EQ(result.Failures.size(), static_cast<std::size_t>(crashes));
    EXPECT_TRUE(result.Mesh.LostFacets.empty());
  }
}

TEST(TetrahedralizerFaults, FacetsThatTheAnswerLacks)
{
  // Two tetrahedra on a triangle, or three around the line between their tips: the facet says two.
  TriangleSoup soup;
  soup.Points = { { { 1, 0, 0 } }, { { -1, 1, 0 } }, { { -1, -1, 0 } }, { { 0, 0, 9 } },
    { { 0, 0, -9 } } };
  soup.Triangles = { { { 0, 1, 2 } }, { { 0, 1, 3 } } };
  const FacetComplex surface = testmeshes::ToComplex(soup);
  RawTetrahedra answer;
  answer.Points = surface.Points;
  answer.Cells = { { { 3, 4, 0, 1 } }, { { 3, 4, 1, 2 } }, { { 3, 4, 2, 0 } } };
  const StandInAnswer standIn(BytesOf(answer));
  Monitor monitor;
  const Tetrahedralization result = ConstrainedDelaunay(surface, { 0, 0, TetGen }, monitor);
  testmeshes::ExpectMeshLaws(surface, result.Mesh);
  EXPECT_NE(result.Failures.at(0).find("it loses 1 facets"), std::string::npos)
    << result.Failures[0];
}

TEST(TetrahedralizerFaults, FacetsThatNobodyKeepsAreLost)
{
  const StandIn standIn("exit 1");
  const FacetComplex surface =
    testmeshes::ToComplex(testmeshes::CorpusSurface("facet-between-two-tips"));
  Monitor monitor;
  const Tetrahedralization result = ConstrainedDelaunay(surface, { 0, 0, TetGen }, monitor);
  testmeshes::ExpectMeshLaws(surface, result.Mesh);
  // The points alone have an edge through the last facet.
  EXPECT_EQ(
    result.Mesh.LostFacets, result.Rung == LastRung() ? std::vector<Id>{ 6 } : std::vector<Id>{});
}

TEST(TetrahedralizerFaults, StopsAtTheReportThatSaysSo)
{
  {
    const StandIn standIn(SleepForEver);
    ExpectStoppedAtOnce(UnitBox());
  }
  FacetComplex points = testmeshes::ToComplex(testmeshes::RandomSoup(8, 20000));
  points.NumberOfConstraints = 0;
  ExpectStoppedAtOnce(points);
  // In the exact rung and the last one, too.
  ExpectStoppedAtOnce(points, TetrahedralizationEngine::Exact);
  const StandIn standIn("exit 1");
  ExpectStoppedAtOnce(points);
}

TEST(TetrahedralizerFaults, DoNotDisturbOtherThreads)
{
  const NothingIsLeft nothingIsLeft;
  const StandIn standIn(SleepForEver);
  const FacetComplex box = UnitBox();
  std::array<int, 4> rungs = { 0, 0, 0, 0 };
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < rungs.size(); ++t)
  {
    threads.emplace_back(
      [&, t]()
      {
        Monitor monitor;
        rungs[t] = ConstrainedDelaunay(box, { 0.3, Mebibytes, TetGen }, monitor).Rung;
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_TRUE(std::all_of(rungs.begin(), rungs.end(), [](int rung) { return rung > 1; }));
}

TEST(TetrahedralizerFaults, BudgetsBelowZeroAreRefused)
{
  Monitor monitor;
  for (const ConstrainedDelaunayParameters& parameters : { ConstrainedDelaunayParameters{ -1, 0 },
         ConstrainedDelaunayParameters{ 0, -1 }, ConstrainedDelaunayParameters{ std::nan(""), 0 } })
  {
    try
    {
      ConstrainedDelaunay(UnitBox(), parameters, monitor);
      FAIL() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.Code, ErrorCode::InvalidParameter);
    }
  }
}

namespace
{
/** Small triangles of random place and size, each of which crosses a few others, and every fourth
 * soup fewer on a coarse grid, where everything degenerate happens. */
TriangleSoup DirtySoup(unsigned seed, int triangles)
{
  if (seed % 4 == 0)
  {
    return testmeshes::GridSoup(seed, triangles / 10, 6);
  }
  std::mt19937 random(seed);
  const auto next = [&]() { return random() / 4294967296.0; };
  const double size = 1.5 / std::cbrt(triangles);
  TriangleSoup soup;
  for (Id t = 0; t < triangles; ++t)
  {
    const Point center = { { next(), next(), next() } };
    for (int k = 0; k < 3; ++k)
    {
      Point p = center;
      for (double& x : p)
      {
        x += size * (next() - 0.5);
      }
      soup.Points.push_back(p);
    }
    soup.Triangles.push_back({ { 3 * t, 3 * t + 1, 3 * t + 2 } });
  }
  return soup;
}
} // namespace

TEST(TetrahedralizerFaults, AfterACrashPointsAreLeftOnFacets)
{
  Monitor monitor;
  Id left = 0;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const FacetComplex surface =
      ResolveSelfIntersections(CountFacets(DirtySoup(seed, 400), {}, monitor).Surface, monitor)
        .Surface;
    const StandIn standIn(CrashFirst(1));
    const Tetrahedralization result = ConstrainedDelaunay(surface, { 0, 0, TetGen }, monitor);
    EXPECT_STREQ(RungName(result.Rung), "TetGen, points left on facets");
    EXPECT_TRUE(result.Mesh.LostFacets.empty());
    testmeshes::ExpectMeshLaws(surface, result.Mesh);
    left += result.Mesh.NumberOfSurfaceSteinerPoints;
  }
  EXPECT_GT(left, 0);
}

TEST(TetrahedralizerFaults, TheExactWayComesFirst)
{
  Monitor monitor;
  const StandIn standIn("exit 1");
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const FacetComplex surface =
      ResolveSelfIntersections(CountFacets(DirtySoup(seed, 400), {}, monitor).Surface, monitor)
        .Surface;
    const Tetrahedralization result = ConstrainedDelaunay(surface, {}, monitor);
    EXPECT_STREQ(RungName(result.Rung), "exact flips and cuts");
    EXPECT_TRUE(result.Failures.empty());
    EXPECT_TRUE(result.Mesh.LostFacets.empty());
    testmeshes::ExpectMeshLaws(surface, result.Mesh);
  }
}

TEST(TetrahedralizerFaults, TheExactWayComesFirstHoweverMuchThereIsToBeCut)
{
  Monitor monitor;
  TriangleSoup soup;
  for (int i = 0; i < 250; ++i)
  {
    // Each leaves an edge that no flip recovers.
    TriangleSoup prism = testmeshes::TwistedPrism(3, -M_PI / 6);
    for (Point& p : prism.Points)
    {
      p = { { p[0] + 4 * (i % 6), p[1] + 4 * (i / 6 % 6), p[2] + 4 * (i / 36) } };
    }
    soup = testmeshes::Join(std::move(soup), prism);
  }
  const FacetComplex surface =
    ResolveSelfIntersections(CountFacets(soup, {}, monitor).Surface, monitor).Surface;
  const StandIn standIn("exit 1");
  const Tetrahedralization result = ConstrainedDelaunay(surface, {}, monitor);
  EXPECT_STREQ(RungName(result.Rung), "exact flips and cuts");
  EXPECT_TRUE(result.Failures.empty());
  EXPECT_TRUE(result.Mesh.LostFacets.empty());
  EXPECT_GE(result.Mesh.NumberOfSteinerPoints, 250);
  testmeshes::ExpectMeshLaws(surface, result.Mesh);
}

TEST(TetrahedralizerFaults, TetGenFollowsWhereTheExactWayFails)
{
  // Whole facets of the first box cross the second: what is lost makes every rung take its turn.
  const TriangleSoup soup = testmeshes::Join(
    testmeshes::Box({ 0, 0, 0 }, { 2, 2, 2 }), testmeshes::Box({ 1, 1, 1 }, { 3, 3, 3 }));
  Monitor monitor;
  const Tetrahedralization result = ConstrainedDelaunay(testmeshes::ToComplex(soup), {}, monitor);
  EXPECT_FALSE(result.Mesh.LostFacets.empty());
  ASSERT_EQ(result.Failures.size(), static_cast<std::size_t>(LastRung()));
  for (int rung = 1; rung <= LastRung(); ++rung)
  {
    EXPECT_EQ(result.Failures[rung - 1].find(std::string(RungName(rung)) + ": "), 0u);
  }
}

TEST(TetrahedralizerFaults, TheExactEngineNeedsNoTetgen)
{
  const StandIn standIn("exit 1");
  Monitor monitor;
  EXPECT_TRUE(ConstrainedDelaunay(UnitBox(), { 0, 0, TetrahedralizationEngine::Exact }, monitor)
                .Failures.empty());
}

TEST(TetrahedralizerFaults, TheExactEngineKeepsItsTime)
{
  const FacetComplex surface = testmeshes::ToComplex(testmeshes::RandomSoup(5, 2000));
  Monitor monitor;
  constexpr double over = 1e-9; // by the time of the first report
  const Tetrahedralization result =
    ConstrainedDelaunay(surface, { over, 0, TetrahedralizationEngine::Exact }, monitor);
  EXPECT_EQ(result.Rung, LastRung());
  ASSERT_FALSE(result.Failures.empty());
  EXPECT_NE(result.Failures[0].find("more than the time"), std::string::npos);
  testmeshes::ExpectMeshLaws(surface, result.Mesh);
}

TEST(TetrahedralizerFaults, TheExactEngineTakesNoProcessorTimeIntoAccount)
{
  const TetrahedralizerBudget noProcessorTime = { HUGE_VAL, 0 };
  Monitor monitor;
  const TetrahedralMesh mesh = TryRung(1, UnitBox(), noProcessorTime, monitor);
  EXPECT_TRUE(mesh.LostFacets.empty());
}

TEST(TetrahedralizerFaults, NothingOfTetGenIsPrinted)
{
  // Facets that cross make TetGen print, fail assertions and crash.
  const FacetComplex crossing = testmeshes::ToComplex(testmeshes::RandomSoup(3, 60));
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  Monitor monitor;
  const Tetrahedralization result =
    ConstrainedDelaunay(crossing, { 2, Mebibytes, TetGen }, monitor);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(result.Failures.empty());
}

/** 4 soups, or as many as the environment variable INSIDEOUT_SOUPS says; then it prints what became
 * of them. */
TEST(ConstrainedDelaunay, AnswersToEveryResolvedSoup)
{
  const char* asked = std::getenv("INSIDEOUT_SOUPS");
  const unsigned soups = asked ? static_cast<unsigned>(std::atoi(asked)) : 4;
  std::map<int, int> rungs;
  std::size_t lost = 0;
  for (unsigned seed = 1; seed <= soups; ++seed)
  {
    const int triangles = 200 + static_cast<int>(seed * 1103515245U / 65536U % 1801U);
    Monitor monitor;
    const FacetComplex surface = ResolveSelfIntersections(
      CountFacets(DirtySoup(seed, asked ? triangles : 200), {}, monitor).Surface, monitor)
                                   .Surface;
    const Tetrahedralization result = ConstrainedDelaunay(surface, {}, monitor);
    if (!asked || seed % 10 == 0)
    {
      testmeshes::ExpectMeshLaws(surface, result.Mesh);
    }
    ASSERT_GT(result.Mesh.NumberOfCells(), 0) << seed;
    ++rungs[result.Rung];
    lost += result.Mesh.LostFacets.size();
  }
  for (const auto& [rung, count] : rungs)
  {
    std::printf("%4d %s\n", count, RungName(rung));
  }
  std::printf("%4zu facets lost\n", lost);
}
