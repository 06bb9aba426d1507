// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Team.h"
#include "Support/Corpus.h"
#include "Support/ExactReference.h"
#include "Support/ResolutionLaws.h"
#include "Support/SurfaceFamilies.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cctype>
#include <iostream>

using namespace insideout;
using namespace testmeshes;

/** The resolver before an independent judge (ResolutionLaws.h), on families that are hard for it.
 */
namespace
{
FacetComplex Validated(const TriangleSoup& soup, bool countDuplicates = false)
{
  Monitor monitor;
  CountedChainParameters parameters;
  parameters.CountDuplicates = countDuplicates;
  return CountFacets(soup, parameters, monitor).Surface;
}

Resolution Resolve(const FacetComplex& surface, int threads)
{
  const int before = omp_get_max_threads();
  omp_set_num_threads(threads);
  const WholeTeams teams;
  Monitor monitor;
  Resolution resolution = ResolveSelfIntersections(surface, monitor);
  omp_set_num_threads(before);
  return resolution;
}

/** Facets of a family: given, resolved, left out. */
struct Tally
{
  Id Given = 0;
  Id Resolved = 0;
  Id LeftOut = 0;
};

void JudgeMember(const FacetComplex& before, const std::vector<int>& moreThreads, Tally& tally)
{
  const Resolution resolution = Resolve(before, 2);
  EXPECT_EQ(resolution.IntersectingPairs, IntersectionsBySweep(before.Points, before.Facets));
  const ResolutionJudgement judged = JudgeResolution(before, resolution.Surface, 20);
  for (const std::string& violation : judged.Violations)
  {
    ADD_FAILURE() << violation;
  }
  for (const int threads : moreThreads)
  {
    EXPECT_TRUE(SameBytes(Resolve(before, threads).Surface, resolution.Surface))
      << threads << " threads";
  }
  tally.Given += before.NumberOfFacets();
  tally.Resolved += resolution.Surface.NumberOfFacets();
  tally.LeftOut += judged.LeftOut;
}

void JudgeFamily(const SurfaceFamily& family, const std::vector<int>& moreThreads)
{
  Tally tally;
  for (std::size_t i = 0; i < family.Members.size(); ++i)
  {
    SCOPED_TRACE(family.Name + " " + std::to_string(i));
    JudgeMember(Validated(family.Members[i]), moreThreads, tally);
  }
  std::cout << family.Name << ": " << family.Members.size() << " surfaces, " << tally.Given
            << " facets, " << tally.Resolved << " resolved, " << tally.LeftOut << " left out\n";
  EXPECT_EQ(tally.LeftOut, 0);
}

class ResolvedFamilies : public testing::TestWithParam<SurfaceFamily>
{
};

/** Twice the area of the facets in the plane across `axis` at `level`, exactly: all normals there
 * point along the axis. */
CGAL::Exact_rational ExactTwiceArea(const FacetComplex& surface, int axis, double level)
{
  using Rational = CGAL::Exact_rational;
  Rational sum = 0;
  for (const Triangle& t : surface.Facets)
  {
    const Point& a = surface.Points[t[0]];
    const Point& b = surface.Points[t[1]];
    const Point& c = surface.Points[t[2]];
    if (a[axis] == level && b[axis] == level && c[axis] == level)
    {
      const int x = (axis + 1) % 3;
      const int y = (axis + 2) % 3;
      sum += CGAL::abs(Rational((Rational(b[x]) - a[x]) * (Rational(c[y]) - a[y]) -
        (Rational(b[y]) - a[y]) * (Rational(c[x]) - a[x])));
    }
  }
  return sum;
}

/** Stops at its n-th question and counts them. */
class StopAt : public Monitor
{
public:
  explicit StopAt(int n)
    : Stop(n)
  {
  }
  bool Continue(const char*, double) override { return ++this->Asked < this->Stop; }

  int Asked = 0;

private:
  const int Stop;
};
} // namespace

TEST_P(ResolvedFamilies, HoldTheirLaws)
{
  JudgeFamily(GetParam(), { 1, 5 });
}

INSTANTIATE_TEST_SUITE_P(All, ResolvedFamilies, testing::ValuesIn(SurfaceFamilies(4)),
  [](const testing::TestParamInfo<SurfaceFamily>& info)
  {
    std::string name = info.param.Name;
    std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(c) == 0; }, '_');
    return name;
  });

/**
 * The corners of the first facet are so near to points of the others that all slivers at point 2
 * collapse, which lies within a facet then: no facet has it, but the tetrahedra do.
 */
TEST(ResolvedSlivers, KeepNoPointWithinAFacetThatNoneHas)
{
  Tally tally;
  JudgeMember(Validated(CorpusSurface("slivers-take-all-facets")), { 1, 5 }, tally);
  EXPECT_EQ(tally.LeftOut, 0);
}

TEST(ResolvedGridSoups, HoldTheirLaws)
{
  JudgeFamily(GridSoups(5), {});
}

TEST(ResolvedBoxes, KeepTheExactAreaInEachPlane)
{
  // Cubes at quarters: all cuts are at dyadic coordinates, so that nothing is rounded and areas of
  // the union can be told exactly.
  const FacetComplex resolved = Resolve(
    Validated(Join(Join(Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 0.75, 1.25, 0 }, { 2.75, 3.25, 2 })),
      Box({ 1.5, 0.5, 0 }, { 3.5, 2.5, 2 }))),
    2)
                                  .Surface;
  // By inclusion and exclusion: 3 squares of 4, overlaps of 0.9375, 0.75 and 1.5625, and the
  // common part of all three, 0.5 by 0.75.
  const CGAL::Exact_rational area =
    CGAL::Exact_rational(3 * 4 - 1.25 * 0.75 - 0.5 * 1.5 - 1.25 * 1.25 + 0.5 * 0.75);
  EXPECT_EQ(ExactTwiceArea(resolved, 2, 0), 2 * area);
  EXPECT_EQ(ExactTwiceArea(resolved, 2, 2), 2 * area);
}

TEST(ResolvedDuplicates, CountAsOftenAsGiven)
{
  TriangleSoup soup = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.5, 0.25, 0 }, { 1.5, 1, 1 }));
  const std::vector<Triangle> once = soup.Triangles;
  for (int i = 1; i < 1000; ++i)
  {
    soup.Triangles.insert(soup.Triangles.end(), once.begin(), once.end());
  }
  Tally tally;
  JudgeMember(Validated(soup, true), { 1, 5 }, tally);
  EXPECT_EQ(tally.Given, 24);
  EXPECT_EQ(tally.LeftOut, 0);
}

TEST(StoppedResolution, AsksNoFurtherOnAnyNumberOfThreads)
{
  const FacetComplex complex = Validated(GridSoup(1, 60, 5));
  StopAt never(1 << 30);
  ResolveSelfIntersections(complex, never);
  // The loops ask: the number of questions grows with the facets that cross, all 60 of them.
  ASSERT_GT(never.Asked, 60 / omp_get_max_threads());
  const int before = omp_get_max_threads();
  for (const int threads : { 1, 2, 5 })
  {
    omp_set_num_threads(threads);
    // With several threads the calling thread may come to fewer questions; the first always comes.
    for (const int n : { 1, 2, 3 })
    {
      StopAt monitor(n);
      try
      {
        ResolveSelfIntersections(complex, monitor);
        ADD_FAILURE() << "went on at question " << n;
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.Code, ErrorCode::Stopped);
      }
      EXPECT_EQ(monitor.Asked, n);
    }
  }
  omp_set_num_threads(before);
}
