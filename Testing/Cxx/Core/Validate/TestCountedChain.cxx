// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/CountedChain.h"

#include "Common/SortedTriangle.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

using namespace insideout;
using namespace testmeshes;

namespace
{
CountedChain Count(const TriangleSoup& soup, CountedChainParameters parameters = {})
{
  Monitor monitor;
  return CountFacets(soup, parameters, monitor);
}

void ExpectError(const TriangleSoup& soup, ErrorCode code, const std::string& words)
{
  try
  {
    Count(soup);
    FAIL() << "no error where one says: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.Code, code);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

double SignedVolume(const FacetComplex& surface)
{
  double volume = 0;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Point& a = surface.Points[surface.Facets[f][0]];
    const Point& b = surface.Points[surface.Facets[f][1]];
    const Point& c = surface.Points[surface.Facets[f][2]];
    volume += surface.Multiplicity[f] *
      (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
        a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6;
  }
  return volume;
}
} // namespace

TEST(CountedChain, TakesACleanBoxAsItIs)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const CountedChain chain = Count(box);
  EXPECT_EQ(chain.Surface.Points, box.Points);
  EXPECT_EQ(chain.Surface.Facets, box.Triangles);
  EXPECT_EQ(chain.Surface.NumberOfConstraints, 12);
  EXPECT_EQ(chain.Counts.OpenEdges, 0);
  EXPECT_EQ(chain.Counts.NonManifoldEdges, 0);
  EXPECT_EQ(chain.Counts.Components, 1);
  EXPECT_TRUE(chain.Warnings.empty());
  EXPECT_DOUBLE_EQ(SignedVolume(chain.Surface), 1);
}

TEST(CountedChain, MergesEqualPointsIntoTheLowestAndTakesMinusZeroForZero)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  TriangleSoup torn;
  for (const Triangle& t : box.Triangles)
  {
    for (const Id p : t)
    {
      Point x = box.Points[p];
      x[0] = x[0] == 0 && torn.Points.size() % 2 ? -0.0 : x[0];
      torn.Points.push_back(x);
    }
    const Id n = static_cast<Id>(torn.Points.size());
    torn.Triangles.push_back({ n - 3, n - 2, n - 1 });
  }
  const CountedChain chain = Count(torn);
  EXPECT_EQ(chain.Counts.Points, 8);
  EXPECT_EQ(chain.Counts.MergedPoints, 28);
  EXPECT_EQ(chain.Counts.OpenEdges, 0);
  for (std::size_t p = 0; p < chain.Surface.Points.size(); ++p)
  {
    const Id origin = chain.Surface.Origins[p].Points[0];
    for (Id q = 0; q < origin; ++q)
    {
      EXPECT_NE(torn.Points[q], torn.Points[origin]) << "a lower point is equal";
    }
    EXPECT_EQ(std::signbit(chain.Surface.Points[p][0]), std::signbit(torn.Points[origin][0]));
  }
}

TEST(CountedChain, MergesNearPointsOnlyWhenAsked)
{
  TriangleSoup box = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1 + 1e-9, 0, 0 }, { 2, 1, 1 }));
  EXPECT_EQ(Count(box).Counts.Points, 16);
  CountedChainParameters parameters;
  parameters.MergeTolerance = 1e-8;
  const CountedChain chain = Count(box, parameters);
  EXPECT_EQ(chain.Counts.Points, 12);
  EXPECT_EQ(chain.Counts.CancelledFacets, 2) << "the wall between the boxes";
  parameters.MergeTolerance = -1;
  EXPECT_THROW(Count(box, parameters), Error);
}

TEST(CountedChain, MergesNearPointsBesideOnesThatAreNotFinite)
{
  TriangleSoup box = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1 + 1e-9, 0, 0 }, { 2, 1, 1 }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  box.Points.insert(box.Points.begin(), { nan, nan, nan }); // no facet uses it
  for (Triangle& t : box.Triangles)
  {
    t = { { t[0] + 1, t[1] + 1, t[2] + 1 } };
  }
  CountedChainParameters parameters;
  parameters.MergeTolerance = 1e-8;
  EXPECT_EQ(Count(box, parameters).Counts.Points, 12);
}

TEST(CountedChain, LeavesOutDegenerateFacetsAndCountsThem)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Points.push_back({ 0.5, 0, 0 });
  box.Triangles.push_back({ 0, 8, 1 }); // on a line
  box.Triangles.push_back({ 3, 3, 4 }); // two equal corners
  const CountedChain chain = Count(box);
  EXPECT_EQ(chain.Counts.DegenerateFacets, 2);
  EXPECT_EQ(chain.Counts.Facets, 12);
  EXPECT_EQ(chain.Counts.Points, 8) << "a point that no valid facet uses is no constraint";
  EXPECT_EQ(chain.Warnings.size(), 1u);
}

