// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/SeparateOverlaps.h"

#include "Common/Error.h"
#include "Common/Stages.h"
#include "HullMesh.h"
#include "Output/InsideBoundary.h"
#include "Output/MassProperties.h"
#include "Output/Regions.h"
#include "Support/StopAtEveryReport.h"
#include "Support/TestMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace
{
using namespace insideout;
using testmeshes::Box;
using testmeshes::Join;

const ProgressRange Whole = { Stages::Extracting, 0, 1 };

/** A bar of square section, 2 wide, along a path in space whose corners are seen from above. */
TriangleSoup Bar(const std::vector<Point>& path)
{
  TriangleSoup bar;
  const std::size_t stations = path.size();
  const auto normal = [&](std::size_t from)
  {
    const double x = path[from + 1][0] - path[from][0];
    const double y = path[from + 1][1] - path[from][1];
    const double length = std::hypot(x, y);
    return std::array<double, 2>{ -y / length, x / length };
  };
  for (std::size_t s = 0; s < stations; ++s)
  {
    std::array<double, 2> across = normal(s == 0 ? 0 : s - 1);
    if (s > 0 && s + 1 < stations)
    {
      const std::array<double, 2> next = normal(s);
      const double scale = 1 + across[0] * next[0] + across[1] * next[1];
      across = { (across[0] + next[0]) / scale, (across[1] + next[1]) / scale };
    }
    for (int k = 0; k < 4; ++k)
    {
      const double side = k == 1 || k == 2 ? 1 : -1;
      bar.Points.push_back({ path[s][0] + side * across[0], path[s][1] + side * across[1],
        path[s][2] + (k < 2 ? -1 : 1) });
    }
  }
  const auto quad = [&](Id a, Id b, Id c, Id d)
  {
    bar.Triangles.push_back({ a, b, c });
    bar.Triangles.push_back({ a, c, d });
  };
  quad(0, 1, 2, 3);
  for (Id s = 4; s < static_cast<Id>(bar.Points.size()); s += 4)
  {
    for (Id k = 0; k < 4; ++k)
    {
      const Id next = (k + 1) % 4;
      quad(s - 4 + k, s + k, s + next, s - 4 + next);
    }
  }
  const Id last = static_cast<Id>(bar.Points.size()) - 4;
  quad(last, last + 3, last + 2, last + 1);
  return bar;
}

/** Turns back over itself: its end goes through its beginning. */
TriangleSoup ThroughItself()
{
  return Bar({ { 0, 0, 0 }, { 10, 0, 0 }, { 10, 6, 0 }, { 5, 6, 0.3 }, { 5, -4, 0.3 } });
}

/** Its end ends within its beginning. */
TriangleSoup IntoItself()
{
  return Bar({ { 0, 0, 0 }, { 10, 0, 0 }, { 10, 6, 0 }, { 5, 6, 0.1 }, { 5, 0.25, 0.3 } });
}

struct Separated
{
  HullMesh Hull;
  PartedSolid Solid;
  OverlapCounts Counts;
};

Separated Separate(const TriangleSoup& soup)
{
  Monitor silent;
  Separated made;
  made.Hull = MeshHull(soup, {}, silent);
  std::vector<unsigned char> inside;
  for (const double w : made.Hull.W)
  {
    inside.push_back(w > 0.5);
  }
  made.Solid = UnpartedSolid(made.Hull.Mesh, inside);
  made.Counts = SeparateOverlaps(made.Hull.Surface, made.Hull.W, made.Solid, silent, Whole);
  return made;
}

double VolumeOf(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  return MeasureMass(mesh, inside).Volume;
}

/** The integral of w over the hull. */
double IntegralOfW(const HullMesh& hull)
{
  double sum = 0;
  for (Id cell = 0; cell < hull.Mesh.NumberOfCells(); ++cell)
  {
    std::vector<unsigned char> alone(hull.Mesh.Cells.size(), 0);
    alone[cell] = 1;
    sum += hull.W[cell] > 0 ? hull.W[cell] * VolumeOf(hull.Mesh, alone) : 0;
  }
  return sum;
}

/** Neighbors that cells have say the same as their points; each face has at most two cells. */
void ExpectConforming(const PartedSolid& solid)
{
  std::map<std::set<Id>, std::vector<Id>> cellsOf;
  for (Id cell = 0; cell < solid.Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; solid.Inside[cell] != 0 && k < 4; ++k)
    {
      const Triangle face = FaceOf(solid.Mesh.Cells[cell], k);
      cellsOf[{ face.begin(), face.end() }].push_back(cell);
    }
  }
  for (Id cell = 0; cell < solid.Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; solid.Inside[cell] != 0 && k < 4; ++k)
    {
      const Triangle face = FaceOf(solid.Mesh.Cells[cell], k);
      const Id next = solid.Mesh.Neighbors[cell][k];
      const bool isShared = next != None && solid.Inside[next] != 0;
      const std::vector<Id>& cells = cellsOf[{ face.begin(), face.end() }];
      ASSERT_EQ(cells.size(), isShared ? 2 : 1);
      EXPECT_TRUE(!isShared || cells[0] == next || cells[1] == next);
    }
  }
}

