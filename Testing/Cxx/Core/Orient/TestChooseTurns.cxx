// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ChooseTurns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

namespace
{
using namespace insideout;

/** Random regions of some shells, with volumes that are no sums of one another. */
std::vector<ShellRegion> RandomRegions(std::mt19937& random, Id shells)
{
  std::vector<ShellRegion> regions;
  std::uniform_real_distribution<double> volume(1, 10);
  for (Id i = 0; i < 3 * shells; ++i)
  {
    ShellRegion region = { {}, volume(random) };
    for (Id shell = 0; shell < shells; ++shell)
    {
      if (random() % 3 == 0)
      {
        region.Windings.push_back({ shell, random() % 2 ? 1 : -1 });
      }
    }
    if (!region.Windings.empty())
    {
      regions.push_back(region);
    }
  }
  return regions;
}

/** The law's volumes. */
std::array<double, 2> Volumes(
  const std::vector<ShellRegion>& regions, const std::vector<char>& turned)
{
  std::array<double, 2> volumes{ { 0, 0 } };
  for (const ShellRegion& region : regions)
  {
    int given = 0;
    int w = 0;
    for (const ShellWinding& winding : region.Windings)
    {
      given += winding.W;
      w += turned[winding.Shell] ? -winding.W : winding.W;
    }
    volumes[0] += w < 0 ? region.Volume : 0;
    volumes[1] += w < 0 || (w > 1 && w > std::abs(given)) ? region.Volume : 0;
  }
  return volumes;
}

TEST(ChooseTurns, LeavesAlmostTheLeastVolumeWithoutMeaning)
{
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round)
  {
    const Id shells = 1 + static_cast<Id>(random() % 8);
    const std::vector<ShellRegion> regions = RandomRegions(random, shells);
    const ShellTurns turns = ChooseTurns(regions, std::vector<Id>(shells, 10));
    double least = 1e300;
    double all = 0;
    for (const ShellRegion& region : regions)
    {
      all += region.Volume;
    }
    for (unsigned way = 0; way < 1u << shells; ++way)
    {
      std::vector<char> turned;
      for (Id i = 0; i < shells; ++i)
      {
        turned.push_back(way >> i & 1);
      }
      least = std::min(least, Volumes(regions, turned)[0]);
    }
    // Two ways count as equal when they differ by little of where they differ.
    EXPECT_LE(Volumes(regions, turns.Turned)[0], least + 0.15 * all);
    const bool isLeast = Volumes(regions, turns.Turned)[0] <= least * (1 + 1e-12);
    const bool isUndecided =
      std::count(turns.Undecided.begin(), turns.Undecided.end(), char(1)) > 0;
    EXPECT_TRUE(isLeast || isUndecided) << round;
  }
}

TEST(ChooseTurns, LooksAtOverlapOnlyAmongTheLeastVolumesWithoutMeaning)
{
  // Outer inward, inner outward: turned both, a cavity; turning the outer alone would overlap.
  const std::vector<ShellRegion> nested = { { { { 0, -1 } }, 5 }, { { { 0, -1 }, { 1, 1 } }, 1 } };
  EXPECT_EQ(ChooseTurns(nested, { 10, 10000 }).Turned, (std::vector<char>{ 1, 1 }));
}

TEST(ChooseTurns, TurnsTheFewestFacetsOfWhatIsEqual)
{
  // As given or all turned, two shells within each other cancel outside of both: a tie.
  const std::vector<ShellRegion> regions = { { { { 0, 1 }, { 1, 1 } }, 1 },
    { { { 0, 1 }, { 1, -1 } }, 1 } };
  EXPECT_EQ(ChooseTurns(regions, { 5, 5 }).Turned, (std::vector<char>{ 0, 0 }));
}

TEST(ChooseTurns, LetsWhatRoundingLeavesBetweenCoplanarFacesTurnNothing)
{
  // An inward shell within an outward one, whose ends are in one plane: the inner may stick out.
  const auto nested = [](double outOfIt) -> std::vector<ShellRegion> {
    return { { { { 0, 1 } }, 5 }, { { { 0, 1 }, { 1, -1 } }, 5 }, { { { 1, -1 } }, outOfIt } };
  };
  for (const double rounding : { 1e-16, 1e-7, 4e-5 })
  {
    const ShellTurns turns = ChooseTurns(nested(rounding), { 10, 10 });
    EXPECT_EQ(turns.Turned, (std::vector<char>{ 0, 0 })) << rounding;
    EXPECT_EQ(turns.Undecided, (std::vector<char>{ 0, 0 })) << rounding;
  }
  EXPECT_EQ(ChooseTurns(nested(1e-3), { 10, 10 }).Turned, (std::vector<char>{ 0, 1 }));
  // The same among more shells than `MostTried`, which are turned one by one.
  std::vector<ShellRegion> many = nested(1e-7);
  for (Id shell = 2; shell < 20; ++shell)
  {
    many.push_back({ { { 0, 1 }, { shell, 1 } }, 1 });
  }
  const ShellTurns turns = ChooseTurns(many, std::vector<Id>(20, 10));
  EXPECT_EQ(turns.Turned, std::vector<char>(20, 0));
  EXPECT_EQ(turns.Undecided, std::vector<char>(20, 0));
}

TEST(ChooseTurns, SaysOfWhatItIsNotSure)
{
  const std::vector<ShellRegion> eight = { { { { 0, 1 } }, 1.0 }, { { { 0, -1 } }, 1.1 } };
  const ShellTurns turns = ChooseTurns(eight, { 7 });
  EXPECT_EQ(turns.Turned, (std::vector<char>{ 0 }));
  EXPECT_EQ(turns.Undecided, (std::vector<char>{ 1 }));
  const std::vector<ShellRegion> clear = { { { { 0, 1 } }, 1 }, { { { 0, -1 } }, 2 } };
  EXPECT_EQ(ChooseTurns(clear, { 7 }).Turned, (std::vector<char>{ 1 }));
  EXPECT_EQ(ChooseTurns(clear, { 7 }).Undecided, (std::vector<char>{ 0 }));
}

TEST(ChooseTurns, FindsTheWayOfManyShellsThatOverlapInARow)
{
  std::mt19937 random(2);
  for (const Id shells : { 12, 13, 100 })
  {
    std::vector<char> inward;
    std::vector<ShellRegion> regions;
    for (Id i = 0; i < shells; ++i)
    {
      inward.push_back(random() % 2);
      const int w = inward[i] ? -1 : 1;
      regions.push_back({ { { i, w } }, 3 });
      if (i > 0)
      {
        regions.push_back({ { { i - 1, inward[i - 1] ? -1 : 1 }, { i, w } }, 1 });
      }
    }
    EXPECT_EQ(ChooseTurns(regions, std::vector<Id>(shells, 4)).Turned, inward) << shells;
  }
}
} // namespace
