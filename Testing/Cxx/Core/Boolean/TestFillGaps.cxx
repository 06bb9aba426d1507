// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/FillGaps.h"

#include "Boolean/FindGaps.h"
#include "Boolean/SegmentBodies.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "Distance/SurfaceDistance.h"
#include "HullMesh.h"
#include "Output/InsideBoundary.h"
#include "Output/MassProperties.h"
#include "Support/BodiesOfSoups.h"
#include "Support/TestMeshes.h"
#include "Support/Turn.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using namespace insideout;
using namespace testmeshes;

/** The surface of revolution of a closed line of (radius, height); on the axis radii are 0. */
TriangleSoup Lathe(const std::vector<std::array<double, 2>>& profile, int around)
{
  TriangleSoup soup;
  const Id size = static_cast<Id>(profile.size());
  for (int i = 0; i < around; ++i)
  {
    const double angle = 2 * std::acos(-1.0) * i / around;
    for (const auto& [radius, height] : profile)
    {
      soup.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), height });
    }
  }
  for (int i = 0; i < around; ++i)
  {
    for (Id k = 0; k < size; ++k)
    {
      const Id next = (k + 1) % size;
      const Id a = i * size + k;
      const Id b = i * size + next;
      const Id c = (i + 1) % around * size + next;
      const Id d = (i + 1) % around * size + k;
      if (profile[next][0] > 0)
      {
        soup.Triangles.push_back({ a, c, b });
      }
      if (profile[k][0] > 0)
      {
        soup.Triangles.push_back({ a, d, c });
      }
    }
  }
  return soup;
}

TriangleSoup Ball(double radius, int rings, int around)
{
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i <= rings; ++i)
  {
    const double angle = std::acos(-1.0) * i / rings;
    const bool isPole = i == 0 || i == rings;
    profile.push_back({ isPole ? 0 : radius * std::sin(angle), -radius * std::cos(angle) });
  }
  return Lathe(profile, around);
}

/** A ball with a cavity. */
TriangleSoup Socket(double inner, double outer)
{
  return Join(Ball(outer, 6, 9), Reversed(Ball(inner, 13, 16)));
}

TriangleSoup Tube(double inner, double outer, double height, int around)
{
  return Lathe({ { outer, 0 }, { outer, height }, { inner, height }, { inner, 0 } }, around);
}

struct Filled
{
  HullMesh Hull;
  std::vector<std::vector<unsigned char>> Before;
  std::vector<std::vector<unsigned char>> After;
  FilledGaps Gaps;

  double VolumeOf(const std::vector<unsigned char>& inside) const
  {
    return inside.empty() ? 0 : MeasureMass(this->Hull.Mesh, inside).Volume;
  }
};

Filled Fill(const std::vector<TriangleSoup>& soups, double tolerance, std::vector<Id> order = {})
{
  Monitor monitor;
  HullMesh hull = MeshHull(BodiesOf(soups), {}, monitor);
  std::vector<BodyToSegment> bodies;
  for (Id body = 0; body < hull.NumberOfBodies(); ++body)
  {
    bodies.push_back({ "body", hull.WOfBody(body), {}, {} });
    order.push_back(static_cast<Id>(order.size()));
  }
  order.resize(bodies.size());
  Filled filled;
  filled.Before = SegmentBodies(hull.Mesh, bodies, {}, monitor).Inside;
  filled.After = filled.Before;
  filled.Gaps = FillGaps(hull.Mesh, tolerance, order, filled.After, monitor);
  filled.Hull = std::move(hull);
  return filled;
}

/** The area of the faces between two bodies. */
double InterfaceOf(const Filled& filled, int first, int second)
{
  Monitor monitor;
  const TetrahedralMesh& mesh = filled.Hull.Mesh;
  double area = 0;
  for (const BoundaryFace& face :
    BoundaryFaces(mesh, filled.After[first], monitor, { Stages::Extracting, 0, 1 }))
  {
    const Id beyond = mesh.Neighbors[face.Cell][face.Face];
    if (beyond != None && filled.After[second][beyond])
    {
      const auto [a, b, c] = CornersOf(mesh.Points, face.Corners);
      area += Length(NormalOf(a, b, c)) / 2;
    }
  }
  return area;
}

double AreaOf(const TriangleSoup& soup)
{
  double area = 0;
  for (const Triangle& t : soup.Triangles)
  {
    const auto [a, b, c] = CornersOf(soup.Points, t);
    area += Length(NormalOf(a, b, c)) / 2;
  }
  return area;
}

