// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/OrientFacets.h"

#include "Common/Team.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <omp.h>

namespace
{
using namespace insideout;
using namespace testmeshes;

FacetComplex Chain(const TriangleSoup& soup)
{
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

struct Oriented
{
  FacetComplex Surface;
  FacetTurns Turns;
};

Oriented Orient(const TriangleSoup& soup, Orientation orientation = Orientation::Automatic)
{
  Monitor monitor;
  Oriented oriented = { Chain(soup), {} };
  oriented.Turns =
    OrientFacets(oriented.Surface, SortedFacetEdges(oriented.Surface.Facets), orientation, monitor);
  return oriented;
}

/** Which of some parts of 12 facets, one after the other, are turned: '+' not, '-' all, '?' some.
 */
std::string TurnsOfBoxes(const FacetTurns& turns)
{
  std::string text;
  for (std::size_t first = 0; first + 12 <= turns.Turned.size(); first += 12)
  {
    const auto begin = turns.Turned.begin() + static_cast<std::ptrdiff_t>(first);
    const auto turned = std::count(begin, begin + 12, char(1));
    text += turned == 0 ? '+' : turned == 12 ? '-' : '?';
  }
  return text;
}

TriangleSoup Cube(double low, double high, bool outward = true)
{
  const TriangleSoup cube = Box({ low, low, low }, { high, high, high });
  return outward ? cube : Reversed(cube);
}

/** An open square that faces up. */
TriangleSoup Ground(double half)
{
  TriangleSoup ground;
  ground.Points = { { -half, -half, -1 }, { half, -half, -1 }, { half, half, -1 },
    { -half, half, -1 } };
  ground.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  return ground;
}

TEST(OrientFacets, TurnsNothingThatFacesOutward)
{
  const Oriented oriented = Orient(Join(Cube(0, 1), Cube(2, 3)));
  EXPECT_EQ(oriented.Turns.TurnedFacets, 0);
  EXPECT_EQ(oriented.Turns.Shells, 2);
  EXPECT_EQ(oriented.Turns.Kinds.Sheets, 0);
  EXPECT_TRUE(oriented.Turns.Warnings.empty());
}

TEST(OrientFacets, TurnsTheOneOfTwoSeparateCubesThatIsInsideOut)
{
  const Oriented oriented = Orient(Join(Cube(0, 1), Cube(2, 4, false)));
  EXPECT_EQ(TurnsOfBoxes(oriented.Turns), "+-");
  EXPECT_EQ(oriented.Turns.TurnedShells, 1);
  EXPECT_NEAR(oriented.Turns.TurnedShare, 0.8, 1e-12);
  ASSERT_EQ(oriented.Turns.Warnings.size(), 1u);
  EXPECT_EQ(oriented.Turns.Warnings[0],
    "1 of 2 shells are inside out and are turned over (12 facets, 80 % of the area)");
}

TEST(OrientFacets, TurnsTheOneOfTwoOverlappingCubesThatIsInsideOut)
{
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 2), Cube(1, 3, false))).Turns), "+-");
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 2, false), Cube(1, 3))).Turns), "-+");
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 2), Cube(1, 3))).Turns), "++");
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 2, false), Cube(1, 3, false))).Turns), "--");
}

TEST(OrientFacets, KeepsACavityAndTurnsOneThatIsInsideOutAsAWhole)
{
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 9), Cube(3, 6, false))).Turns), "++");
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 9, false), Cube(3, 6))).Turns), "--");
}

TEST(OrientFacets, KeepsAPartWithinAPartAndTurnsBothIfBothAreInsideOut)
{
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 9), Cube(3, 6))).Turns), "++");
  EXPECT_EQ(TurnsOfBoxes(Orient(Join(Cube(0, 9, false), Cube(3, 6, false))).Turns), "--");
}