TEST(CountedChain, KeepsANeedleThatIsNotExactlyFlat)
{
  TriangleSoup needle;
  needle.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 5e-324, 0 } };
  needle.Triangles = { { 0, 1, 2 } };
  EXPECT_EQ(Count(needle).Counts.Facets, 1);
}

TEST(CountedChain, CountsRepeatedFacetsOnceAndOppositeOnesAsTheSurfaceCloses)
{
  const auto turned = [](const Triangle& t) { return Triangle{ { t[0], t[2], t[1] } }; };
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const Triangle first = box.Triangles[0];
  box.Triangles.push_back({ first[1], first[2], first[0] });
  box.Triangles.push_back(turned(box.Triangles[1]));
  CountedChain chain = Count(box);
  EXPECT_EQ(chain.Surface.Multiplicity, std::vector<std::int16_t>(12, 1));
  EXPECT_EQ(chain.Counts.DuplicateFacets, 2);
  EXPECT_EQ(chain.Counts.CancelledFacets, 0);
  ASSERT_EQ(chain.Surface.SourceOffsets[1], 2);
  EXPECT_EQ(chain.Surface.Sources[1].Triangle, 12);
  EXPECT_FALSE(chain.Surface.Sources[1].Reversed);
  EXPECT_EQ(chain.Surface.Sources[3].Triangle, 13);
  EXPECT_TRUE(chain.Surface.Sources[3].Reversed);

  CountedChainParameters each;
  each.CountDuplicates = true;
  EXPECT_EQ(Count(box, each).Surface.Multiplicity[0], 2);
  EXPECT_EQ(Count(box, each).Surface.Multiplicity[1], 0);

  // Half of the sides both ways, whichever way the others face.
  for (const TriangleSoup& cube : { Box({ 0, 0, 0 }, { 1, 1, 1 }), Reversed(box) })
  {
    TriangleSoup half = cube;
    half.Triangles.resize(12);
    for (std::size_t t = 2; t < 8; ++t)
    {
      half.Triangles.insert(half.Triangles.begin(), turned(cube.Triangles[t]));
    }
    chain = Count(half);
    EXPECT_EQ(chain.Counts.CancelledFacets, 0);
    EXPECT_DOUBLE_EQ(std::abs(SignedVolume(chain.Surface)), 1);
  }

  // A wall that is drawn from both sides closes nothing.
  TriangleSoup walled = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 }));
  EXPECT_EQ(Count(walled).Counts.CancelledFacets, 2);
}

TEST(CountedChain, KeepsATwoSidedSolidOnceTurnedOutward)
{
  for (const bool inwardFirst : { false, true })
  {
    const TriangleSoup box = Box({ 0, 0, 0 }, { 2, 1, 1 });
    TriangleSoup soup = inwardFirst ? Reversed(box) : box;
    for (const Triangle& t : box.Triangles)
    {
      soup.Triangles.push_back(inwardFirst ? t : Triangle{ { t[0], t[2], t[1] } });
    }
    const CountedChain chain = Count(soup);
    EXPECT_EQ(chain.Counts.TwoSidedSolids, 1);
    EXPECT_DOUBLE_EQ(SignedVolume(chain.Surface), 2);
    EXPECT_EQ(chain.Warnings.size(), 1u);
  }
}

TEST(CountedChain, TurnsEachOfTwoTwoSidedSolidsOutwardThatTouchInAnEdge)
{
  const TriangleSoup small = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleSoup large = Box({ 1, 1, 0 }, { 3, 3, 1 }); // they share the edge x = y = 1
  for (const bool turned : { false, true })
  {
    const TriangleSoup once = Join(small, turned ? Reversed(large) : large);
    TriangleSoup soup = once;
    for (const Triangle& t : once.Triangles)
    {
      soup.Triangles.push_back({ { t[0], t[2], t[1] } });
    }
    const CountedChain chain = Count(soup);
    EXPECT_EQ(chain.Counts.Components, 1);
    EXPECT_EQ(chain.Counts.TwoSidedSolids, 1);
    EXPECT_EQ(chain.Counts.TwoSidedSheets, 0);
    EXPECT_DOUBLE_EQ(SignedVolume(chain.Surface), 1 + 4);
  }
}

TEST(CountedChain, OrientsATwoSidedSolidWhoseFirstFacetsDisagree)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  TriangleSoup soup = box;
  for (std::size_t t = 0; t < 12; ++t)
  {
    const Triangle& f = box.Triangles[t];
    soup.Triangles.push_back({ f[0], f[2], f[1] });
    if (t % 3 == 1)
    {
      std::swap(soup.Triangles[t], soup.Triangles.back());
    }
  }
  EXPECT_DOUBLE_EQ(SignedVolume(Count(soup).Surface), 1);
}