/** Every place in what was filled is near two bodies, by the surfaces that were given. */
void ExpectFilledIsNarrow(
  const Filled& filled, const std::vector<TriangleSoup>& soups, double tolerance)
{
  std::vector<std::unique_ptr<SurfaceDistance>> distances;
  for (const TriangleSoup& soup : soups)
  {
    distances.push_back(std::make_unique<SurfaceDistance>(soup.Points, soup.Triangles));
  }
  std::mt19937 random(1);
  std::exponential_distribution<double> weight;
  for (Id cell = 0; cell < filled.Hull.Mesh.NumberOfCells(); ++cell)
  {
    bool isNew = false;
    for (std::size_t b = 0; b < soups.size(); ++b)
    {
      isNew = isNew || filled.Before[b][cell] != filled.After[b][cell];
    }
    for (int i = 0; isNew && i < 20; ++i)
    {
      Point p = { 0, 0, 0 };
      double sum = 0;
      for (const Id corner : filled.Hull.Mesh.Cells[cell])
      {
        const double part = weight(random);
        sum += part;
        for (int axis = 0; axis < 3; ++axis)
        {
          p[axis] += part * filled.Hull.Mesh.Points[corner][axis];
        }
      }
      p = { p[0] / sum, p[1] / sum, p[2] / sum };
      EXPECT_GE(std::count_if(distances.begin(), distances.end(),
                  [&](const auto& d) { return d->At(p).Distance <= tolerance * (1 + 1e-12); }),
        2)
        << "in cell " << cell;
    }
  }
}

TEST(FillGaps, LeavesNoVoidBetweenABallAndItsSocket)
{
  std::mt19937 random(1);
  for (int turn = 0; turn < 2; ++turn)
  {
    // The chords of both leave a gap of 0.03 to 0.08.
    const TriangleSoup ball = Turn(random)(Ball(1, 12, 15));
    const TriangleSoup whole = Ball(2, 6, 9);
    const std::vector<TriangleSoup> soups = { ball, Turn(random)(Socket(1.06, 2)) };
    const Filled filled = Fill(soups, 0.1);
    EXPECT_GT(filled.Gaps.Cells, 100);
    const double solid = filled.VolumeOf(filled.After[0]) + filled.VolumeOf(filled.After[1]);
    const Filled alone = Fill({ whole }, 1);
    const double expected = alone.VolumeOf(alone.Before[0]);
    EXPECT_NEAR(solid, expected, 1e-9 * expected);
    EXPECT_NEAR(InterfaceOf(filled, 0, 1), AreaOf(ball), 1e-9);
    EXPECT_EQ(filled.Before[0], filled.After[0]) << "the first keeps its shape";
    EXPECT_NEAR(filled.Gaps.Volume,
      filled.VolumeOf(filled.After[1]) - filled.VolumeOf(filled.Before[1]), 1e-9);
    ExpectFilledIsNarrow(filled, soups, 0.1);
  }
}

TEST(FillGaps, LeavesWiderGapsAsTheyAre)
{
  std::mt19937 random(2);
  const Filled filled =
    Fill({ Turn(random)(Ball(1, 12, 15)), Turn(random)(Socket(1.06, 2)) }, 0.025);
  EXPECT_EQ(filled.Gaps.Cells, 0);
  EXPECT_EQ(filled.Gaps.Volume, 0);
  EXPECT_EQ(filled.Before, filled.After);
}

TEST(FillGaps, GivesCellsToTheLastInTheOrder)
{
  std::mt19937 random(3);
  const std::vector<TriangleSoup> soups = { Turn(random)(Ball(1, 12, 15)),
    Turn(random)(Socket(1.06, 2)) };
  const Filled first = Fill(soups, 0.1, { 1, 0 });
  const Filled last = Fill(soups, 0.1, { 0, 1 });
  EXPECT_EQ(first.After[1], first.Before[1]);
  EXPECT_EQ(last.After[0], last.Before[0]);
  EXPECT_EQ(first.Gaps.Cells, last.Gaps.Cells);
  EXPECT_NEAR(InterfaceOf(last, 0, 1), AreaOf(soups[0]), 1e-9);
  EXPECT_NEAR(InterfaceOf(first, 0, 1), AreaOf(Ball(1.06, 13, 16)), 1e-9);
}

TEST(FillGaps, FixesATubeInAHole)
{
  std::mt19937 random(4);
  for (int turn = 0; turn < 2; ++turn)
  {
    const Turn turned(random);
    const std::vector<TriangleSoup> soups = { turned(Tube(0.5, 1, 1, 24)),
      turned(Tube(1.03, 2, 1, 31)) };
    const Filled filled = Fill(soups, 0.05);
    const double pi = std::acos(-1.0);
    EXPECT_NEAR(InterfaceOf(filled, 0, 1), 48 * std::sin(pi / 24), 1e-9);
    ExpectFilledIsNarrow(filled, soups, 0.05);
    EXPECT_EQ(Fill(soups, 0.015).Gaps.Cells, 0);
  }
}

