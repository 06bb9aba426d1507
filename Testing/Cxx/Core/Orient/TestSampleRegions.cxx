// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/SampleRegions.h"

#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <map>

namespace
{
using namespace insideout;
using namespace testmeshes;

using Volumes = std::map<std::vector<std::pair<Id, int>>, double>;

Volumes Sample(const TriangleSoup& soup, Id lines, int count = 1)
{
  Monitor monitor;
  const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
  const Shells shells = FindShells(surface, SortedFacetEdges(surface.Facets));
  std::vector<ShellChain> chains =
    CloseShells(surface, SortedFacetEdges(surface.Facets), shells, surface.Points);
  for (ShellChain& chain : chains)
  {
    for (CountedTriangle& triangle : chain.Triangles)
    {
      triangle.Count *= count;
    }
  }
  Volumes volumes;
  for (const ShellRegion& region :
    RegionSampler(surface.Points, chains).Sample(lines, monitor, { "orienting", 0, 1 }))
  {
    std::vector<std::pair<Id, int>> key;
    for (const ShellWinding& winding : region.Windings)
    {
      key.push_back({ winding.Shell, winding.W });
    }
    volumes[key] = region.Volume;
  }
  return volumes;
}

TriangleSoup Cube(double low, double high)
{
  return Box({ low, low, low }, { high, high, high });
}

TEST(RegionSampler, FindsTheVolumesOfBodiesThatCross)
{
  const Volumes volumes =
    Sample(Join(Join(Cube(0, 0.5), Reversed(Cube(0.25, 0.75))), Cube(0.8, 0.9)), 4000);
  ASSERT_EQ(volumes.size(), 4u);
  EXPECT_NEAR(volumes.at({ { 0, 1 } }), 0.125 - 0.015625, 0.003);
  EXPECT_NEAR(volumes.at({ { 0, 1 }, { 1, -1 } }), 0.015625, 0.001);
  EXPECT_NEAR(volumes.at({ { 1, -1 } }), 0.125 - 0.015625, 0.003);
  EXPECT_NEAR(volumes.at({ { 2, 1 } }), 0.001, 0.00003);
}

TEST(RegionSampler, FindsThinShellsAsWellAsThickOnes)
{
  const Volumes volumes = Sample(
    Join(Box({ 0, 0, 0 }, { 0.9, 0.9, 1e-6 }), Box({ 0.1, 0.1, -0.1 }, { 0.101, 0.101, 0.9 })),
    4000);
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes.at({ { 0, 1 } }) / (0.81e-6 - 1e-12), 1, 0.05);
  EXPECT_NEAR(volumes.at({ { 1, 1 } }) / 1e-6, 1, 0.05);
  EXPECT_GT(volumes.at({ { 0, 1 }, { 1, 1 } }), 0);
}

TEST(RegionSampler, WindsAsOftenAsAShellOverlapsItself)
{
  const Volumes volumes = Sample(Cube(0.25, 0.5), 500, 2);
  ASSERT_EQ(volumes.size(), 1u);
  EXPECT_NEAR(volumes.at({ { 0, 2 } }), 0.015625, 0.0015);
}

TEST(RegionSampler, IsNotMisledByFacetsInLineWithEachOther)
{
  // Cubes side by side share planes, edges and corners; many lines come close to them.
  TriangleSoup soup;
  for (int i = 0; i < 8; ++i)
  {
    const Point low = { i & 1 ? 0.5 : 0.25, i & 2 ? 0.5 : 0.25, i & 4 ? 0.5 : 0.25 };
    soup = Join(soup, Box(low, { low[0] + 0.25, low[1] + 0.25, low[2] + 0.25 }));
  }
  double sum = 0;
  for (const auto& [key, volume] : Sample(soup, 1000))
  {
    for (const auto& [shell, w] : key)
    {
      EXPECT_EQ(w, 1);
    }
    sum += volume;
  }
  EXPECT_NEAR(sum, 0.125, 0.005);
}
} // namespace