TEST(OrientFacets, DoubtsCopiesThatDoNotCountWhereFacetsDisagree)
{
  TriangleSoup plates;
  for (const double height : { 0.1, 0.2, 0.3 })
  {
    plates = Join(plates, Box({ 0, 0, 0 }, { 1, 1, height }));
  }
  EXPECT_EQ(Orient(plates).Turns.DoubtfulCopies, 0);
  EXPECT_EQ(Orient(Join(Cube(0, 1), Cube(0, 1))).Turns.DoubtfulCopies, 0);
  EXPECT_EQ(Orient(Join(Cube(0, 1), Cube(0, 1, false))).Turns.DoubtfulCopies, 0);
  EXPECT_EQ(Orient(Join(Cube(0, 1), Box({ 1, 0, 0 }, { 2, 1, 1 }))).Turns.DoubtfulCopies, 0);
  const FacetComplex chain = Chain(plates);
  const auto isShared = [&](std::size_t f)
  { return chain.SourceOffsets[f + 1] - chain.SourceOffsets[f] == 3; };
  for (std::size_t t = 0; t < 12; ++t)
  {
    TriangleSoup reversed = plates;
    std::swap(reversed.Triangles[t][1], reversed.Triangles[t][2]);
    const FacetTurns turns = Orient(reversed).Turns;
    EXPECT_EQ(turns.DoubtfulCopies, isShared(t)) << t;
    if (turns.DoubtfulCopies > 0)
    {
      EXPECT_EQ(turns.Warnings.back(),
        "1 facet given again may count too little, because facets disagree or leave edges open: if "
        "closed surfaces share "
        "facets, give each surface as a body");
    }
  }
}

/** The rule that the room's page documents, for shells each within the one before: as they are, or
 * all turned, if w is never negative; else the outermost outward and w 1 and 0 in turn. */
std::string ExpectedOfNested(const std::string& given)
{
  const std::size_t depth = given.size();
  for (const bool turn : { false, true })
  {
    int w = 0;
    int least = 0;
    for (const char sign : given)
    {
      w += (sign == '+') != turn ? 1 : -1;
      least = std::min(least, w);
    }
    if (least == 0)
    {
      return std::string(depth, turn ? '-' : '+');
    }
  }
  std::string turns;
  for (std::size_t i = 0; i < depth; ++i)
  {
    const bool outward = given[i] == '+';
    turns += outward == (i % 2 == 0) ? '+' : '-';
  }
  return turns;
}

TEST(OrientFacets, TurnsNestedShellsByTheDocumentedRule)
{
  for (std::size_t depth = 1; depth <= 4; ++depth)
  {
    for (unsigned signs = 0; signs < 1u << depth; ++signs)
    {
      TriangleSoup soup;
      std::string given;
      for (std::size_t i = 0; i < depth; ++i)
      {
        given += signs >> i & 1 ? '-' : '+';
        const double inset = static_cast<double>(i);
        soup = Join(soup, Cube(inset, 10 - inset, given.back() == '+'));
      }
      EXPECT_EQ(TurnsOfBoxes(Orient(soup).Turns), ExpectedOfNested(given)) << given;
    }
  }
}

TEST(OrientFacets, LetsAnOpenSheetTurnNothingElse)
{
  const TriangleSoup cubes = Join(Cube(0, 1), Cube(2, 3));
  for (const TriangleSoup& ground : { Ground(20), Reversed(Ground(20)) })
  {
    const Oriented oriented = Orient(Join(cubes, ground));
    EXPECT_EQ(oriented.Turns.TurnedFacets, 0);
    EXPECT_EQ(oriented.Turns.Kinds.Sheets, 1);
    EXPECT_EQ(oriented.Turns.Membranes, 0);
    EXPECT_EQ(Orient(Join(Reversed(cubes), ground)).Turns.TurnedFacets, 24);
  }
}

