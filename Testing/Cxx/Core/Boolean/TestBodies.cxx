// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/BodyRegions.h"
#include "Boolean/CoveredBodies.h"
#include "Boolean/SegmentBodies.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "HullMesh.h"
#include "Output/MassProperties.h"
#include "Output/RegionBoundaries.h"
#include "Support/AllowedThreads.h"
#include "Support/BodiesOfSoups.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

// Several bodies in one mesh: what each of them is does not depend on the others, and what lies
// between them is faces of both.

namespace
{
using namespace insideout;
using testmeshes::BodiesOf;
using testmeshes::Box;

/** An octahedron about a center, its `open` first triangles away. */
TriangleSoup Octahedron(const Point& center, double radius, int open = 0)
{
  TriangleSoup soup;
  for (int i = 0; i < 6; ++i)
  {
    Point p = center;
    p[i / 2] += i % 2 ? -radius : radius;
    soup.Points.push_back(p);
  }
  for (int octant = open; octant < 8; ++octant)
  {
    const Id x = octant & 1;
    const Id y = 2 + (octant >> 1 & 1);
    const Id z = 4 + (octant >> 2 & 1);
    const bool isTurned = ((octant & 1) + (octant >> 1 & 1) + (octant >> 2 & 1)) % 2 != 0;
    soup.Triangles.push_back(isTurned ? Triangle{ { x, z, y } } : Triangle{ { x, y, z } });
  }
  return soup;
}

/** Bodies on one mesh, and where each is. */
struct Meshed
{
  HullMesh Hull;
  std::vector<std::vector<unsigned char>> Inside;
};

Meshed Mesh(const std::vector<TriangleSoup>& soups, const HullMeshParameters& parameters = {})
{
  Monitor silent;
  Meshed meshed;
  meshed.Hull = MeshHull(BodiesOf(soups), parameters, silent);
  std::vector<BodyToSegment> bodies;
  for (Id body = 0; body < meshed.Hull.NumberOfBodies(); ++body)
  {
    bodies.push_back({ "body", meshed.Hull.WOfBody(body), {}, {} });
  }
  meshed.Inside = SegmentBodies(meshed.Hull.Mesh, bodies, {}, silent).Inside;
  return meshed;
}

BodyRegions Regions(const Meshed& meshed, RegionRule rule, const std::vector<Id>& priority = {})
{
  Monitor silent;
  return FindBodyRegions(meshed.Inside, rule, priority, silent, { Stages::Extracting, 0, 1 });
}

RegionBoundaries Boundaries(const Meshed& meshed, const SolidRegions& regions)
{
  Monitor silent;
  return FindRegionBoundaries(meshed.Hull.Mesh, regions, silent, { Stages::Extracting, 0, 1 });
}

std::vector<double> Volumes(const Meshed& meshed, const SolidRegions& regions)
{
  std::vector<double> volumes;
  for (const MassProperties& mass : MeasureRegions(meshed.Hull.Mesh, regions))
  {
    volumes.push_back(mass.Volume);
  }
  return volumes;
}

void ExpectNear(const std::vector<double>& found, const std::vector<double>& expected)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_NEAR(found[i], expected[i], 1e-12 * expected[i]) << i;
  }
}

/** The volume of a single body, by all stages. */
double VolumeAlone(const TriangleSoup& soup)
{
  Monitor silent;
  const HullMesh hull = MeshHull(soup, {}, silent);
  const MeshSegmentation segmentation = SegmentMesh(hull.Mesh, hull.W, {}, {}, {}, silent);
  return MeasureMass(hull.Mesh, segmentation.Inside).Volume;
}

/** Nine boxes and octahedra in a box: on a grid, so that many touch, and some within others. */
std::vector<TriangleSoup> TenInABox(unsigned seed)
{
  std::mt19937 random(seed);
  const auto upTo = [&](int most) { return static_cast<double>(random() % (most + 1)); };
  std::vector<TriangleSoup> soups = { Box({ -1, -1, -1 }, { 9, 9, 9 }) };
  while (soups.size() < 10)
  {
    const Point low = { upTo(6), upTo(6), upTo(6) };
    if (soups.size() % 3 == 0)
    {
      soups.push_back(Octahedron({ low[0] + 1, low[1] + 1, low[2] + 1 }, 1.3 + upTo(3) / 7));
    }
    else
    {
      soups.push_back(Box(low, { low[0] + 1 + upTo(1), low[1] + 1 + upTo(1), low[2] + 1 }));
    }
  }
  return soups;
}

