// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/PatchWindingNumbers.h"

#include "Common/Vectors.h"
#include "Resolve/ResolveSelfIntersections.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"
#include "WindingNumber/SurfaceWindingNumber.h"
#include "WindingNumber/WindingNumberOfCells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{
using namespace insideout;
using namespace testmeshes;

constexpr ProgressRange Progress = { "orienting", 0, 1 };

FacetComplex Resolved(const TriangleSoup& soup)
{
  Monitor monitor;
  const CountedChain chain = CountFacets(soup, {}, monitor);
  return ResolveSelfIntersections(chain.Surface, monitor).Surface;
}

SurfacePatches PatchesOf(const FacetComplex& surface)
{
  return FindPatches(surface, SortedFacetEdges(surface.Facets));
}

std::vector<PatchSides> SidesOf(const FacetComplex& surface, const SurfacePatches& patches)
{
  const PatchPlaces places(surface, patches);
  std::vector<int> counts;
  for (Id patch = 0; patch < patches.Count; ++patch)
  {
    counts.push_back(surface.Multiplicity[places.FacetOf(patch)]);
  }
  Monitor monitor;
  return places.WindingNumbers(CountedFacets(surface), counts, monitor, Progress);
}

TriangleSoup Cube(double low, double high)
{
  return Box({ low, low, low }, { high, high, high });
}

/** Next to the middle of a facet, on the side of its normal for +1. */
Point Beside(const FacetComplex& surface, Id facet, double side)
{
  const std::array<Point, 3> c = CornersOf(surface.Points, surface.Facets[facet]);
  const Point normal = NormalOf(c[0], c[1], c[2]);
  const double offset = side * 1e-7 / Length(normal);
  Point p;
  for (int axis = 0; axis < 3; ++axis)
  {
    p[axis] = (c[0][axis] + c[1][axis] + 2 * c[2][axis]) / 4 + offset * normal[axis];
  }
  return p;
}

TEST(PatchWindingNumbers, OfTwoOverlappingCubes)
{
  const FacetComplex surface = Resolved(Join(Cube(0, 2), Cube(1, 3)));
  const SurfacePatches patches = PatchesOf(surface);
  ASSERT_EQ(patches.Count, 4); // of each the part without and the part within the other
  std::multiset<std::pair<int, int>> found;
  for (const PatchSides& sides : SidesOf(surface, patches))
  {
    found.insert({ sides.Front, sides.Back });
  }
  EXPECT_EQ(found, (std::multiset<std::pair<int, int>>{ { 0, 1 }, { 0, 1 }, { 1, 2 }, { 1, 2 } }));
}

TEST(PatchWindingNumbers, AreTheSameAllAlongAPatchOfAClosedSurface)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0, 2);
  for (int round = 0; round < 10; ++round)
  {
    TriangleSoup soup;
    for (int i = 0; i < 6; ++i)
    {
      const Point low = { place(random), place(random), place(random) };
      const TriangleSoup box = Box(low, { low[0] + 1, low[1] + 0.7, low[2] + 1.3 });
      soup = Join(soup, random() % 3 ? box : Reversed(box));
    }
    const FacetComplex surface = Resolved(soup);
    ASSERT_TRUE(IsClosed(surface));
    const SurfacePatches patches = PatchesOf(surface);
    const std::vector<PatchSides> sides = SidesOf(surface, patches);
    Monitor monitor;
    const SurfaceWindingNumber w(surface, {}, monitor);
    for (Id f = 0; f < surface.NumberOfFacets(); ++f)
    {
      const PatchSides& patch = sides[patches.Patch[f]];
      // The facets of a patch may run either way, counted the other way round.
      const bool along = surface.Multiplicity[f] == patch.Back - patch.Front;
      const double front = w.At(Beside(surface, f, +1));
      const double back = w.At(Beside(surface, f, -1));
      EXPECT_EQ(along ? front : back, patch.Front) << round;
      EXPECT_EQ(along ? back : front, patch.Back) << round;
    }
  }
}

/** A chain of some facets only: others are places that it has no jump at. */
TEST(PatchWindingNumbers, OfOneOfTwoCubes)
{
  const FacetComplex surface = Resolved(Join(Cube(0, 2), Cube(1, 3)));
  const SurfacePatches patches = PatchesOf(surface);
  const PatchPlaces places(surface, patches);
  const auto isOfSecond = [&](Id facet) { return SourceOfFacet(surface, facet, +1) >= 12; };
  std::vector<CountedTriangle> chain;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (isOfSecond(f))
    {
      chain.push_back({ surface.Facets[f], surface.Multiplicity[f] });
    }
  }
  std::vector<int> counts;
  for (Id patch = 0; patch < patches.Count; ++patch)
  {
    counts.push_back(isOfSecond(places.FacetOf(patch)));
  }
  Monitor monitor;
  std::multiset<std::pair<int, int>> found;
  for (const PatchSides& sides : places.WindingNumbers(chain, counts, monitor, Progress))
  {
    found.insert({ sides.Front, sides.Back });
  }
  EXPECT_EQ(found, (std::multiset<std::pair<int, int>>{ { 0, 0 }, { 0, 1 }, { 0, 1 }, { 1, 1 } }));
}
} // namespace