TEST(OrientFacets, TurnsAnOpenBoxThatIsInsideOut)
{
  TriangleSoup box = Cube(0, 1);
  box.Triangles.resize(10);
  EXPECT_EQ(Orient(box).Turns.TurnedFacets, 0);
  const FacetTurns turns = Orient(Reversed(box)).Turns;
  EXPECT_EQ(turns.TurnedFacets, 10);
  EXPECT_EQ(turns.Kinds.Sheets, 0);
  ASSERT_EQ(turns.Warnings.size(), 1u);
  EXPECT_EQ(turns.Warnings[0], "the surface is inside out as a whole: it is turned over");
}

TEST(OrientFacets, MakesFacetsAgreeWithTheirShell)
{
  TriangleSoup cube = Cube(0, 1);
  std::swap(cube.Triangles[3][0], cube.Triangles[3][1]);
  std::swap(cube.Triangles[8][0], cube.Triangles[8][1]);
  const Oriented oriented = Orient(cube);
  EXPECT_EQ(oriented.Turns.DisagreeingFacets, 2);
  EXPECT_EQ(oriented.Turns.TurnedFacets, 2);
  for (Id f = 0; f < 12; ++f)
  {
    EXPECT_EQ(oriented.Surface.Multiplicity[f], f == 3 || f == 8 ? -1 : 1);
    EXPECT_EQ(oriented.Surface.Sources[f].Reversed, f == 3 || f == 8);
  }
  EXPECT_EQ(TrianglesOfFacets(oriented.Surface, oriented.Turns.Turned), (std::vector<Id>{ 3, 8 }));
  ASSERT_EQ(oriented.Turns.Warnings.size(), 1u);
  EXPECT_EQ(oriented.Turns.Warnings[0].find("2 facets face the other way"), 0u);
}

TEST(OrientFacets, GivesTheSameSolidHoweverFacetsAreTurned)
{
  std::mt19937 random(1);
  const TriangleSoup given = Join(Join(Cube(0, 4), Cube(3, 6)), Cube(10, 11));
  for (int round = 0; round < 50; ++round)
  {
    TriangleSoup soup = given;
    std::vector<char> turned(36);
    for (Id t = 0; t < 36; ++t)
    {
      turned[t] = random() % 10 < 3;
      if (turned[t])
      {
        std::swap(soup.Triangles[t][0], soup.Triangles[t][1]);
      }
    }
    EXPECT_EQ(Orient(soup).Turns.Turned, turned);
  }
}

TEST(OrientFacets, DoesAsItIsTold)
{
  const TriangleSoup soup = Join(Join(Cube(0, 9), Cube(3, 6, false)), Cube(10, 11, false));
  EXPECT_EQ(TurnsOfBoxes(Orient(soup, Orientation::AsGiven).Turns), "+++");
  EXPECT_EQ(TurnsOfBoxes(Orient(soup, Orientation::Reverse).Turns), "---");
  EXPECT_EQ(TurnsOfBoxes(Orient(soup, Orientation::Outward).Turns), "+--");
  EXPECT_EQ(TurnsOfBoxes(Orient(soup).Turns), "++-");
}

TEST(OrientFacets, SeesThinAndTinyShells)
{
  // A millionth as thick as long, and a millionth as large, within and without the large one.
  const TriangleSoup plate = Box({ 20, 0, 0 }, { 30, 10, 1e-5 });
  const TriangleSoup within = Box({ 1, 1, 1 }, { 1.00001, 1.00001, 1.00001 });
  const TriangleSoup without = Box({ 12, 1, 1 }, { 12.00001, 1.00001, 1.00001 });
  const TriangleSoup soup =
    Join(Join(Join(Cube(0, 10), Reversed(plate)), Reversed(within)), Reversed(without));
  EXPECT_EQ(TurnsOfBoxes(Orient(soup).Turns), "+-+-");
}