void ExpectEachBodyAsAlone(const std::vector<TriangleSoup>& soups, const Meshed& meshed)
{
  for (std::size_t b = 0; b < soups.size(); ++b)
  {
    const double alone = VolumeAlone(soups[b]);
    EXPECT_NEAR(MeasureMass(meshed.Hull.Mesh, meshed.Inside[b]).Volume, alone, 1e-9 * alone)
      << "body " << b;
  }
}

/** The regions of all combinations that hold a body have its volume, by sums. */
void ExpectRegionsAddUp(const std::vector<TriangleSoup>& soups, const Meshed& meshed)
{
  const BodyRegions regions = Regions(meshed, RegionRule::All);
  const std::vector<double> volumes = Volumes(meshed, regions.Regions);
  EXPECT_TRUE(std::is_sorted(regions.Bodies.begin(), regions.Bodies.end()));
  for (std::size_t b = 0; b < soups.size(); ++b)
  {
    double sum = 0;
    for (std::size_t r = 0; r < volumes.size(); ++r)
    {
      EXPECT_GT(volumes[r], 0);
      const std::vector<Id>& set = regions.Bodies[r];
      sum += std::count(set.begin(), set.end(), static_cast<Id>(b)) * volumes[r];
    }
    EXPECT_NEAR(sum, VolumeAlone(soups[b]), 1e-9 * sum) << "body " << b;
  }
}

/** Each face between two regions is there once, and is a face of exactly two cells. */
void ExpectConforming(const Meshed& meshed, const SolidRegions& regions)
{
  const TetrahedralMesh& mesh = meshed.Hull.Mesh;
  std::map<Triangle, std::vector<Id>> regionsAt;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 4; ++k)
    {
      Triangle face = FaceOf(mesh.Cells[cell], k);
      std::sort(face.begin(), face.end());
      regionsAt[face].push_back(regions.OfCell[cell]);
    }
  }
  std::map<Triangle, std::array<Id, 2>> found;
  const RegionBoundaries boundaries = Boundaries(meshed, regions);
  for (std::size_t i = 0; i < boundaries.Faces.size(); ++i)
  {
    Triangle face = boundaries.Faces[i].Corners;
    std::sort(face.begin(), face.end());
    EXPECT_TRUE(found.insert({ face, boundaries.Regions[i] }).second) << "face " << i << " twice";
    EXPECT_EQ(regions.OfCell[boundaries.Faces[i].Cell], boundaries.Regions[i][0]);
  }
  std::size_t parting = 0;
  for (auto& [face, at] : regionsAt)
  {
    ASSERT_LE(at.size(), 2u);
    at.resize(2, None);
    if (at[0] != at[1])
    {
      ++parting;
      ASSERT_EQ(found.count(face), 1u);
      std::set<Id> there(at.begin(), at.end());
      EXPECT_EQ(there, std::set<Id>(found[face].begin(), found[face].end()));
    }
  }
  EXPECT_EQ(parting, found.size());
}
} // namespace

TEST(Bodies, OneTakesItsSurfaceWithoutACopy)
{
  TriangleSoup soup = { { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } } },
    { { { 0, 1, 2 } } } };
  const Point* const points = soup.Points.data();
  EXPECT_EQ(OneBody(std::move(soup)).front().Soup.Points.data(), points);
}

TEST(Bodies, TenInABoxAreEachWhatTheyAreAlone)
{
  for (const unsigned seed : { 1u, 2u })
  {
    const std::vector<TriangleSoup> soups = TenInABox(seed);
    const Meshed meshed = Mesh(soups);
    EXPECT_TRUE(meshed.Hull.Mesh.LostFacets.empty());
    ExpectEachBodyAsAlone(soups, meshed);
    ExpectRegionsAddUp(soups, meshed);
    ExpectConforming(meshed, Regions(meshed, RegionRule::All).Regions);
    ExpectConforming(
      meshed, Regions(meshed, RegionRule::Priority, { 9, 8, 7, 6, 5, 4, 3, 2, 1, 0 }).Regions);
  }
}

