// SPDX-License-Identifier: GPL-3.0-or-later
// When single precision has destroyed a surface, and when it is just coarse or far away.
#include "Validate/CoarseCoordinates.h"

#include "Defects/SurfaceDefects.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace insideout;

namespace
{
/** A sphere of radius 10 in map coordinates; its edges are 62 / bands long. */
TriangleSoup InMap(int bands, const Point& origin, bool inFloats)
{
  TriangleSoup soup;
  const double pi = std::acos(-1.0);
  for (int i = 0; i <= bands; ++i)
  {
    for (int j = 0; j < 2 * bands; ++j)
    {
      const double a = pi * i / bands;
      const double b = pi * j / bands;
      const Point on = { { 10 * std::sin(a) * std::cos(b), 10 * std::sin(a) * std::sin(b),
        10 * std::cos(a) } };
      Point p;
      for (int k = 0; k < 3; ++k)
      {
        p[k] = origin[k] + on[k];
        p[k] = inFloats ? static_cast<double>(static_cast<float>(p[k])) : p[k];
      }
      soup.Points.push_back(p);
    }
  }
  const auto id = [&](int i, int j) { return static_cast<Id>(2 * bands * i + j % (2 * bands)); };
  for (int i = 0; i < bands; ++i)
  {
    for (int j = 0; j < 2 * bands; ++j)
    {
      soup.Triangles.push_back({ { id(i, j), id(i + 1, j), id(i + 1, j + 1) } });
      soup.Triangles.push_back({ { id(i, j), id(i + 1, j + 1), id(i, j + 1) } });
    }
  }
  return soup;
}

/** The warnings about single precision when a surface is counted, and when it is checked. */
std::vector<std::string> WordsAbout(const TriangleSoup& soup)
{
  Monitor silent;
  std::vector<std::string> said = CountFacets(soup, {}, silent).Warnings;
  const std::vector<std::string> checked =
    FindSurfaceDefects(soup, 0, Orientation::AsGiven, silent).Warnings;
  said.insert(said.end(), checked.begin(), checked.end());
  said.erase(
    std::remove_if(said.begin(), said.end(),
      [](const std::string& line) { return line.find("single precision") == std::string::npos; }),
    said.end());
  return said;
}

const Point Map = { { 4.5e6, 5.2e6, 120 } };
} // namespace

TEST(CoarseCoordinates, ThatDestroyASurfaceAreToldWithStepEdgeAndRemedy)
{
  const auto said = WordsAbout(InMap(64, Map, true));
  ASSERT_EQ(said.size(), 2u) << "once where it is counted, and once where it is checked";
  EXPECT_EQ(said[0], said[1]);
  EXPECT_EQ(said[0].find("single precision has rounded the coordinates to steps of 0.5, and the "
                         "median edge is only 0."),
    0u)
    << said[0];
  EXPECT_NE(said[0].find("subtract the origin"), std::string::npos) << said[0];
}

TEST(CoarseCoordinates, ThatAreFineEnoughForTheEdgesAreNotTold)
{
  EXPECT_TRUE(WordsAbout(InMap(12, Map, true)).empty()) << "edges of 4";
  EXPECT_TRUE(WordsAbout(InMap(64, { { 0, 0, 0 } }, true)).empty()) << "near the origin";
  EXPECT_TRUE(WordsAbout(InMap(64, { { 500, 300, 100 } }, true)).empty());
}

TEST(CoarseCoordinates, InDoublePrecisionAreNotTold)
{
  EXPECT_TRUE(WordsAbout(InMap(64, Map, false)).empty());
}

TEST(CoarseCoordinates, ThatAreWholeNumbersAreNotRounded)
{
  TriangleSoup box = testmeshes::Box({ 0, 0, 0 }, { 1, 1, 1 });
  for (Point& p : box.Points)
  {
    p = { { p[0] + 4500000, p[1] + 5200000, p[2] } };
  }
  EXPECT_TRUE(WordsAbout(box).empty());
  for (Point& p : box.Points)
  {
    p[2] = 7e6 + 0.5; // a plane says nothing of its own height
  }
  const CoarseCoordinates flat = FindCoarseCoordinates(box.Points, SortedFacetEdges(box.Triangles));
  EXPECT_FALSE(flat.AreTooCoarse());
}