/** Only around the place of contact. */
TEST(FillGaps, StaysWhereTheGapIsNarrow)
{
  std::vector<std::array<double, 2>> rings = { { 0, 0 } };
  for (int i = 1; i <= 12; ++i)
  {
    rings.push_back({ i / 12.0, 0 });
  }
  rings.push_back({ 1, -0.5 });
  rings.push_back({ 0, -0.5 });
  const TriangleSoup ground = Lathe(rings, 40);
  TriangleSoup ball = Ball(1, 40, 40);
  for (Point& p : ball.Points)
  {
    p[2] += 1.01;
  }
  const double tolerance = 0.05; // below it is what is nearer to the axis than 0.28
  const Filled filled = Fill({ ground, ball }, tolerance);
  ExpectFilledIsNarrow(filled, { ground, ball }, tolerance);
  const double area = InterfaceOf(filled, 0, 1);
  EXPECT_GT(area, 0.5 * std::acos(-1.0) * 0.28 * 0.28);
  EXPECT_LT(area, std::acos(-1.0) * 0.3 * 0.3);
}

/** A thin liner on a block, with a dent in it that is shallower than the tolerance. */
TEST(FillGaps, LeavesDentsOfOneBody)
{
  TriangleSoup liner = Lathe(
    { { 0, 0 }, { 0, 0.08 }, { 0.5, 0.1 }, { 1, 0.08 }, { 1.5, 0.1 }, { 2, 0.1 }, { 2, 0 } }, 12);
  const Filled filled = Fill({ testmeshes::Box({ -3, -3, -2 }, { 3, 3, 0 }), liner }, 0.3);
  for (Id cell = 0; cell < filled.Hull.Mesh.NumberOfCells(); ++cell)
  {
    // The step where the liner ends is as narrow, and touches both.
    const Point& p = filled.Hull.Mesh.Points[filled.Hull.Mesh.Cells[cell][0]];
    EXPECT_TRUE(filled.Before[1][cell] == filled.After[1][cell] || std::hypot(p[0], p[1]) > 1.9);
  }
}

TEST(FillGaps, GivesWhatLiesBetweenThreeToTheLastOfThem)
{
  std::vector<TriangleSoup> soups; // disks side by side
  for (int disk = 0; disk < 3; ++disk)
  {
    const double angle = 2 * std::acos(-1.0) * disk / 3;
    soups.push_back(Lathe({ { 0, 0 }, { 0, 0.3 }, { 1, 0.3 }, { 1, 0 } }, 30));
    for (Point& p : soups.back().Points)
    {
      p[0] += 1.16 * std::cos(angle);
      p[1] += 1.16 * std::sin(angle);
    }
  }
  const Filled filled = Fill(soups, 0.1);
  ExpectFilledIsNarrow(filled, soups, 0.1);
  EXPECT_EQ(filled.Before[0], filled.After[0]);
  EXPECT_NE(filled.Before[1], filled.After[1]);
  EXPECT_NE(filled.Before[2], filled.After[2]);
}

TEST(FillGaps, TakesBodiesThatAreEmptyAndOneAlone)
{
  std::mt19937 random(5);
  const TriangleSoup ball = Turn(random)(Ball(1, 12, 15));
  EXPECT_EQ(Fill({ ball }, 0.1).Gaps.Cells, 0);
  const Filled filled = Fill({ {}, ball, {}, Socket(1.06, 2), {} }, 0.1);
  EXPECT_GT(filled.Gaps.Cells, 100);
  EXPECT_EQ(filled.Before[1], filled.After[1]);
  EXPECT_NE(filled.Before[3], filled.After[3]);
}

TEST(FillGaps, AreFoundOnSurfacesAlone)
{
  std::mt19937 random(6);
  const std::vector<TriangleSoup> soups = { Turn(random)(Ball(1, 12, 15)),
    Turn(random)(Socket(1.06, 2)) };
  Monitor monitor;
  const ResolvedBodies near = ResolveBodies(BodiesOf(soups), {}, monitor);
  EXPECT_TRUE(MayHaveGaps(near, 0.1, monitor));
  EXPECT_FALSE(MayHaveGaps(near, 0.02, monitor));
  const ResolvedBodies crossing = ResolveBodies(
    BodiesOf(
      { testmeshes::Box({ 0, 0, 0 }, { 2, 2, 2 }), testmeshes::Box({ 1, 1, 1 }, { 3, 3, 3 }) }),
    {}, monitor);
  EXPECT_FALSE(MayHaveGaps(crossing, 0.1, monitor));
}
} // namespace