/** In how many parts of the solid, joined in points already, the cells are; those behind x, which
 * join the limbs, left out. */
std::map<Id, std::set<Id>> PartsBefore(double x, const PartedSolid& solid)
{
  std::vector<Id> part(solid.Mesh.Points.size());
  for (std::size_t p = 0; p < part.size(); ++p)
  {
    part[p] = static_cast<Id>(p);
  }
  const auto find = [&](Id p)
  {
    while (part[p] != p)
    {
      p = part[p];
    }
    return p;
  };
  std::map<Id, std::set<Id>> parts;
  const auto isTaken = [&](Id cell)
  {
    double sum = 0;
    for (const Id p : solid.Mesh.Cells[cell])
    {
      sum += solid.Mesh.Points[p][0];
    }
    return solid.Inside[cell] != 0 && sum < 4 * x;
  };
  for (Id cell = 0; cell < solid.Mesh.NumberOfCells(); ++cell)
  {
    for (int k = 1; isTaken(cell) && k < 4; ++k)
    {
      part[find(solid.Mesh.Cells[cell][k])] = find(solid.Mesh.Cells[cell][0]);
    }
  }
  for (Id cell = 0; cell < solid.Mesh.NumberOfCells(); ++cell)
  {
    if (isTaken(cell))
    {
      parts[find(solid.Mesh.Cells[cell][0])].insert(cell);
    }
  }
  return parts;
}
} // namespace

TEST(SeparateOverlaps, GivesEachLimbCellsOfItsOwn)
{
  for (const TriangleSoup& soup : { ThroughItself(), IntoItself() })
  {
    const Separated made = Separate(soup);
    EXPECT_EQ(made.Counts.Overlaps, 1);
    EXPECT_EQ(made.Counts.Separated, 1);
    EXPECT_GT(made.Counts.CopiedCells, 0);
    ExpectConforming(made.Solid);
    const double integral = IntegralOfW(made.Hull);
    EXPECT_NEAR(VolumeOf(made.Solid.Mesh, made.Solid.Inside), integral, 1e-12 * integral);

    // Behind the elbow there are two limbs, each of which has one copy of the overlap.
    const auto parts = PartsBefore(8, made.Solid);
    ASSERT_EQ(parts.size(), 2);
    const Id hullCells = made.Hull.Mesh.NumberOfCells();
    std::set<Id> limbsOfCopies;
    std::set<Id> limbsOfOriginals;
    for (const auto& [limb, cells] : parts)
    {
      for (const Id cell : cells)
      {
        if (cell >= hullCells)
        {
          limbsOfCopies.insert(limb);
          limbsOfOriginals.insert(parts.begin()->second.count(made.Solid.Originals[cell]) != 0
              ? parts.begin()->first
              : parts.rbegin()->first);
        }
      }
    }
    EXPECT_EQ(limbsOfCopies.size(), 1);
    EXPECT_EQ(limbsOfOriginals.size(), 1);
    EXPECT_NE(limbsOfCopies, limbsOfOriginals);
    // And the solid goes from one to the other around the elbow.
    EXPECT_EQ(PartsBefore(100, made.Solid).size(), 1);
  }
}

TEST(SeparateOverlaps, GluedLayersAreOnePart)
{
  const Separated made = Separate(ThroughItself());
  Monitor silent;
  const PartedSolid glued = UnpartedSolid(made.Hull.Mesh,
    { made.Solid.Inside.begin(), made.Solid.Inside.begin() + made.Hull.Mesh.NumberOfCells() });
  EXPECT_EQ(PartsBefore(8, glued).size(), 1);
}

TEST(SeparateOverlaps, SeparatesBodiesThatCross)
{
  const Separated made =
    Separate(Join(Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 1, 1, 1 }, { 3, 3, 4 })));
  EXPECT_EQ(made.Counts.Separated, 1);
  ExpectConforming(made.Solid);
  Monitor silent;
  const SolidRegions regions = FindRegions(made.Solid.Mesh, made.Solid.Inside, silent, Whole);
  ASSERT_EQ(regions.Count, 2);
  const std::vector<MassProperties> masses = MeasureRegions(made.Solid.Mesh, regions);
  EXPECT_NEAR(std::min(masses[0].Volume, masses[1].Volume), 8, 1e-12);
  EXPECT_NEAR(std::max(masses[0].Volume, masses[1].Volume), 12, 1e-12);
}

