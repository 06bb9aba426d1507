// SPDX-License-Identifier: GPL-3.0-or-later
#include "Defects/MeantVolume.h"

#include "Resolve/FindIntersections.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

struct Found : SampledVolumes
{
  std::size_t Pairs;
};

/** The volumes of a surface as given: every facet counts the way it faces. */
Found Find(const TriangleSoup& soup)
{
  Monitor monitor;
  const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
  const auto pairs = FindIntersections(surface.Points, surface.Facets, monitor);
  return { FindMeantVolume(surface, surface.Multiplicity, pairs, monitor), pairs.size() };
}

/** Boxes with faces at whole numbers below `Size`, no two of them in one plane; some boxes face
 * inward. The unit cubes in which w is at least 1, or 2, can be counted. */
class CountedBoxes
{
public:
  CountedBoxes(unsigned seed, int count, int inward)
    : Size(2 * count)
    , W(static_cast<std::size_t>(this->Size * this->Size * this->Size), 0)
  {
    std::mt19937 random(seed);
    std::array<std::vector<int>, 3> planes;
    for (std::vector<int>& axis : planes)
    {
      for (int i = 0; i < this->Size; ++i)
      {
        axis.push_back(i);
      }
      std::shuffle(axis.begin(), axis.end(), random);
    }
    for (int box = 0; box < count; ++box)
    {
      std::array<std::array<int, 2>, 3> sides;
      Point low;
      Point high;
      for (int axis = 0; axis < 3; ++axis)
      {
        sides[axis] = { { planes[axis][2 * box], planes[axis][2 * box + 1] } };
        std::sort(sides[axis].begin(), sides[axis].end());
        low[axis] = sides[axis][0];
        high[axis] = sides[axis][1];
      }
      const bool isInward = box >= count - inward;
      this->Soup = Join(this->Soup, isInward ? Reversed(Box(low, high)) : Box(low, high));
      for (int x = sides[0][0]; x < sides[0][1]; ++x)
      {
        for (int y = sides[1][0]; y < sides[1][1]; ++y)
        {
          for (int z = sides[2][0]; z < sides[2][1]; ++z)
          {
            this->W[static_cast<std::size_t>((x * this->Size + y) * this->Size + z)] +=
              isInward ? -1 : 1;
          }
        }
      }
    }
  }

  double VolumeWhere(int least) const
  {
    return static_cast<double>(
      std::count_if(this->W.begin(), this->W.end(), [&](int w) { return w >= least; }));
  }

  const int Size;
  TriangleSoup Soup;

private:
  std::vector<int> W; ///< of unit cubes
};

/** Turn a surface about an axis through the origin. */
TriangleSoup Turned(TriangleSoup soup, double angle)
{
  for (Point& p : soup.Points)
  {
    p = { std::cos(angle) * p[0] - std::sin(angle) * p[1],
      std::sin(angle) * p[0] + std::cos(angle) * p[1], p[2] };
    p = { p[0], std::cos(angle) * p[1] - std::sin(angle) * p[2],
      std::sin(angle) * p[1] + std::cos(angle) * p[2] };
  }
  return soup;
}

TEST(MeantVolume, IsExactForClosedSurfacesThatCross)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    const int count = 1 + static_cast<int>(seed % 6);
    const CountedBoxes boxes(seed, count, static_cast<int>(seed % 3) * (count > 2));
    for (const double angle : { 0.0, 0.1 + seed })
    {
      const Found found = Find(Turned(boxes.Soup, angle));
      ASSERT_LE(found.Pairs, 256u);
      EXPECT_TRUE(found.Solid.IsExact()) << seed;
      EXPECT_NEAR(found.Solid.Value, boxes.VolumeWhere(1), 1e-9) << seed;
      EXPECT_NEAR(found.Overlap.Value, boxes.VolumeWhere(2), 1e-9) << seed;
    }
  }
}

TEST(MeantVolume, IsBetweenItsBoundsWhereCuttingTakesLong)
{
  int sampled = 0;
  int solids = 0;
  int overlaps = 0;
  for (unsigned seed = 0; sampled < 100 && seed < 1000; ++seed)
  {
    const CountedBoxes boxes(seed, 10, static_cast<int>(seed % 3));
    const Found found = Find(Turned(boxes.Soup, 0.1 + seed));
    if (found.Pairs <= 256)
    {
      continue;
    }
    ++sampled;
    EXPECT_FALSE(found.Solid.IsExact());
    solids += found.Solid.Low <= boxes.VolumeWhere(1) && boxes.VolumeWhere(1) <= found.Solid.High;
    overlaps +=
      found.Overlap.Low <= boxes.VolumeWhere(2) && boxes.VolumeWhere(2) <= found.Overlap.High;
    EXPECT_LT(found.Solid.High - found.Solid.Low, 0.1 * boxes.VolumeWhere(1));
  }
  EXPECT_EQ(sampled, 100);
  EXPECT_GE(solids, 95);
  // Few samples meet small overlaps, so that their standard error is uncertain.
  EXPECT_GE(overlaps, 90);
}

TEST(MeantVolume, HasBoundsThatHoldTheVolumeOfAnOpenSurface)
{
  for (int open = 1; open <= 2; ++open)
  {
    TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
    box.Triangles.resize(box.Triangles.size() - static_cast<std::size_t>(open));
    const Found found = Find(Turned(box, open));
    EXPECT_FALSE(found.Solid.IsExact());
    EXPECT_NEAR(found.Solid.Value, 1, 0.05);
    EXPECT_LT(found.Solid.Low, 1);
    EXPECT_GT(found.Solid.High, 1);
    EXPECT_LT(found.Solid.High, 1.5);
  }
}

TEST(MeantVolume, DoesNotLookAtFacetsThatDoNotCount)
{
  TriangleSoup soup = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0.5, 0.5 }, { 2, 2, 2 }));
  Monitor monitor;
  const FacetComplex surface = CountFacets(soup, {}, monitor).Surface;
  const auto pairs = FindIntersections(surface.Points, surface.Facets, monitor);
  std::vector<std::int16_t> multiplicity = surface.Multiplicity;
  std::fill(multiplicity.begin() + 12, multiplicity.end(), std::int16_t(0));
  const SampledVolumes first = FindMeantVolume(surface, multiplicity, pairs, monitor);
  EXPECT_TRUE(first.Solid.IsExact());
  EXPECT_DOUBLE_EQ(first.Solid.Value, 1);
  std::fill(multiplicity.begin(), multiplicity.end(), std::int16_t(0));
  EXPECT_EQ(FindMeantVolume(surface, multiplicity, pairs, monitor).Solid.Value, 0);
}

TEST(MeantVolume, HasTheUnitsOfTheSurface)
{
  for (const double size : { 1e-90, 1e90 })
  {
    TriangleSoup box = Box({ 0, 0, 0 }, { size, size, size });
    EXPECT_NEAR(Find(box).Solid.Value / std::pow(size, 3), 1, 1e-12);
    box.Triangles.pop_back();
    const Found open = Find(box);
    EXPECT_NEAR(open.Solid.Value / std::pow(size, 3), 1, 0.05);
    EXPECT_LT(open.Solid.Low, open.Solid.Value);
  }
}
} // namespace