TEST(Bodies, TheFirstInPriorityHasTheCellsOfAnOverlap)
{
  const Meshed meshed = Mesh({ Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 1, 0, 0 }, { 4, 2, 2 }) });
  const auto volumes = [&](const std::vector<Id>& priority)
  { return Volumes(meshed, Regions(meshed, RegionRule::Priority, priority).Regions); };
  ExpectNear(volumes({ 0, 1 }), { 8, 8 });
  ExpectNear(volumes({ 1, 0 }), { 4, 12 });
  const BodyRegions all = Regions(meshed, RegionRule::All);
  EXPECT_EQ(all.Bodies, (std::vector<std::vector<Id>>{ { 0 }, { 0, 1 }, { 1 } }));
  ExpectNear(Volumes(meshed, all.Regions), { 4, 4, 8 });
  EXPECT_EQ(NamesOfRegions(all, { "left", "right" }),
    (std::vector<std::string>{ "left", "left+right", "right" }));
}

TEST(Bodies, PriorityNamesBodies)
{
  const std::vector<std::string> names = { "bone", "fat", "skin" };
  EXPECT_EQ(PriorityOf(names, {}), (std::vector<Id>{ 0, 1, 2 }));
  EXPECT_EQ(PriorityOf(names, { "skin" }), (std::vector<Id>{ 2, 0, 1 }));
  const auto wordsAbout = [&](const std::vector<std::string>& first) -> std::string
  {
    try
    {
      PriorityOf(names, first);
      return "";
    }
    catch (const Error& error)
    {
      return error.what();
    }
  };
  EXPECT_EQ(wordsAbout({ "fat", "hair" }),
    "Priority names hair, which is not a body; there are bone, fat, skin");
  EXPECT_EQ(wordsAbout({ "fat", "bone", "fat" }), "Priority names fat twice");
}

namespace
{
/** Volumes of the regions of bodies by the order that is given, and what is said of it. */
struct Ordered
{
  std::vector<double> Volumes;
  std::vector<std::string> Warnings;
};

Ordered InOrder(const std::vector<TriangleSoup>& soups, const std::vector<std::string>& names,
  const std::vector<std::string>& first = {}, RegionRule rule = RegionRule::Priority)
{
  Monitor silent;
  const Meshed meshed = Mesh(soups);
  const BodyOrder order = InnerFirst(meshed.Inside, PriorityOf(names, first), first.size());
  const BodyRegions regions = Regions(meshed, rule, order.Priority);
  return { Volumes(meshed, regions.Regions),
    WarningsOfCoveredBodies(meshed.Hull.Mesh, meshed.Inside, order, regions, names, silent,
      { Stages::Extracting, 0, 1 }) };
}

using Lines = std::vector<std::string>;
} // namespace

TEST(Bodies, TheInnerOfTwoNestedOnesGoesFirstAndItIsToldWhereTheOrderWasAnother)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 4, 4, 4 });
  const TriangleSoup ball = Box({ 1, 1, 1 }, { 2, 2, 2 });
  const Ordered outerFirst = InOrder({ box, ball }, { "box", "ball" });
  ExpectNear(outerFirst.Volumes, { 63, 1 });
  EXPECT_EQ(outerFirst.Warnings,
    Lines{ "bodies within body box (ball) keep their own cells, although it comes before them; set "
           "Priority to box, or RegionRule to all" });
  const Ordered innerFirst = InOrder({ ball, box }, { "ball", "box" });
  ExpectNear(innerFirst.Volumes, { 1, 63 });
  EXPECT_EQ(innerFirst.Warnings, Lines{});
  const Ordered named = InOrder({ box, ball }, { "box", "ball" }, { "box" });
  ExpectNear(named.Volumes, { 64, 0 });
  EXPECT_EQ(named.Warnings,
    Lines{ "body ball has no cell: all of its places are of bodies before it (box); set Priority "
           "to ball, or RegionRule to all" });
  const Ordered inner = InOrder({ box, ball }, { "box", "ball" }, { "ball" });
  ExpectNear(inner.Volumes, { 63, 1 });
  EXPECT_EQ(inner.Warnings, Lines{});
  EXPECT_EQ(InOrder({ box, ball }, { "box", "ball" }, {}, RegionRule::All).Warnings, Lines{});
}

TEST(Bodies, NestedOnesGoFromTheInnermostOutAndEqualOnesInTheirOrder)
{
  const TriangleSoup large = Box({ 0, 0, 0 }, { 6, 6, 6 });
  const TriangleSoup middle = Box({ 1, 1, 1 }, { 5, 5, 5 });
  const TriangleSoup small = Box({ 2, 2, 2 }, { 4, 4, 4 });
  std::vector<int> of = { 0, 1, 2, 3 };
  const std::vector<TriangleSoup> soups = { large, middle, small, middle };
  const std::vector<double> shells = { 216 - 64, 64 - 8, 8 };
  do
  {
    std::vector<TriangleSoup> bodies;
    std::vector<double> expected;
    bool hasMiddle = false;
    for (const int i : of)
    {
      bodies.push_back(soups[i]);
      const bool isSecond = i % 2 == 1 && hasMiddle;
      hasMiddle = hasMiddle || i % 2 == 1;
      expected.push_back(isSecond ? 0 : shells[i == 3 ? 1 : i]);
    }
    ExpectNear(InOrder(bodies, { "a", "b", "c", "d" }).Volumes, expected);
  } while (std::next_permutation(of.begin(), of.end()));
}

