// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/SplitAtLoosePoints.h"

#include "Support/ResolutionLaws.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace insideout;
using namespace testmeshes;

namespace
{
/** Two triangles on the diagonal from point 0 to 2 of a square, and loose points. */
FacetComplex SquareWith(const std::vector<Point>& loose)
{
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } };
  soup.Points.insert(soup.Points.end(), loose.begin(), loose.end());
  soup.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return ToComplex(soup);
}

/** Splits, and expects all laws of a resolved surface. */
FacetComplex Split(const FacetComplex& surface)
{
  Monitor monitor;
  FacetComplex split = SplitAtLoosePoints(surface, monitor, { "splitting", 0, 1 });
  for (const std::string& violation : JudgeResolution(surface, split, 0).Violations)
  {
    ADD_FAILURE() << violation;
  }
  return split;
}

int FacetsAt(const FacetComplex& surface, Id point)
{
  return static_cast<int>(std::count_if(surface.Facets.begin(), surface.Facets.end(),
    [=](const Triangle& t) { return t[0] == point || t[1] == point || t[2] == point; }));
}
} // namespace

TEST(SplitAtLoosePoints, ReturnsASurfaceAsItIsWhereNoneLiesInAFacet)
{
  for (const FacetComplex& surface :
    { SquareWith({}), SquareWith({ { 1, 2, 0x1p-1000 }, { 5, 5, 0 }, { 4, 4, 0 } }) })
  {
    EXPECT_TRUE(SameBytes(Split(surface), surface));
  }
}

TEST(SplitAtLoosePoints, CutsAFacetIntoThree)
{
  const FacetComplex split = Split(SquareWith({ { 3, 1, 0 } }));
  EXPECT_EQ(split.NumberOfFacets(), 4);
  EXPECT_EQ(FacetsAt(split, 4), 3);
}

TEST(SplitAtLoosePoints, CutsAllFacetsAlongAnEdge)
{
  const FacetComplex split = Split(SquareWith({ { 1, 1, 0 }, { 3, 3, 0 } }));
  EXPECT_EQ(split.NumberOfFacets(), 6);
  EXPECT_EQ(FacetsAt(split, 4), 4);
  EXPECT_EQ(FacetsAt(split, 5), 4);
}

TEST(SplitAtLoosePoints, TakesTheLowestOfEqualPoints)
{
  const FacetComplex split = Split(SquareWith({ { 3, 3, 0 }, { 1, 1, 0 }, { 1, 1, 0 } }));
  EXPECT_EQ(split.NumberOfFacets(), 6);
  EXPECT_EQ(FacetsAt(split, 5), 4);
  EXPECT_EQ(FacetsAt(split, 6), 0);
}

TEST(SplitAtLoosePoints, CutsAtManyPointsInAnyOrder)
{
  std::mt19937 random(3);
  std::vector<Point> loose;
  for (int i = 0; i < 17 * 17; ++i)
  {
    loose.push_back({ 0.25 * (i % 17), 0.25 * (i / 17), 0 });
  }
  std::shuffle(loose.begin(), loose.end(), random);
  const FacetComplex split = Split(SquareWith(loose));
  // A triangle for each half of the grid's 256 squares: each point is a corner.
  EXPECT_EQ(split.NumberOfFacets(), 2 * 16 * 16);
}

TEST(SplitAtLoosePoints, CanBeStoppedAmongTheManyPointsOfAFacet)
{
  std::vector<Point> loose;
  for (int i = 1; i < 50; ++i)
  {
    loose.push_back({ 0x1p-10 * i, 0x1p-11 * i, 0 });
  }
  const FacetComplex surface = SquareWith(loose);
  const int reports = StopAtEveryReport([&](Monitor& monitor, const ProgressRange& range)
    { SplitAtLoosePoints(surface, monitor, range); });
  EXPECT_EQ(reports, 1 + 49);
}

TEST(SplitAtLoosePoints, TakesCornersOfWhatIsNoConstraintForLoose)
{
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 3, 1, 0 }, { 3, 1, 1 }, { 4, 1, 1 } };
  soup.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  FacetComplex surface = ToComplex(soup);
  surface.NumberOfConstraints = 1;
  surface.Multiplicity = { 2, -3 };
  const FacetComplex split = Split(surface);
  EXPECT_EQ(split.NumberOfConstraints, 3);
  EXPECT_EQ(split.NumberOfFacets(), 4);
  EXPECT_EQ(split.Facets.back(), soup.Triangles[1]);
  EXPECT_EQ(split.Multiplicity, (std::vector<std::int16_t>{ 2, 2, 2, -3 }));
}