TEST(CountedChain, TakesGivenMultiplicitiesForWhatTheyAre)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Multiplicity.assign(12, 0); // no two-sided solid: whoever gave these has decided
  box.Multiplicity[3] = 5;
  box.Triangles.push_back({ { box.Triangles[3][0], box.Triangles[3][2], box.Triangles[3][1] } });
  box.Multiplicity.push_back(2);
  const CountedChain chain = Count(box);
  std::vector<std::int16_t> expected(12, 0);
  expected[3] = 5 - 2;
  EXPECT_EQ(chain.Surface.Multiplicity, expected);
  EXPECT_EQ(chain.Counts.TwoSidedSolids, 0);

  box.Multiplicity.pop_back();
  ExpectError(box, ErrorCode::InvalidParameter, "12 multiplicities are given for 13 triangles");
}

TEST(CountedChain, LeavesATwoSidedSheetAtZero)
{
  TriangleSoup soup = Box({ 0, 0, 0 }, { 1, 1, 1 });
  TriangleSoup sheet;
  sheet.Points = { { 5, 0, 0 }, { 6, 0, 0 }, { 5, 1, 0 }, { 6, 1, 0 } };
  sheet.Triangles = { { 0, 1, 2 }, { 1, 3, 2 }, { 2, 1, 0 }, { 2, 3, 1 } };
  const CountedChain chain = Count(Join(soup, sheet));
  EXPECT_EQ(chain.Counts.TwoSidedSheets, 1);
  EXPECT_EQ(chain.Counts.TwoSidedSolids, 0);
  EXPECT_EQ(chain.Counts.Components, 2);
  EXPECT_DOUBLE_EQ(SignedVolume(chain.Surface), 1);
}

TEST(CountedChain, LeavesAFlatClosedTwoSidedComponentAtZero)
{
  // Both diagonals of a square: four facets that close, and enclose nothing.
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0.1 }, { 1, 0, 0.1 }, { 1, 1, 0.1 }, { 0, 1, 0.1 } };
  soup.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  for (int t = 0; t < 4; ++t)
  {
    soup.Triangles.push_back(
      { { soup.Triangles[t][0], soup.Triangles[t][2], soup.Triangles[t][1] } });
  }
  const CountedChain chain = Count(soup);
  EXPECT_EQ(chain.Counts.TwoSidedSheets, 1);
  EXPECT_EQ(chain.Counts.TwoSidedSolids, 0);
}

TEST(CountedChain, CountsAsIfWhatDoesNotParticipateWereNotThere)
{
  int others = 0;
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    TriangleSoup soup = GridSoup(seed, 60, 3);
    const std::size_t once = soup.Triangles.size();
    for (std::size_t t = 0; t < once; t += 2) // duplicates, as given and reversed
    {
      const Triangle& f = soup.Triangles[t];
      soup.Triangles.push_back(
        t % 4 ? Triangle{ { f[2], f[0], f[1] } } : Triangle{ { f[1], f[0], f[2] } });
    }
    std::mt19937 random(seed);
    TriangleSoup participants;
    participants.Points = soup.Points;
    for (const Triangle& t : soup.Triangles)
    {
      soup.NonParticipating.push_back(random() % 3 == 0);
      if (soup.NonParticipating.back() == 0)
      {
        participants.Triangles.push_back(t);
      }
    }
    CountedChainParameters parameters;
    parameters.CountDuplicates = seed % 2 != 0;
    const CountedChain chain = Count(soup, parameters);
    const CountedChain expected = Count(participants, parameters);

    // Per triangle, by the places of its corners, how often it counts along the sorted corners.
    const auto counts = [](const FacetComplex& surface)
    {
      std::map<std::array<Point, 3>, int> result;
      for (Id f = 0; f < surface.NumberOfFacets(); ++f)
      {
        const SortedTriangle sorted(
          surface.Facets[f]); // complexes keep the input's order of points
        result[{ surface.Points[sorted.Points[0]], surface.Points[sorted.Points[1]],
          surface.Points[sorted.Points[2]] }] =
          sorted.Turned ? -surface.Multiplicity[f] : surface.Multiplicity[f];
      }
      return result;
    };
    std::map<std::array<Point, 3>, int> found = counts(chain.Surface);
    for (const auto& [corners, count] : counts(expected.Surface))
    {
      EXPECT_EQ(found.at(corners), count);
      found.erase(corners);
    }
    for (const auto& facet : found)
    {
      EXPECT_EQ(facet.second, 0);
    }
    EXPECT_EQ(static_cast<Id>(found.size()), chain.Counts.NonParticipatingFacets);
    EXPECT_EQ(chain.Surface.NumberOfConstraints, chain.Surface.NumberOfFacets());
    EXPECT_EQ(chain.Counts.CancelledFacets, expected.Counts.CancelledFacets);
    EXPECT_EQ(chain.Counts.TwoSidedSheets, expected.Counts.TwoSidedSheets);
    others += chain.Counts.NonParticipatingFacets;
  }
  EXPECT_GT(others, 100);
}

