// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/MassProperties.h"

#include "Common/Stages.h"
#include "GraphCut/ConnectCells.h"
#include "Support/TestTetrahedra.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace insideout;
using testtetrahedra::Grid;
using testtetrahedra::RandomInside;

using Whole = boost::multiprecision::int256_t;

/** By integrals that are exact: those of 1, x and x y, times 6, 24 and 120. */
MassProperties ExactMass(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Whole volume = 0;
  std::array<Whole, 3> first = {};
  std::array<std::array<Whole, 3>, 3> second = {};
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    if (inside[c] == 0)
    {
      continue;
    }
    std::array<std::array<Whole, 3>, 4> p;
    for (int i = 0; i < 4; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        p[i][k] = static_cast<Whole>(mesh.Points[mesh.Cells[c][i]][k]);
      }
    }
    const auto edge = [&p](int i, int k) { return p[i][k] - p[0][k]; };
    const Whole det = edge(1, 0) * (edge(2, 1) * edge(3, 2) - edge(2, 2) * edge(3, 1)) -
      edge(1, 1) * (edge(2, 0) * edge(3, 2) - edge(2, 2) * edge(3, 0)) +
      edge(1, 2) * (edge(2, 0) * edge(3, 1) - edge(2, 1) * edge(3, 0));
    volume += det;
    for (int k = 0; k < 3; ++k)
    {
      first[k] += det * (p[0][k] + p[1][k] + p[2][k] + p[3][k]);
      for (int j = 0; j < 3; ++j)
      {
        second[j][k] +=
          det * (p[0][j] + p[1][j] + p[2][j] + p[3][j]) * (p[0][k] + p[1][k] + p[2][k] + p[3][k]);
        for (const auto& corner : p)
        {
          second[j][k] += det * corner[j] * corner[k];
        }
      }
    }
  }
  MassProperties mass;
  mass.Volume = static_cast<double>(static_cast<long double>(volume) / 6);
  std::array<std::array<long double, 3>, 3> central;
  for (int j = 0; j < 3; ++j)
  {
    mass.CenterOfMass[j] = static_cast<double>(
      static_cast<long double>(first[j]) / (4 * static_cast<long double>(volume)));
    for (int k = 0; k < 3; ++k)
    {
      // The integral of x y less that of the middles: both times 480 and the volume, so that only
      // whole numbers are subtracted.
      const Whole difference = 4 * second[j][k] * volume - 5 * first[j] * first[k];
      central[j][k] =
        static_cast<long double>(difference) / (480 * static_cast<long double>(volume));
    }
  }
  const auto at = [&](int j, int k) { return static_cast<double>(central[j][k]); };
  mass.Inertia = { { at(1, 1) + at(2, 2), at(0, 0) + at(2, 2), at(0, 0) + at(1, 1), -at(0, 1),
    -at(1, 2), -at(0, 2) } };
  return mass;
}

void ExpectNear(const MassProperties& found, const MassProperties& expected, double size)
{
  constexpr double few = 16 * 0x1p-52;
  EXPECT_NEAR(found.Volume, expected.Volume, few * expected.Volume);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(found.CenterOfMass[k], expected.CenterOfMass[k], few * size);
  }
  for (std::size_t k = 0; k < expected.Inertia.size(); ++k)
  {
    EXPECT_NEAR(found.Inertia[k], expected.Inertia[k], few * expected.Inertia[0]);
  }
}

std::vector<MassProperties> OfRegions(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  Monitor silent;
  return MeasureRegions(mesh, FindRegions(mesh, inside, silent, { Stages::Extracting, 0, 1 }));
}

/** A box of six tetrahedra around the diagonal from its lowest corner. */
void AddBox(
  const Point& low, const Point& size, std::vector<Point>& points, std::vector<Tetrahedron>& cells)
{
  const Id first = static_cast<Id>(points.size());
  for (int corner = 0; corner < 8; ++corner)
  {
    points.push_back({ { low[0] + (corner & 1 ? size[0] : 0), low[1] + (corner & 2 ? size[1] : 0),
      low[2] + (corner & 4 ? size[2] : 0) } });
  }
  for (const auto& [a, b] : { std::pair(1, 3), { 3, 2 }, { 2, 6 }, { 6, 4 }, { 4, 5 }, { 5, 1 } })
  {
    cells.push_back({ { first, first + a, first + b, first + 7 } });
  }
}
} // namespace

TEST(MassProperties, AreThoseOfExactSums)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 3);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    ExpectNear(MeasureMass(mesh, inside), ExactMass(mesh, inside), 300);
  }
}

TEST(MassProperties, AreAsGoodFarFromTheOriginAndInACorner)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    TetrahedralMesh mesh = Grid(seed, 3);
    for (Point& point : mesh.Points)
    {
      point[1] += 0x1p16;
    }
    std::vector<unsigned char> inside(mesh.Cells.size(), 0);
    inside[seed] = 1; // of a mesh that extends a hundred times as far
    ExpectNear(MeasureMass(mesh, inside), ExactMass(mesh, inside), 0x1p16);
  }
}