TEST(OrientFacets, DoesNotDependOnSizeOrPlace)
{
  const TriangleSoup soup = Join(Join(Cube(0, 2, false), Cube(1, 3)), Cube(0.25, 0.5));
  const std::string expected = TurnsOfBoxes(Orient(soup).Turns);
  EXPECT_EQ(expected, "-+-");
  for (const double scale : { 0x1p-1000, 0x1p+1000 })
  {
    TriangleSoup scaled = soup;
    for (Point& p : scaled.Points)
    {
      p = { p[0] * scale, p[1] * scale, p[2] * scale };
    }
    EXPECT_EQ(TurnsOfBoxes(Orient(scaled).Turns), expected);
  }
}

TEST(OrientFacets, LeavesTheCornersAndHowOftenFacetsCount)
{
  const TriangleSoup soup = RandomSoup(3, 200);
  const FacetComplex given = Chain(soup);
  const Oriented oriented = Orient(soup);
  ASSERT_EQ(oriented.Surface.Facets, given.Facets);
  EXPECT_EQ(oriented.Surface.Points, given.Points);
  for (Id f = 0; f < given.NumberOfFacets(); ++f)
  {
    const int sign = oriented.Turns.Turned[f] ? -1 : 1;
    EXPECT_EQ(oriented.Surface.Multiplicity[f], sign * given.Multiplicity[f]);
  }
}

TEST(OrientFacets, LeavesWhatCountsNothing)
{
  TriangleSoup soup = Join(Cube(0, 1, false), Cube(2, 3, false));
  soup.NonParticipating.assign(24, 0);
  std::fill_n(soup.NonParticipating.begin() + 12, 12, 1);
  const Oriented oriented = Orient(soup);
  EXPECT_EQ(TurnsOfBoxes(oriented.Turns), "-+");
  EXPECT_EQ(oriented.Turns.Shells, 1);
}

TEST(OrientFacets, GivesTheSameOnAnyNumberOfThreads)
{
  TriangleSoup soup;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 6);
  for (int i = 0; i < 40; ++i)
  {
    const double low = place(random);
    soup = Join(soup, Cube(low, low + place(random) / 4 + 0.1, random() % 2));
  }
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const std::vector<char> alone = Orient(soup).Turns.Turned;
  omp_set_num_threads(8);
  const std::vector<char> together = Orient(soup).Turns.Turned;
  omp_set_num_threads(threads);
  EXPECT_EQ(alone, together);
}

TEST(OrientFacets, StopsWhenAsked)
{
  struct Stopper : Monitor
  {
    bool Continue(const char*, double) override { return ++this->Reports <= this->Allowed; }
    int Reports = 0;
    int Allowed = 0;
  };
  const FacetComplex surface = Chain(Join(Cube(0, 2, false), Cube(1, 3)));
  Stopper all;
  all.Allowed = 1000000;
  FacetComplex copy = surface;
  OrientFacets(copy, SortedFacetEdges(copy.Facets), Orientation::Automatic, all);
  ASSERT_GT(all.Reports, 3);
  for (int allowed = 0; allowed < all.Reports; ++allowed)
  {
    Stopper stopper;
    stopper.Allowed = allowed;
    copy = surface;
    EXPECT_THROW(
      OrientFacets(copy, SortedFacetEdges(copy.Facets), Orientation::Automatic, stopper), Error);
  }
}
/** A box of which the lower side is pulled up to a point of some height above its middle. */
TriangleSoup PulledUp(double height)
{
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 },
    { 1, 1, 1 }, { 0, 1, 1 }, { 0.5, 0.25, height } };
  for (Id k = 0; k < 4; ++k)
  {
    const Id next = (k + 1) % 4;
    soup.Triangles.push_back({ k, next, next + 4 });
    soup.Triangles.push_back({ k, next + 4, k + 4 });
    soup.Triangles.push_back({ next, k, 8 });
  }
  soup.Triangles.push_back({ 4, 5, 6 });
  soup.Triangles.push_back({ 4, 6, 7 });
  return soup;
}

