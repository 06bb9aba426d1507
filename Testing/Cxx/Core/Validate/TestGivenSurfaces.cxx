// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/GivenSurfaces.h"

#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace
{
using namespace insideout;
using namespace testmeshes;

/** The part of each triangle. */
std::vector<Id> PartsOf(const TriangleSoup& soup)
{
  Monitor monitor;
  const CountedChain chain = CountFacets(soup, {}, monitor);
  const std::vector<Id> ofSources = FindGivenSurfaces(soup, chain.Surface, chain.Edges);
  std::vector<Id> parts(soup.Triangles.size(), None);
  for (std::size_t s = 0; s < ofSources.size(); ++s)
  {
    parts[chain.Surface.Sources[s].Triangle] = ofSources[s];
  }
  return parts;
}

/** Whether the first 12 triangles are one part, the next 12 another, and so on. */
bool AreBoxes(const std::vector<Id>& parts)
{
  std::set<Id> found;
  for (std::size_t t = 0; t < parts.size(); ++t)
  {
    if (parts[t] != parts[t / 12 * 12])
    {
      return false;
    }
    found.insert(parts[t]);
  }
  return found.size() == parts.size() / 12;
}

const TriangleSoup Low = Box({ 0, 0, 0 }, { 1, 1, 1 });
const TriangleSoup High = Box({ 0, 0, 1 }, { 1, 1, 2 });

TEST(GivenSurfaces, AreTheClosedSurfacesThatWereAppended)
{
  for (const TriangleSoup& second : { High, Reversed(High), Box({ 0, 0, 0 }, { 1, 1, 2 }) })
  {
    const TriangleSoup both = Join(Low, second);
    EXPECT_TRUE(AreBoxes(PartsOf(both)));
    EXPECT_TRUE(AreBoxes(PartsOf(Merged(both))));
    EXPECT_TRUE(AreBoxes(PartsOf(Merged(Join(both, Box({ 0, 1, 0 }, { 1, 2, 1 }))))));
  }
}

TEST(GivenSurfaces, AreWhatSharesPointsWhereTheOrderTellsNothing)
{
  TriangleSoup mixed = Join(Low, High);
  for (std::size_t t = 0; t < 12; t += 2)
  {
    std::swap(mixed.Triangles[t], mixed.Triangles[t + 12]);
  }
  std::vector<Id> parts = PartsOf(mixed);
  for (std::size_t t = 0; t < 12; t += 2)
  {
    std::swap(parts[t], parts[t + 12]);
  }
  EXPECT_TRUE(AreBoxes(parts));
  const std::vector<Id> merged = PartsOf(Merged(mixed));
  EXPECT_EQ(std::set<Id>(merged.begin(), merged.end()).size(), 1u);
}

TEST(GivenSurfaces, AreClosed)
{
  TriangleSoup open = Join(Low, High);
  open.Triangles.pop_back();
  for (const TriangleSoup& soup : { open, Merged(open) })
  {
    std::vector<Id> parts = PartsOf(soup);
    EXPECT_NE(parts.front(), None);
    EXPECT_EQ(parts.back(), None);
    parts.push_back(None);
    EXPECT_TRUE(AreBoxes(parts));
  }
  // The open one first: only points tell.
  std::rotate(open.Triangles.begin(), open.Triangles.begin() + 12, open.Triangles.end());
  const std::vector<Id> parts = PartsOf(open);
  EXPECT_EQ(parts.front(), None);
  EXPECT_NE(parts.back(), None);
}

TEST(GivenSurfaces, AreNoPairsThatCancel)
{
  // Each triangle is followed by its reverse.
  TriangleSoup twoSided = Low;
  twoSided.Triangles.clear();
  for (const Triangle& t : Low.Triangles)
  {
    twoSided.Triangles.push_back(t);
    twoSided.Triangles.push_back({ t[0], t[2], t[1] });
  }
  const std::vector<Id> parts = PartsOf(twoSided);
  EXPECT_EQ(std::set<Id>(parts.begin(), parts.end()).size(), 1u);
}
} // namespace