TEST(CountedChain, KeepsNoSolidTwiceForThatItDoesNotParticipate)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  TriangleSoup soup = Join(box, Box({ 4, 0, 0 }, { 5, 1, 1 }));
  soup.NonParticipating.assign(24, 0);
  std::fill(soup.NonParticipating.begin() + 12, soup.NonParticipating.end(), 1);
  const CountedChain chain = Count(soup);
  EXPECT_DOUBLE_EQ(SignedVolume(chain.Surface), 1);
  EXPECT_EQ(chain.Counts.TwoSidedSolids, 0);
  EXPECT_EQ(chain.Counts.NonParticipatingFacets, 12);
  EXPECT_TRUE(chain.Warnings.empty());

  soup.NonParticipating.pop_back();
  ExpectError(
    soup, ErrorCode::InvalidParameter, "whether they participate is given for 23 of 24 triangles");
}

TEST(CountedChain, SaysWhatBecameOfPointsAndNamesDegenerateTriangles)
{
  TriangleSoup soup = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 }));
  soup.Triangles.insert(soup.Triangles.begin() + 5, { { 1, 8, 3 } }); // 1 and 8 stand together
  const CountedChain chain = Count(soup);
  EXPECT_EQ(chain.DegenerateTriangles, std::vector<Id>({ 5 }));
  EXPECT_EQ(
    chain.MergedInto, std::vector<Id>({ 0, 1, 2, 3, 4, 5, 6, 7, 1, 9, 3, 11, 5, 13, 7, 15 }));
}

TEST(CountedChain, CountsOpenAndNonManifoldEdgesAndComponents)
{
  TriangleSoup soup = Box({ 0, 0, 0 }, { 1, 1, 1 });
  soup.Points.push_back({ 0.5, 0.5, 3 });
  soup.Triangles.push_back({ 4, 5, 8 }); // a fin on the edge 4-5
  soup.Triangles.erase(soup.Triangles.begin());
  const CountedChain chain = Count(soup);
  EXPECT_EQ(chain.Counts.OpenEdges, 3 + 2);
  EXPECT_EQ(chain.Counts.NonManifoldEdges, 1);
  EXPECT_EQ(chain.Counts.Components, 1);
}

TEST(CountedChain, NamesThePointThatIsNotFinite)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Points[5][1] = std::numeric_limits<double>::quiet_NaN();
  ExpectError(box, ErrorCode::PointNotFinite, "point 5 is not finite");
  box.Points[5][1] = -std::numeric_limits<double>::infinity();
  ExpectError(box, ErrorCode::PointNotFinite, "point 5 is not finite");
}

TEST(CountedChain, NamesTheTriangleWhosePointIsOutOfRange)
{
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  box.Triangles[7][2] = 8;
  ExpectError(box, ErrorCode::PointOutOfRange, "triangle 7 refers to point 8 of 8");
  box.Triangles[7][2] = -1;
  ExpectError(box, ErrorCode::PointOutOfRange, "triangle 7 refers to point -1 of 8");
}

TEST(CountedChain, SaysThatThereIsNothing)
{
  ExpectError({}, ErrorCode::EmptySurface, "no polygons");
  TriangleSoup flat;
  flat.Points = { { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 } };
  flat.Triangles = { { 0, 1, 2 }, { 2, 1, 0 } };
  ExpectError(flat, ErrorCode::AllDegenerate, "all 2 triangles are degenerate");
}

TEST(CountedChain, LosesNoTriangleOfASoup)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    TriangleSoup soup = GridSoup(seed, 60, 3);
    const std::size_t once = soup.Triangles.size();
    for (std::size_t t = 0; t < once; t += 3)
    {
      const Triangle& f = soup.Triangles[t];
      soup.Triangles.push_back(
        t % 2 ? Triangle{ { f[2], f[0], f[1] } } : Triangle{ { f[1], f[0], f[2] } });
    }
    const CountedChain chain = Count(soup);
    std::vector<int> seen(soup.Triangles.size(), 0);
    for (Id f = 0; f < chain.Surface.NumberOfFacets(); ++f)
    {
      for (Id s = chain.Surface.SourceOffsets[f]; s < chain.Surface.SourceOffsets[f + 1]; ++s)
      {
        ++seen[chain.Surface.Sources[s].Triangle];
      }
    }
    EXPECT_EQ(seen, std::vector<int>(soup.Triangles.size(), 1));
    EXPECT_EQ(chain.Counts.Facets + chain.Counts.DuplicateFacets, chain.Counts.InputTriangles);
  }
}