TEST(Bodies, OneThatLosesMoreThanHalfToTheOrderIsTold)
{
  const TriangleSoup left = Box({ 0, 0, 0 }, { 4, 2, 2 });
  const TriangleSoup right = Box({ 1, 0, 0 }, { 5, 2, 2 });
  const Ordered lost = InOrder({ left, right }, { "left", "right" });
  ExpectNear(lost.Volumes, { 16, 4 });
  EXPECT_EQ(lost.Warnings,
    Lines{ "body right loses 75 % of its volume to bodies before it (left); set Priority to "
           "right, or RegionRule to all" });
  EXPECT_EQ(InOrder({ left, right }, { "left", "right" }, { "left" }).Warnings, Lines{});
  EXPECT_EQ(InOrder({ left, right }, { "left", "my right, above" }).Warnings,
    Lines{ "body my right, above loses 75 % of its volume to bodies before it (left); set Priority "
           "to \"my right\\, above\", or RegionRule to all" });
  EXPECT_EQ(InOrder({ left, Box({ 2, 0, 0 }, { 6, 2, 2 }) }, { "left", "half" }).Warnings, Lines{});
}

TEST(Bodies, PartsWithoutACellAreTold)
{
  TriangleSoup two = Box({ 1, 1, 1 }, { 2, 2, 2 });
  const TriangleSoup beside = Box({ 5, 1, 1 }, { 7, 3, 3 });
  for (const Triangle& t : beside.Triangles)
  {
    two.Triangles.push_back({ { t[0] + 8, t[1] + 8, t[2] + 8 } });
  }
  two.Points.insert(two.Points.end(), beside.Points.begin(), beside.Points.end());
  const Ordered found = InOrder({ Box({ 0, 0, 0 }, { 4, 4, 4 }), two }, { "box", "two" });
  ExpectNear(found.Volumes, { 64, 8 });
  EXPECT_EQ(found.Warnings,
    Lines{ "1 of the 2 parts of body two have no cell: all of their places are of bodies before "
           "it (box); set Priority to two, or RegionRule to all" });
  EXPECT_EQ(
    InOrder({ Box({ 0, 0, 0 }, { 4, 4, 4 }), two }, { "box", "two" }, { "box" }).Warnings, Lines{});
}

TEST(Bodies, TheSameBodyTwiceIsOneRegionOfBoth)
{
  const TriangleSoup box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const Meshed meshed = Mesh({ box, box, testmeshes::Reversed(box) });
  const BodyRegions all = Regions(meshed, RegionRule::All);
  EXPECT_EQ(all.Bodies, (std::vector<std::vector<Id>>{ { 0, 1, 2 } }));
  EXPECT_EQ(Boundaries(meshed, all.Regions).Faces.size(), 12u);
  ExpectNear(
    Volumes(meshed, Regions(meshed, RegionRule::Priority, { 1, 0, 2 }).Regions), { 0, 1, 0 });
}

TEST(Bodies, ThatTouchInAPlaneHaveOneInterfaceAndNoSliver)
{
  // Turned, so that nothing of the plane of contact is exact.
  const auto turned = [](TriangleSoup soup)
  {
    for (Point& p : soup.Points)
    {
      const double x = p[0] * std::cos(0.3) - p[1] * std::sin(0.3);
      const double y = p[0] * std::sin(0.3) + p[1] * std::cos(0.3);
      p = { { x, y * std::cos(0.7) - p[2] * std::sin(0.7),
        y * std::sin(0.7) + p[2] * std::cos(0.7) } };
    }
    return soup;
  };
  const Meshed meshed =
    Mesh({ turned(Box({ 0, 0, 0 }, { 4, 4, 1 })), turned(Box({ 0.7, 0.9, 1 }, { 2.3, 2.7, 3 })) });
  const BodyRegions all = Regions(meshed, RegionRule::All);
  EXPECT_EQ(all.Bodies, (std::vector<std::vector<Id>>{ { 0 }, { 1 } }));
  const RegionBoundaries boundaries = Boundaries(meshed, all.Regions);
  double area = 0;
  for (std::size_t i = 0; i < boundaries.Faces.size(); ++i)
  {
    const Triangle& t = boundaries.Faces[i].Corners;
    const std::vector<Point>& points = meshed.Hull.Mesh.Points;
    const Point normal = NormalOf(points[t[0]], points[t[1]], points[t[2]]);
    area += boundaries.Regions[i][1] == 1 ? Length(normal) / 2 : 0;
  }
  EXPECT_NEAR(area, 1.6 * 1.8, 1e-9) << "all of the contact is interface";
}

