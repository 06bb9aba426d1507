// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/PartsApart.h"

#include "Common/Box.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using namespace insideout;
using testmeshes::Join;

TriangleSoup BoxAt(Point low, double size)
{
  return testmeshes::Box(low, { low[0] + size, low[1] + size, low[2] + size });
}

TriangleSoup OpenBoxAt(Point low, double size)
{
  TriangleSoup box = BoxAt(low, size);
  box.Triangles.pop_back();
  return box;
}

TriangleSoup TriangleAt(Point corner)
{
  const auto [x, y, z] = corner;
  return { { { x, y, z }, { x + 1, y, z }, { x, y + 1, z } }, { { { 0, 1, 2 } } } };
}

std::vector<Id> PartsOf(const std::vector<TriangleSoup>& soups)
{
  TriangleSoup all;
  for (const TriangleSoup& soup : soups)
  {
    all = Join(std::move(all), soup);
  }
  Monitor silent;
  const std::vector<Id> parts = PartsApart(testmeshes::ToComplex(all), silent);
  std::vector<Id> ofSoup; // of its first point
  std::size_t first = 0;
  for (const TriangleSoup& soup : soups)
  {
    ofSoup.push_back(parts.at(first));
    for (std::size_t p = 0; p < soup.Points.size(); ++p)
    {
      EXPECT_EQ(parts.at(first + p), ofSoup.back());
    }
    first += soup.Points.size();
  }
  EXPECT_EQ(first, parts.size());
  return ofSoup;
}

using Parts = std::vector<Id>;

/** The same by trying all pairs until nothing changes. */
Parts PartsByPairs(std::vector<Box> boxes)
{
  Parts parts(boxes.size());
  std::iota(parts.begin(), parts.end(), 0);
  for (bool changes = true; changes;)
  {
    changes = false;
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if (parts[i] != parts[j] && boxes[i].Meets(boxes[j]))
        {
          Box both = boxes[i];
          both.Add(boxes[j]);
          const auto [low, high] = std::minmax(parts[i], parts[j]);
          const Id to = low;
          const Id from = high;
          for (std::size_t k = 0; k < boxes.size(); ++k)
          {
            parts[k] = parts[k] == from ? to : parts[k];
            boxes[k] = parts[k] == to ? both : boxes[k];
          }
          changes = true;
        }
      }
    }
  }
  return parts;
}
} // namespace

TEST(PartsApart, AreThoseWhoseBoxesDoNotMeet)
{
  EXPECT_EQ(PartsOf({ BoxAt({ 0, 0, 0 }, 1), BoxAt({ 2, 0, 0 }, 1) }), (Parts{ 0, 1 }));
  EXPECT_EQ(PartsOf({ BoxAt({ 0, 0, 0 }, 1), BoxAt({ 1, 0, 0 }, 1) }), (Parts{ 0, 0 })) << "touch";
  EXPECT_EQ(PartsOf({ BoxAt({ 1, 1, 1 }, 1), BoxAt({ 0, 0, 0 }, 3) }), (Parts{ 0, 0 })) << "within";
}

TEST(PartsApart, BoxesThatJoinMayMeetOthers)
{
  // The third meets neither of the first two, but their box; the fourth then that of three.
  EXPECT_EQ(PartsOf({ BoxAt({ 0, 0, 0 }, 4), BoxAt({ 3, 3, 0 }, 4), BoxAt({ 5, 1, 3.5 }, 1.8),
              BoxAt({ 1, 5.5, 4.5 }, 0.5), BoxAt({ 20, 0, 0 }, 1) }),
    (Parts{ 0, 0, 0, 0, 1 }));
}

TEST(PartsApart, OfRandomBoxesAreThoseThatAllPairsGive)
{
  constexpr Id Boxes = 60;
  std::vector<Id> counts;
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<TriangleSoup> soups;
    std::vector<Box> boxes;
    const auto next = [&](double most)
    { return most * static_cast<double>(random() % 1024) / 1024; };
    for (int i = 0; i < Boxes; ++i)
    {
      soups.push_back(BoxAt({ next(24), next(24), next(24) }, 0.1 + next(3.5)));
      boxes.push_back(BoundingBox(soups.back().Points));
    }
    Parts expected = PartsByPairs(boxes);
    Id count = 0;
    Parts number(expected.size(), None);
    for (Id& part : expected)
    {
      number[part] = number[part] == None ? count++ : number[part];
      part = number[part];
    }
    EXPECT_EQ(PartsOf(soups), expected) << seed;
    counts.push_back(count);
  }
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 1);
  EXPECT_LT(*std::max_element(counts.begin(), counts.end()), Boxes);
}

TEST(PartsApart, AllOpenPiecesAreOne)
{
  EXPECT_EQ(PartsOf({ BoxAt({ 0, 0, 0 }, 1), OpenBoxAt({ 2, 0, 0 }, 1), BoxAt({ 4, 0, 9 }, 1),
              OpenBoxAt({ 6, 0, 0 }, 1), BoxAt({ 4, 0, 0.5 }, 0.25) }),
    (Parts{ 0, 1, 2, 1, 1 }))
    << "and what is between them";
}

TEST(PartsApart, FlatPiecesJoinOpenOnesOrElseTheFirstOther)
{
  const TriangleSoup solid = BoxAt({ 0, 0, 0 }, 1);
  EXPECT_EQ(
    PartsOf({ solid, TriangleAt({ 5, 0, 0 }), OpenBoxAt({ 9, 9, 9 }, 1) }), (Parts{ 0, 1, 1 }));
  EXPECT_EQ(PartsOf({ BoxAt({ 0, 9, 0 }, 1), TriangleAt({ 5, 0, 5 }), BoxAt({ 0, 0, 9 }, 1) }),
    (Parts{ 0, 0, 1 }));
  EXPECT_EQ(PartsOf({ TriangleAt({ 0, 0, 0 }), TriangleAt({ 5, 0, 0 }) }), (Parts{ 0, 0 }));
}

TEST(PartsApart, AClosedPieceIsOneWhoseFacetsCancelOnEachEdge)
{
  FacetComplex surface = testmeshes::ToComplex(
    Join(BoxAt({ 0, 0, 0 }, 1), Join(OpenBoxAt({ 2, 0, 0 }, 1), OpenBoxAt({ 4, 0, 0 }, 1))));
  Monitor silent;
  EXPECT_EQ(PartsApart(surface, silent).back(), 1);
  std::fill(surface.Multiplicity.begin(), surface.Multiplicity.end(), std::int16_t(0));
  EXPECT_EQ(PartsApart(surface, silent).back(), 2) << "what counts nothing is closed";
}

TEST(PartsApart, StopsWhenAsked)
{
  class Stopping : public Monitor
  {
    bool Continue(const char*, double) override { return false; }
  } stopping;
  EXPECT_THROW(PartsApart(testmeshes::ToComplex(BoxAt({ 0, 0, 0 }, 1)), stopping), Error);
}
