// SPDX-License-Identifier: GPL-3.0-or-later
#include "Terrain/SurfaceParts.h"

#include "Common/Team.h"
#include "Resolve/FindIntersections.h"
#include "Support/SurfaceFamilies.h"
#include "Support/TestMeshes.h"
#include "Validate/CountedChain.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace insideout;
using namespace testmeshes;

namespace
{
using Pairs = std::vector<std::array<Id, 2>>;

/** A sphere with this number of triangles, with bumps as high as `bumps`, and each point moved by
 * up to `noise`. */
TriangleSoup Sphere(int triangles, double bumps, double noise)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-noise, noise);
  const double pi = std::acos(-1.0);
  const int rings = static_cast<int>(std::sqrt(triangles / 4.0));
  const int around = 2 * rings;
  TriangleSoup sphere;
  for (int ring = 0; ring <= rings; ++ring)
  {
    for (int k = 0; k < around; ++k)
    {
      const double up = pi * (ring + 0.5) / (rings + 1);
      const double about = 2 * pi * k / around;
      const double radius = 1 + bumps * std::sin(9 * up) * std::sin(7 * about);
      sphere.Points.push_back({ radius * std::sin(up) * std::cos(about) + number(random),
        radius * std::sin(up) * std::sin(about) + number(random),
        radius * std::cos(up) + number(random) });
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int k = 0; k < around; ++k)
    {
      const Id a = ring * around + k;
      const Id b = ring * around + (k + 1) % around;
      sphere.Triangles.push_back({ a, a + around, b + around });
      sphere.Triangles.push_back({ a, b + around, b });
    }
  }
  return sphere;
}

std::optional<SurfaceParts> Cut(const TriangleSoup& soup)
{
  Monitor monitor;
  return CutIntoParts(soup.Points, soup.Triangles, monitor, { "", 0, 1 });
}

/** All pairs, without parts: those with a new facet, where all but the first are new. */
Pairs FindWithoutParts(const TriangleSoup& soup)
{
  Monitor monitor;
  return FindIntersections(soup.Points, soup.Triangles, 1, monitor);
}

Pairs Find(const TriangleSoup& soup)
{
  Monitor monitor;
  return FindIntersections(soup.Points, soup.Triangles, monitor);
}

/** What parts promise: each facet is in one, and no two of a terrain meet.
 * @return how many facets are in terrains */
Id ExpectSoundParts(const TriangleSoup& soup)
{
  std::optional<SurfaceParts> surface = Cut(soup);
  if (!surface)
  {
    return 0;
  }
  std::sort(surface->Parts.begin(), surface->Parts.end(),
    [](const SurfacePart& a, const SurfacePart& b) { return a.Begin < b.Begin; });
  std::vector<Id> sorted = surface->Facets;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted.size(), soup.Triangles.size());
  std::vector<Id> partOf(sorted.size(), None);
  Id next = 0;
  Id inTerrains = 0;
  for (std::size_t p = 0; p < surface->Parts.size(); ++p)
  {
    const SurfacePart& part = surface->Parts[p];
    EXPECT_EQ(part.Begin, next);
    EXPECT_LT(part.Begin, part.End);
    next = part.End;
    for (Id i = part.Begin; i < part.End; ++i)
    {
      EXPECT_EQ(sorted[i], i);
      partOf[surface->Facets[i]] = part.IsTerrain ? static_cast<Id>(p) : None;
      inTerrains += part.IsTerrain;
    }
  }
  EXPECT_EQ(next, static_cast<Id>(sorted.size()));
  for (const auto& [i, j] : FindWithoutParts(soup))
  {
    EXPECT_FALSE(partOf[i] != None && partOf[i] == partOf[j]);
  }
  return inTerrains;
}

/** A long sheet of squares that lies in folds upon itself. */
TriangleSoup FoldedSheet(double thickness)
{
  const int width = 20;
  const int length = 300;
  TriangleSoup sheet;
  for (int j = 0; j <= length; ++j)
  {
    const int fold = j / 30;
    const int along = fold % 2 == 0 ? j % 30 : 30 - j % 30;
    for (int i = 0; i <= width; ++i)
    {
      sheet.Points.push_back({ double(i), double(along), thickness * (j / 30.0) });
    }
  }
  for (int j = 0; j < length; ++j)
  {
    for (int i = 0; i < width; ++i)
    {
      const Id a = j * (width + 1) + i;
      const Id b = a + width + 1;
      sheet.Triangles.push_back({ a, a + 1, b + 1 });
      sheet.Triangles.push_back({ a, b + 1, b });
    }
  }
  return sheet;
}