/** One without its upper side, of which the lower one comes out: a cap on top would cut it. */
TriangleSoup OpenSpike()
{
  TriangleSoup soup = PulledUp(2);
  soup.Triangles.resize(soup.Triangles.size() - 2);
  return soup;
}

/** Two solids of two cones each, one in the other, both outward, which have their rim in common. */
TriangleSoup SolidInSolidWithOneRim()
{
  TriangleSoup soup;
  soup.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  for (const double height : { 2, -2, 1, -1 })
  {
    const Id tip = static_cast<Id>(soup.Points.size());
    soup.Points.push_back({ 0.25, 0.25, height });
    for (Id k = 0; k < 3; ++k)
    {
      const Id next = (k + 1) % 3;
      soup.Triangles.push_back(height > 0 ? Triangle{ k, next, tip } : Triangle{ next, k, tip });
    }
  }
  return soup;
}

TEST(OrientFacets, IsTheSameWhereAbsentCrossingsAreKnown)
{
  const TriangleSoup cube = Cube(0, 1);
  TriangleSoup open = cube;
  open.Triangles.pop_back();
  TriangleSoup torn = cube; // one facet faces inward
  std::swap(torn.Triangles[3][0], torn.Triangles[3][1]);
  TriangleSoup thick = cube;
  thick.Multiplicity.assign(12, 2);
  TriangleSoup flat = cube;
  for (Point& p : flat.Points)
  {
    p[2] *= 0x1p-40;
  }
  for (const TriangleSoup& given : { cube, PulledUp(0.5), OpenSpike(), SolidInSolidWithOneRim(),
         open, torn, thick, flat, Join(cube, Cube(2, 3)), Join(cube, Cube(0.2, 0.4)),
         Join(cube, Cube(0.2, 0.4, false)), Merged(Join(cube, Cube(1, 2))), Ground(1) })
  {
    for (const TriangleSoup& soup : { given, Reversed(given) })
    {
      const FacetComplex surface = Chain(soup);
      const FacetEdges edges = SortedFacetEdges(surface.Facets);
      for (const Orientation orientation : { Orientation::Automatic, Orientation::AsGiven,
             Orientation::Reverse, Orientation::Outward })
      {
        Monitor monitor;
        const FacetTurns expected = FindFacetTurns(surface, edges, orientation, monitor);
        const FacetTurns turns =
          FindFacetTurns(surface, edges, orientation, monitor, Crossings::Absent);
        EXPECT_EQ(turns.Turned, expected.Turned);
        EXPECT_EQ(turns.IsSheet, expected.IsSheet);
        EXPECT_EQ(turns.ShellVolumes, expected.ShellVolumes);
        EXPECT_EQ(turns.TurnedShells, expected.TurnedShells);
        EXPECT_EQ(turns.UndecidedShells, expected.UndecidedShells);
        EXPECT_EQ(turns.TurnedShare, expected.TurnedShare);
        EXPECT_EQ(turns.SheetShare, expected.SheetShare);
        EXPECT_EQ(turns.Warnings, expected.Warnings);
      }
    }
  }
}

/** Counts how often it hears of regions being sampled. */
class CountReports : public Monitor
{
public:
  int Reports = 0;
  bool Continue(const char*, double) override
  {
    ++this->Reports;
    return true;
  }
};

TEST(OrientFacets, SamplesNothingOfAPlainShell)
{
  const FacetComplex surface = Chain(Cube(0, 1));
  const FacetEdges edges = SortedFacetEdges(surface.Facets);
  CountReports sampling;
  FindFacetTurns(surface, edges, Orientation::Automatic, sampling);
  CountReports plain;
  FindFacetTurns(surface, edges, Orientation::Automatic, plain, Crossings::Absent);
  EXPECT_EQ(plain.Reports, 2); // at the beginning and at the end
  EXPECT_GT(sampling.Reports, plain.Reports);
}
} // namespace
