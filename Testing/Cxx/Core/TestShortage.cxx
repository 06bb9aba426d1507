// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/GmpMemory.h"
#include "Common/Team.h"
#include "Common/ThreadLocals.h"
#include "Files/SurfaceFile.h"
#include "HullMesh.h"
#include "Support/AllowedThreads.h"
#include "Support/ForkedProcess.h"
#include "Support/Shortage.h"
#include "Support/StageHashes.h"
#include "Support/TemporaryFile.h"
#include "Support/TestMeshes.h"

#include <gmp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <new>
#include <thread>

using namespace insideout;
using namespace shortage;
using namespace testmeshes;

namespace
{
constexpr std::size_t Tries = 150;

/** Two boxes that cross, one of them open, and some facets all over the place. */
TriangleSoup BrokenSurface()
{
  TriangleSoup open = Box({ 0.5, 0.5, 0.5 }, { 2, 2.5, 3 });
  open.Triangles.pop_back();
  return Join(Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), open), RandomSoup(5, 6));
}

/** The answer of some work that had enough memory. */
template <class Work>
auto AnswerOf(const Work& work, std::size_t& allocations)
{
  work();                 // what is made once is made
  AllocateThreadLocals(); // as before every filter's work
  const Shortage none(Of::Memory);
  auto answer = work();
  allocations = none.Calls();
  return answer;
}

/**
 * Does the work again and again, each time with no memory at another of its allocations, for that
 * one or from there on. It has to give the answer, or to throw.
 *
 * @return how often it threw std::bad_alloc
 */
template <class Work>
std::size_t FailAtAllocations(const Work& work)
{
  std::size_t allocations = 0;
  const auto answer = AnswerOf(work, allocations);
  std::size_t thrown = 0;
  for (std::size_t i = 0; i < std::min(Tries, allocations); ++i)
  {
    // Every one where there are few; else they are spread, and more of them at the beginning.
    const std::size_t first = allocations <= Tries ? i : i * i * allocations / (Tries * Tries);
    for (const bool forGood : { false, true })
    {
      bool same = true;
      try
      {
        const Shortage shortage(Of::Memory, first + 1, forGood);
        same = work() == answer;
      }
      catch (const std::bad_alloc&)
      {
        ++thrown;
      }
      EXPECT_TRUE(same) << "allocation " << first << (forGood ? " and all that follow" : "");
    }
  }
  EXPECT_EQ(work(), answer);
  return thrown;
}

/** Sets the number of threads of all loops during its lifetime. */
struct Threads
{
  const testthreads::Allowed Allowed;
  const WholeTeams Whole = {};
};
} // namespace

TEST(Shortage, OfMemoryIsBadAllocInEveryStage)
{
  const Threads one{ testthreads::Allowed(1) };
  const TriangleSoup surface = BrokenSurface();
  EXPECT_GT(FailAtAllocations([&] { return HashStages(surface); }), Tries);
}

TEST(Shortage, OfMemoryIsBadAllocOnThreads)
{
  const Threads four{ testthreads::Allowed(4) };
  const TriangleSoup surface = BrokenSurface();
  EXPECT_GT(FailAtAllocations([&] { return HashStages(surface); }), Tries);
}

/** Where it would end the program by itself. */
TEST(Shortage, OfMemoryIsBadAllocInGmp)
{
  ASSERT_TRUE(GmpThrows);
  mpz_t number;
  mpz_init_set_ui(number, 3);
  const auto grow = [&]
  {
    const Shortage shortage(Of::Memory, 1, true);
    mpz_pow_ui(number, number, 100000);
  };
  EXPECT_THROW(grow(), std::bad_alloc);
  EXPECT_EQ(mpz_get_ui(number), 3U);
  mpz_clear(number);
}

TEST(Shortage, OfMemoryIsAnErrorWithTetgen)
{
  const TriangleSoup surface = BrokenSurface();
  const auto work = [&]() -> std::vector<double>
  {
    Monitor monitor;
    HullMeshParameters parameters;
    parameters.Budgets.Engine = TetrahedralizationEngine::TetGen;
    try
    {
      return MeshHull(surface, parameters, monitor).W;
    }
    catch (const Error&)
    {
      throw std::bad_alloc(); // it may be the helper that could not be asked
    }
  };
  EXPECT_GT(FailAtAllocations(work), 0U);
}

TEST(Shortage, OfMemoryIsAnErrorWithFiles)
{
  PolygonSurface surface;
  const TriangleSoup soup = BrokenSurface();
  surface.Points = soup.Points;
  for (const Triangle& triangle : soup.Triangles)
  {
    surface.Corners.insert(surface.Corners.end(), triangle.begin(), triangle.end());
    surface.Offsets.push_back(static_cast<Id>(surface.Corners.size()));
  }
  for (const char* name : { "soup.ply", "soup.obj", "soup.stl" })
  {
    const testfiles::TemporaryFile file(name);
    const auto work = [&]
    {
      Monitor monitor;
      try
      {
        WriteSurface(file.Path, surface, monitor);
        return ReadSurface(file.Path, monitor).Points;
      }
      catch (const Error&)
      {
        throw std::bad_alloc(); // they say which file it is
      }
    };
    EXPECT_GT(FailAtAllocations(work), 0U) << name;
  }
}

TEST(Shortage, OfThreadsLeavesTheWorkToTheOthers)
{
  const Threads four{ testthreads::Allowed(4) };
  const TriangleSoup surface = BrokenSurface();
  const Hashes answer = HashStages(surface);
  std::size_t calls = 0;
  {
    const Shortage none(Of::Threads);
    EXPECT_EQ(HashStages(surface), answer);
    calls = none.Calls();
  }
  EXPECT_GT(calls, 3U);
  for (const bool forGood : { false, true })
  {
    for (std::size_t first = 1; first <= calls; first += std::max<std::size_t>(1, calls / 20))
    {
      const Shortage shortage(Of::Threads, first, forGood);
      EXPECT_EQ(HashStages(surface), answer) << "thread " << first;
    }
  }
}

/** The C library would free in the copy what it has freed in the other process already. */
TEST(Team, IsForkedBeforeOrAfterAThreadIsMadeAndNotWhile)
{
  std::promise<void> areSlow;
  std::thread other(
    [&]
    {
      areSlow.get_future().wait();
      WorkAsTeam(2, [] {});
    });
  {
    const SlowThreads slow;
    areSlow.set_value();
    slow.AwaitOne();
    EXPECT_TRUE(testprocesses::IsTrueInChild([&] { return !slow.IsOneInTheMaking(); }));
  }
  other.join();
}