TEST(Bodies, InsideAnotherByAHairsBreadthAreDecidedExactly)
{
  const double most = std::nextafter(2.0, 0.0);
  const Meshed meshed = Mesh({ Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 0, 0, 0 }, { most, 2, 2 }) });
  const BodyRegions all = Regions(meshed, RegionRule::All);
  EXPECT_EQ(all.Bodies, (std::vector<std::vector<Id>>{ { 0 }, { 0, 1 } }));
  EXPECT_NEAR(Volumes(meshed, all.Regions)[0], 4 * (2 - most), 1e-9 * (2 - most));
}

TEST(Bodies, WithHolesKeepTheirOwnCutBesideClosedOnes)
{
  const std::vector<TriangleSoup> soups = { Box({ -3, -3, -3 }, { 3, 3, 3 }),
    Octahedron({ 0, 0, 0 }, 2, 1), Octahedron({ 0.5, 0.25, 0 }, 1, 1) };
  const Meshed meshed = Mesh(soups);
  const TetrahedralMesh& mesh = meshed.Hull.Mesh;
  EXPECT_NEAR(MeasureMass(mesh, meshed.Inside[0]).Volume, 216, 1e-9);
  EXPECT_NEAR(MeasureMass(mesh, meshed.Inside[1]).Volume, 32.0 / 3, 1.0);
  EXPECT_NEAR(MeasureMass(mesh, meshed.Inside[2]).Volume, 4.0 / 3, 0.2);
  EXPECT_GT(
    *std::max_element(meshed.Hull.WOfBodies[1].begin(), meshed.Hull.WOfBodies[1].end()), 0.8);
  ExpectConforming(meshed, Regions(meshed, RegionRule::All).Regions);
}

TEST(Bodies, SeedsSpeakOfTheirBodyAlone)
{
  Monitor silent;
  const HullMesh hull = MeshHull(
    BodiesOf({ Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0, 0, 0 }, { 2, 2, 2 }) }), {}, silent);
  const std::vector<BodyToSegment> bodies = { { "a", hull.WOfBodies[0], {},
                                                { { { 0.9, 0.2, 0.3 }, false } } },
    { "b", hull.WOfBodies[1], {}, {} } };
  const BodySegmentation found = SegmentBodies(hull.Mesh, bodies, {}, silent);
  EXPECT_LT(MeasureMass(hull.Mesh, found.Inside[0]).Volume, 1);
  EXPECT_NEAR(MeasureMass(hull.Mesh, found.Inside[1]).Volume, 8, 1e-12);
}

TEST(Bodies, OfWhichOneIsWrongAreNamed)
{
  TriangleSoup broken = Box({ 0, 0, 0 }, { 1, 1, 1 });
  broken.Points[3][0] = std::nan("");
  try
  {
    Mesh({ Box({ 0, 0, 0 }, { 2, 2, 2 }), broken });
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(std::string(error.what()), "body B: point 3 is not finite");
  }
}

TEST(Bodies, AreTheSameOnAnyNumberOfThreads)
{
  const std::vector<TriangleSoup> soups = { Box({ 0, 0, 0 }, { 3, 3, 3 }),
    Octahedron({ 1.1, 1.2, 1.3 }, 2, 1), Octahedron({ 2.1, 1.7, 1.4 }, 2.2) };
  const auto meshOn = [&](int threads)
  {
    const testthreads::Allowed allowed(threads);
    return Mesh(soups);
  };
  const Meshed one = meshOn(1);
  const Meshed four = meshOn(4);
  EXPECT_EQ(one.Hull.Mesh.Points, four.Hull.Mesh.Points);
  EXPECT_EQ(one.Hull.Mesh.Cells, four.Hull.Mesh.Cells);
  EXPECT_EQ(one.Hull.WOfBodies, four.Hull.WOfBodies);
  EXPECT_EQ(one.Inside, four.Inside);
}
