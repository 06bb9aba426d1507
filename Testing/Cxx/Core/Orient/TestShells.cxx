// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/ShellChains.h"
#include "Orient/SurfacePatches.h"

#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace insideout;
using namespace testmeshes;

FacetComplex Chain(const TriangleSoup& soup)
{
  Monitor monitor;
  return CountFacets(soup, {}, monitor).Surface;
}

Shells ShellsOf(const FacetComplex& surface)
{
  return FindShells(surface, SortedFacetEdges(surface.Facets));
}

SurfacePatches PatchesOf(const FacetComplex& surface)
{
  return FindPatches(surface, SortedFacetEdges(surface.Facets));
}

/** A torus of squares cut in two; a Moebius strip for a half twist. */
TriangleSoup Ring(int around, int across, bool twist)
{
  TriangleSoup soup;
  for (int i = 0; i < around; ++i)
  {
    const double a = 2 * 3.14159265358979 * i / around;
    for (int j = 0; j < across; ++j)
    {
      const double b = twist ? a / 2 : 2 * 3.14159265358979 * j / across;
      const double offset = twist ? 0.5 * (j - (across - 1) / 2.0) : 1;
      const double r = 3 + offset * std::cos(b);
      soup.Points.push_back({ r * std::cos(a), r * std::sin(a), offset * std::sin(b) });
    }
  }
  const auto at = [&](int i, int j)
  {
    const bool wraps = i == around;
    const int k = twist ? (wraps ? across - 1 - j : j) : j % across;
    return static_cast<Id>((i % around) * across + k);
  };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < (twist ? across - 1 : across); ++j)
    {
      soup.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      soup.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return soup;
}

void Turn(TriangleSoup& soup, std::size_t t)
{
  std::swap(soup.Triangles[t][1], soup.Triangles[t][2]);
}

TEST(SurfacePatches, EndWhereFacetsDisagreeOrMoreThanTwoMeet)
{
  TriangleSoup cube = Box({ 0, 0, 0 }, { 1, 1, 1 });
  EXPECT_EQ(PatchesOf(Chain(cube)).Count, 1);
  Turn(cube, 4);
  const SurfacePatches patches = PatchesOf(Chain(cube));
  EXPECT_EQ(patches.Count, 2);
  EXPECT_EQ(std::count(patches.Patch.begin(), patches.Patch.end(), 1), 1);
  EXPECT_EQ(patches.Patch[4], 1);

  // Two cubes that share a square, given once: it is a patch, and so is what is left of each.
  TriangleSoup two = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 }));
  two.Triangles.erase(two.Triangles.begin() + 20, two.Triangles.begin() + 22);
  EXPECT_EQ(PatchesOf(Chain(two)).Count, 3);
}

TEST(Shells, OfACubeIsOneWhicheverFacetsAreTurned)
{
  for (unsigned turned = 0; turned < 1u << 12; ++turned)
  {
    TriangleSoup cube = Box({ 0, 0, 0 }, { 1, 1, 1 });
    for (std::size_t t = 0; t < 12; ++t)
    {
      if (turned >> t & 1)
      {
        Turn(cube, t);
      }
    }
    const Shells shells = ShellsOf(Chain(cube));
    ASSERT_EQ(shells.Count, 1);
    unsigned found = 0;
    for (std::size_t t = 0; t < 12; ++t)
    {
      found |= static_cast<unsigned>(shells.Turned[t]) << t;
    }
    ASSERT_TRUE(found == turned || found == (turned ^ 0xfff));
    ASSERT_LE(std::count(shells.Turned.begin(), shells.Turned.end(), 1), 6);
  }
}

TEST(Shells, OfATorusIsFoundWithHalfOfItsFacetsTurned)
{
  std::mt19937 random(4);
  TriangleSoup torus = Ring(20, 12, false);
  std::vector<char> turned(torus.Triangles.size());
  for (std::size_t t = 0; t < turned.size(); ++t)
  {
    turned[t] = random() % 2;
    if (turned[t])
    {
      Turn(torus, t);
    }
  }
  const Shells shells = ShellsOf(Chain(torus));
  EXPECT_EQ(shells.Count, 1);
  const bool same = shells.Turned[0] == turned[0];
  for (std::size_t t = 0; t < turned.size(); ++t)
  {
    ASSERT_EQ(shells.Turned[t] == turned[t], same);
  }
}

TEST(Shells, OfASurfaceWithOneSideDisagreeAlongOneCutOnly)
{
  const TriangleSoup strip = Ring(24, 4, true);
  const FacetComplex surface = Chain(strip);
  const Shells shells = ShellsOf(surface);
  EXPECT_EQ(shells.Count, 1);
  int disagree = 0;
  ForEachEdge(SortedFacetEdges(surface.Facets),
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      if (last - first == 2)
      {
        const auto direction = [&](const FacetEdge& edge)
        { return shells.Turned[edge.Facet] ? -edge.Direction : edge.Direction; };
        disagree += direction(first[0]) == direction(first[1]);
      }
    });
  EXPECT_EQ(disagree, 3);
}