TEST(MassProperties, DoNotDependOnTheUnit)
{
  TetrahedralMesh mesh = Grid(1, 2);
  const std::vector<unsigned char> inside = RandomInside(mesh, 1);
  const MassProperties one = MeasureMass(mesh, inside);
  for (const int exponent : { -150, 150, 300 })
  {
    TetrahedralMesh scaled = mesh;
    for (Point& point : scaled.Points)
    {
      for (double& x : point)
      {
        x = std::ldexp(x, exponent);
      }
    }
    const MassProperties found = MeasureMass(scaled, inside);
    EXPECT_EQ(found.Volume, std::ldexp(one.Volume, 3 * exponent));
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(found.CenterOfMass[k], std::ldexp(one.CenterOfMass[k], exponent));
    }
    for (int k = 0; k < 6; ++k)
    {
      EXPECT_EQ(found.Inertia[k], std::ldexp(one.Inertia[k], 5 * exponent));
    }
  }
}

TEST(MassProperties, OfNothingAreZero)
{
  const TetrahedralMesh mesh = Grid(1, 2);
  Statistics figures;
  AppendMass(MeasureMass(mesh, std::vector<unsigned char>(mesh.Cells.size(), 0)), figures);
  AppendMass(MeasureMass({}, {}), figures);
  ASSERT_EQ(figures.size(), 20u);
  for (const auto& [name, value] : figures)
  {
    EXPECT_EQ(value, 0) << name;
  }
}

TEST(MassProperties, OfRegionsAreThoseOfBoxesAndTetrahedra)
{
  std::vector<Point> points;
  std::vector<Tetrahedron> cells;
  AddBox({ { -1, 2, 5 } }, { { 2, 4, 8 } }, points, cells);
  AddBox({ { 100, 0, 0 } }, { { 0.25, 0.5, 3 } }, points, cells);
  const Id first = static_cast<Id>(points.size());
  points.insert(points.end(), { { 10, 10, 10 }, { 14, 10, 10 }, { 10, 14, 10 }, { 10, 10, 18 } });
  cells.push_back({ { first, first + 1, first + 2, first + 3 } });
  const TetrahedralMesh mesh = ConnectCells(points, cells);
  const std::vector<MassProperties> found =
    OfRegions(mesh, std::vector<unsigned char>(mesh.Cells.size(), 1));
  ASSERT_EQ(found.size(), 3u);
  const auto box = [](const Point& center, const Point& size)
  {
    MassProperties mass;
    mass.Volume = size[0] * size[1] * size[2];
    mass.CenterOfMass = center;
    const auto moment = [&](int i, int j)
    { return mass.Volume * (size[i] * size[i] + size[j] * size[j]) / 12; };
    mass.Inertia = { { moment(1, 2), moment(0, 2), moment(0, 1), 0, 0, 0 } };
    return mass;
  };
  ExpectNear(found[0], box({ { 0, 4, 9 } }, { { 2, 4, 8 } }), 10);
  ExpectNear(found[1], box({ { 100.125, 0.25, 1.5 } }, { { 0.25, 0.5, 3 } }), 100);
  // A corner of a box with the sides a, b and c: its center is a quarter of each away; the integral
  // of x^2 about it is a^2 3 / 80 of the volume, that of x y is -a b / 80.
  const double volume = 4. * 4 * 8 / 6;
  const double xx = volume * 3 * 16 / 80;
  const double zz = volume * 3 * 64 / 80;
  ExpectNear(found[2],
    { volume, { { 11, 11, 12 } },
      { { xx + zz, xx + zz, xx + xx, volume * 16 / 80, volume * 32 / 80, volume * 32 / 80 } } },
    20);
}

TEST(MassProperties, OfARegionAreThoseOfItsCellsAloneBitByBit)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    const TetrahedralMesh mesh = Grid(seed, 3);
    const std::vector<unsigned char> inside = RandomInside(mesh, seed);
    Monitor silent;
    const SolidRegions regions = FindRegions(mesh, inside, silent, { Stages::Extracting, 0, 1 });
    const std::vector<MassProperties> found = MeasureRegions(mesh, regions);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(regions.Count));
    for (Id region = 0; region < regions.Count; ++region)
    {
      std::vector<unsigned char> alone;
      for (const Id of : regions.OfCell)
      {
        alone.push_back(of == region);
      }
      const MassProperties expected = MeasureMass(mesh, alone);
      EXPECT_EQ(found[region].Volume, expected.Volume);
      EXPECT_EQ(found[region].CenterOfMass, expected.CenterOfMass);
      EXPECT_EQ(found[region].Inertia, expected.Inertia);
      ExpectNear(found[region], ExactMass(mesh, alone), 300);
    }
  }
}

TEST(MassProperties, OfASmallRegionDoNotSufferFromALargeOneFarAway)
{
  std::vector<Point> points;
  std::vector<Tetrahedron> cells;
  AddBox({ { 0, 0, 0 } }, { { 0x1p-40, 0x1p-41, 0x1p-40 } }, points, cells);
  const TetrahedralMesh alone = ConnectCells(points, cells);
  AddBox({ { 0x1p200, 0, 0 } }, { { 0x1p200, 0x1p201, 0x1p200 } }, points, cells);
  const TetrahedralMesh both = ConnectCells(points, cells);
  const MassProperties found = OfRegions(both, std::vector<unsigned char>(12, 1)).front();
  const MassProperties expected = MeasureMass(alone, std::vector<unsigned char>(6, 1));
  EXPECT_DOUBLE_EQ(expected.Volume, 0x1p-121);
  EXPECT_GT(expected.Inertia[0], 0);
  EXPECT_EQ(found.Volume, expected.Volume);
  EXPECT_EQ(found.CenterOfMass, expected.CenterOfMass);
  EXPECT_EQ(found.Inertia, expected.Inertia);
}