TEST(SeparateOverlaps, SeparatesABodyWithinAnother)
{
  const Separated made =
    Separate(Join(Box({ 0, 0, 0 }, { 4, 4, 4 }), Box({ 1, 1, 1 }, { 2, 2, 2 })));
  EXPECT_EQ(made.Counts.Separated, 1);
  ExpectConforming(made.Solid);
  EXPECT_NEAR(VolumeOf(made.Solid.Mesh, made.Solid.Inside), 65, 1e-12);
  Monitor silent;
  EXPECT_EQ(FindRegions(made.Solid.Mesh, made.Solid.Inside, silent, Whole).Count, 2);
}

TEST(SeparateOverlaps, LeavesThreeLayersGlued)
{
  const TriangleSoup two = Join(Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 1, 1, 1 }, { 3, 3, 4 }));
  const Separated made = Separate(Join(two, Box({ 1.5, 0.5, 0.5 }, { 5, 1.7, 1.8 })));
  EXPECT_EQ(made.Counts.Overlaps, 1);
  EXPECT_EQ(made.Counts.Separated, 0);
  EXPECT_EQ(made.Solid.Mesh.Cells, made.Hull.Mesh.Cells);
  EXPECT_EQ(made.Solid.Mesh.Neighbors, made.Hull.Mesh.Neighbors);
  EXPECT_GE(made.Counts.Left[0], 0.5);
}

/** Faces in common: a facet of two counts there, and edges that are no simple crossing. */
TEST(SeparateOverlaps, LeavesGluedWhatItDoesNotUnderstand)
{
  const Separated made =
    Separate(Join(Box({ 0, 0, 0 }, { 2, 2, 2 }), Box({ 1, 0, 1 }, { 3, 3, 4 })));
  EXPECT_EQ(made.Counts.Overlaps, 1);
  ExpectConforming(made.Solid);
  const double union_ = 8 + 2 * 3 * 3 - 1 * 2 * 1;
  EXPECT_NEAR(VolumeOf(made.Solid.Mesh, made.Solid.Inside),
    made.Counts.Separated == 1 ? union_ + 2 : union_, 1e-12);
}

TEST(SeparateOverlaps, HoldsItsLawsOnRandomBoxes)
{
  int separated = 0;
  int left = 0;
  std::mt19937 random(1);
  const auto number = [&]() { return static_cast<double>(random() % 10000) / 1000; };
  for (int turn = 0; turn < 8; ++turn)
  {
    TriangleSoup soup;
    for (int box = 0; box < 5; ++box)
    {
      const Point low = { number(), number(), number() };
      soup = Join(soup,
        Box(low,
          { low[0] + 1 + number() / 1.5, low[1] + 1 + number() / 1.5,
            low[2] + 1 + number() / 1.5 }));
    }
    const Separated made = Separate(soup);
    ExpectConforming(made.Solid);
    Monitor silent;
    std::vector<unsigned char> copied(made.Hull.Mesh.Cells.size(), 0);
    for (Id cell = made.Hull.Mesh.NumberOfCells(); cell < made.Solid.Mesh.NumberOfCells(); ++cell)
    {
      copied[made.Solid.Originals[cell]] = 1;
    }
    const std::vector<unsigned char> before(
      made.Solid.Inside.begin(), made.Solid.Inside.begin() + made.Hull.Mesh.NumberOfCells());
    EXPECT_NEAR(VolumeOf(made.Solid.Mesh, made.Solid.Inside),
      VolumeOf(made.Hull.Mesh, before) + VolumeOf(made.Hull.Mesh, copied), 1e-10);
    separated += made.Counts.Separated;
    left += made.Counts.Overlaps - made.Counts.Separated;
  }
  EXPECT_GT(separated, 5);
  EXPECT_GT(left, 0);
}

TEST(SeparateOverlaps, NeedsAWindingNumberPerCell)
{
  Separated made = Separate(Box({ 0, 0, 0 }, { 1, 1, 1 }));
  EXPECT_EQ(made.Counts.Overlaps, 0);
  Monitor silent;
  EXPECT_THROW(SeparateOverlaps(made.Hull.Surface, {}, made.Solid, silent, Whole), Error);
}

TEST(SeparateOverlaps, CanBeStopped)
{
  const Separated made = Separate(ThroughItself());
  const std::vector<unsigned char> inside(
    made.Solid.Inside.begin(), made.Solid.Inside.begin() + made.Hull.Mesh.NumberOfCells());
  const int reports = testmeshes::StopAtEveryReport(
    [&](Monitor& monitor, const ProgressRange& range)
    {
      PartedSolid solid = UnpartedSolid(made.Hull.Mesh, inside);
      SeparateOverlaps(made.Hull.Surface, made.Hull.W, solid, monitor, range);
    });
  EXPECT_GT(reports, 2);
}