TEST(Shells, AreSeveralWhereCubesTouchInAnEdge)
{
  const TriangleSoup cubes =
    Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Reversed(Box({ 1, 1, 0 }, { 2, 2, 1 })));
  const Shells shells = ShellsOf(Chain(cubes));
  EXPECT_EQ(shells.Count, 2);
  EXPECT_EQ(std::count(shells.Turned.begin(), shells.Turned.end(), 1), 0);
}

TEST(Shells, AreAsManyAsClosedSurfacesThatShareFacets)
{
  // The outsides of two cubes, and the square that they share, which cancels.
  const TriangleSoup cube = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const TriangleSoup beside = Box({ 1, 0, 0 }, { 2, 1, 1 });
  const FacetComplex surface = Chain(Join(cube, beside));
  EXPECT_EQ(std::count(surface.Multiplicity.begin(), surface.Multiplicity.end(), 0), 2);
  const Shells shells = ShellsOf(surface);
  EXPECT_EQ(shells.Count, 2);
  EXPECT_EQ(shells.MoreCopies.size(), 2u);
  // Where one of them is turned over the square counts 2.
  const FacetComplex turned = Chain(Join(cube, Reversed(beside)));
  EXPECT_EQ(std::count(turned.Multiplicity.begin(), turned.Multiplicity.end(), 2), 2);
  EXPECT_EQ(ShellsOf(turned).Count, 2);
  // Three on one base, and one below it.
  TriangleSoup plates = Box({ 0, 0, -1 }, { 1, 1, 0 });
  for (const double height : { 0.1, 0.2, 0.3 })
  {
    plates = Join(plates, Box({ 0, 0, 0 }, { 1, 1, height }));
  }
  EXPECT_EQ(ShellsOf(Chain(plates)).Count, 4);
}

TEST(Shells, ThatCountVeryOftenAreOne)
{
  TriangleSoup cube = Box({ 0, 0, 0 }, { 1, 1, 1 });
  for (const int count : { 2, 64, 65, 30000 })
  {
    cube.Multiplicity.assign(12, static_cast<std::int16_t>(count));
    const FacetComplex surface = Chain(cube);
    const Shells shells = ShellsOf(surface);
    EXPECT_EQ(shells.Count, count > 64 ? 1 : count);
    int sum = 0;
    for (const ShellChain& chain :
      CloseShells(surface, SortedFacetEdges(surface.Facets), shells, surface.Points))
    {
      EXPECT_EQ(chain.Kind, ShellKind::Closed);
      sum += chain.Triangles.front().Count;
    }
    EXPECT_EQ(sum, count);
  }
}

TEST(Shells, AreLooseWhereTheOthersFitWithoutThem)
{
  // A wall across two cubes, given once, on whose two sides they agree.
  TriangleSoup two = Join(Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 0, 0 }, { 2, 1, 1 }));
  two.Triangles.erase(two.Triangles.begin() + 20, two.Triangles.begin() + 22);
  const Shells shells = ShellsOf(Chain(two));
  ASSERT_EQ(shells.Count, 2);
  EXPECT_EQ(std::count(shells.IsLoose.begin(), shells.IsLoose.end(), 1), 1);
  const Id loose = shells.IsLoose[0] ? 0 : 1;
  EXPECT_EQ(std::count(shells.Shell.begin(), shells.Shell.end(), loose), 2);
}

TEST(ShellChains, TellClosedFromHoledFromSheet)
{
  const auto kindOf = [](const TriangleSoup& soup)
  {
    const FacetComplex surface = Chain(soup);
    const std::vector<ShellChain> chains =
      CloseShells(surface, SortedFacetEdges(surface.Facets), ShellsOf(surface), surface.Points);
    EXPECT_EQ(chains.size(), 1u);
    EXPECT_TRUE(
      CountedBoundary(chains[0].Triangles, static_cast<Id>(surface.Points.size())).empty());
    return chains[0].Kind;
  };
  TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  EXPECT_EQ(kindOf(box), ShellKind::Closed);
  box.Triangles.resize(10); // without a lid
  EXPECT_EQ(kindOf(box), ShellKind::Holed);
  box.Triangles.resize(8); // without a second side
  EXPECT_EQ(kindOf(box), ShellKind::Holed);
  box.Triangles.resize(2); // one side
  EXPECT_EQ(kindOf(box), ShellKind::Sheet);
}

TEST(ShellChains, HaveTheVolumeAndAreaOfTheirShell)
{
  TriangleSoup soup = Join(Box({ 1, 1, 1 }, { 3, 3, 3 }), Reversed(Box({ 5, 5, 5 }, { 6, 6, 6 })));
  soup.Triangles.pop_back();
  const FacetComplex surface = Chain(soup);
  const std::vector<ShellChain> chains =
    CloseShells(surface, SortedFacetEdges(surface.Facets), ShellsOf(surface), surface.Points);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_DOUBLE_EQ(chains[0].Volume, 8);
  EXPECT_DOUBLE_EQ(chains[0].Area, 24);
  EXPECT_EQ(chains[0].Facets.size(), 12u);
  EXPECT_DOUBLE_EQ(chains[1].Volume, -1);
  EXPECT_DOUBLE_EQ(chains[1].Area, 5.5);
  EXPECT_EQ(chains[1].Facets.size(), 11u);
}
} // namespace