/** A ramp of several turns that goes up by so much in each. */
TriangleSoup Helicoid(double rise)
{
  const int across = 10;
  const int along = 500;
  TriangleSoup ramp;
  for (int j = 0; j <= along; ++j)
  {
    const double angle = 25.0 * j / along;
    for (int i = 0; i <= across; ++i)
    {
      const double radius = 1 + 0.1 * i;
      ramp.Points.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), rise * angle + 0.02 * std::sin(i) });
    }
  }
  for (int j = 0; j < along; ++j)
  {
    for (int i = 0; i < across; ++i)
    {
      const Id a = j * (across + 1) + i;
      const Id b = a + across + 1;
      ramp.Triangles.push_back({ a, a + 1, b + 1 });
      ramp.Triangles.push_back({ a, b + 1, b });
    }
  }
  return ramp;
}

/** Surfaces large enough to be cut into parts, from smooth to wild. */
std::vector<TriangleSoup> LargeSurfaces()
{
  std::vector<TriangleSoup> surfaces;
  for (const double noise : { 0.0, 0.002, 0.01, 0.05 })
  {
    surfaces.push_back(Sphere(10000, 0.05, noise));
  }
  TriangleSoup moved = Sphere(5000, 0.1, 0);
  for (Point& p : moved.Points)
  {
    p = { 0.3 + p[2], p[0], p[1] };
  }
  surfaces.push_back(Join(Sphere(5000, 0.1, 0), moved));
  surfaces.push_back(Join(Sphere(5000, 0.02, 0), Reversed(Sphere(5000, 0.021, 0))));
  surfaces.push_back(FoldedSheet(0.5));
  surfaces.push_back(FoldedSheet(0));
  surfaces.push_back(Helicoid(0.05));
  surfaces.push_back(Helicoid(0));
  surfaces.push_back(RandomSoup(4, 4500));
  return surfaces;
}

TEST(SurfaceParts, HoldEachFacetOnceAndNoTerrainMeetsItself)
{
  Id inTerrains = 0;
  for (const TriangleSoup& surface : LargeSurfaces())
  {
    inTerrains += ExpectSoundParts(surface);
  }
  EXPECT_GT(inTerrains, 20000);
}

TEST(SurfaceParts, HoldInSmallSurfacesToo)
{
  for (const int triangles : { 400, 1000, 3000 })
  {
    EXPECT_GT(ExpectSoundParts(Sphere(triangles, 0, 0)), triangles / 2);
  }
  for (const SurfaceFamily& family : SurfaceFamilies(3))
  {
    for (const TriangleSoup& member : family.Members)
    {
      Monitor monitor;
      const FacetComplex surface = CountFacets(member, {}, monitor).Surface;
      ExpectSoundParts({ surface.Points, surface.Facets });
    }
  }
}

TEST(SurfaceParts, NearlyAllOfASmoothSurfaceIsInTerrains)
{
  const TriangleSoup sphere = Sphere(40000, 0.05, 0);
  EXPECT_GT(ExpectSoundParts(sphere), 0.98 * static_cast<double>(sphere.Triangles.size()));
  EXPECT_LT(Cut(sphere)->Parts.size(), sphere.Triangles.size() / 100);
}

TEST(SurfaceParts, AreNoneWhereNearlyNothingIsATerrain)
{
  EXPECT_FALSE(Cut(RandomSoup(1, 5000)));
}

TEST(SurfaceParts, AreTheSameForAnyThreadCount)
{
  const WholeTeams teams;
  const int threads = omp_get_max_threads();
  const TriangleSoup sphere = Sphere(40000, 0.05, 0);
  omp_set_num_threads(1);
  const std::optional<SurfaceParts> one = Cut(sphere);
  ASSERT_TRUE(one);
  for (const int n : { 2, 8 })
  {
    omp_set_num_threads(n);
    const std::optional<SurfaceParts> many = Cut(sphere);
    ASSERT_TRUE(many);
    EXPECT_EQ(many->Facets, one->Facets);
    ASSERT_EQ(many->Parts.size(), one->Parts.size());
    for (std::size_t p = 0; p < one->Parts.size(); ++p)
    {
      EXPECT_EQ(many->Parts[p].End, one->Parts[p].End);
      EXPECT_EQ(many->Parts[p].IsTerrain, one->Parts[p].IsTerrain);
    }
  }
  omp_set_num_threads(threads);
}

TEST(SurfaceParts, ChangeNoPairThatIsFound)
{
  std::size_t parted = 0;
  for (const TriangleSoup& surface : LargeSurfaces())
  {
    const Pairs expected = FindWithoutParts(surface);
    EXPECT_EQ(Find(surface), expected);
    parted += !expected.empty() && Cut(surface);
  }
  EXPECT_GE(parted, 3u); // in which something crosses
}

TEST(SurfaceParts, ChangeNoPairAtAnyScale)
{
  TriangleSoup surface = Join(Sphere(5000, 0.1, 0), Helicoid(0.05));
  EXPECT_FALSE(FindWithoutParts(surface).empty());
  EXPECT_TRUE(Cut(surface));
  for (const int exponent : { -300, 300 })
  {
    TriangleSoup scaled = surface;
    for (Point& p : scaled.Points)
    {
      p = { std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent) };
    }
    EXPECT_EQ(Find(scaled), FindWithoutParts(scaled));
  }
}
} // namespace
