// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/VoxelFractions.h"

#include "Common/Vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace
{
using namespace insideout;
using Sides = std::array<std::vector<double>, 3>;

std::vector<double> Fractions(
  const std::vector<Point>& points, const std::vector<Tetrahedron>& cells, const Sides& sides)
{
  Monitor monitor;
  return VoxelFractions(points, cells, sides, monitor, { "", 0, 1 });
}

/** The unit cube in six tetrahedra around its diagonal. */
struct Cube
{
  std::vector<Point> Points;
  std::vector<Tetrahedron> Cells = { { { 0, 1, 3, 7 } }, { { 0, 3, 2, 7 } }, { { 0, 2, 6, 7 } },
    { { 0, 6, 4, 7 } }, { { 0, 4, 5, 7 } }, { { 0, 5, 1, 7 } } };

  Cube()
  {
    for (int i = 0; i < 8; ++i)
    {
      this->Points.push_back({ double(i & 1), double(i >> 1 & 1), double(i >> 2) });
    }
  }
};

double Overlap(double low, double high)
{
  return std::max(0.0, std::min(high, 1.0) - std::max(low, 0.0)) / (high - low);
}

TEST(VoxelFractions, AreThoseOfACube)
{
  const Cube cube;
  for (const Sides& sides : { Sides{ { { 0, 0.5, 1 }, { 0, 1 }, { 0, 0.25, 1 } } },
         Sides{ { { -0.3, 0.1, 0.35, 2 }, { -1, 0.7, 3, 4 }, { 0.2, 0.9, 1.25 } } },
         Sides{ { { 2, 3 }, { 0, 1 }, { 0, 1 } } } })
  {
    const std::vector<double> fractions = Fractions(cube.Points, cube.Cells, sides);
    std::size_t voxel = 0;
    for (std::size_t k = 0; k + 1 < sides[2].size(); ++k)
    {
      for (std::size_t j = 0; j + 1 < sides[1].size(); ++j)
      {
        for (std::size_t i = 0; i + 1 < sides[0].size(); ++i)
        {
          EXPECT_NEAR(fractions[voxel++],
            Overlap(sides[0][i], sides[0][i + 1]) * Overlap(sides[1][j], sides[1][j + 1]) *
              Overlap(sides[2][k], sides[2][k + 1]),
            1e-15);
        }
      }
    }
    EXPECT_EQ(voxel, fractions.size());
  }
}

double VolumeOf(const std::array<Point, 4>& c)
{
  return std::abs(
           Determinant(Difference(c[1], c[0]), Difference(c[2], c[0]), Difference(c[3], c[0]))) /
    6;
}

TEST(VoxelFractions, SumToTheVolumeAndAreTheMeansOfTheirHalves)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int round = 0; round < 60; ++round)
  {
    // On a coarse lattice now and then, so that corners, edges and faces meet the voxels' sides.
    const double step = round % 3 == 0 ? 0.25 : 0;
    std::vector<Point> points(4);
    for (Point& p : points)
    {
      for (double& x : p)
      {
        x = uniform(random);
        x = step > 0 ? std::round(x / step) * step : x;
      }
    }
    const std::array<Point, 4> corners = { points[0], points[1], points[2], points[3] };
    Sides coarse;
    Sides fine;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i <= 8; ++i)
      {
        fine[axis].push_back(i * 0.125);
      }
      coarse[axis] = { 0, 0.25, 0.5, 0.75, 1 };
    }
    const std::vector<double> ofFine = Fractions(points, { { { 0, 1, 2, 3 } } }, fine);
    const std::vector<double> ofCoarse = Fractions(points, { { { 0, 1, 2, 3 } } }, coarse);
    EXPECT_NEAR(std::accumulate(ofFine.begin(), ofFine.end(), 0.0) / 512, VolumeOf(corners), 1e-15);
    for (std::size_t voxel = 0; voxel < 64; ++voxel)
    {
      double mean = 0;
      for (std::size_t part = 0; part < 8; ++part)
      {
        const std::size_t i = 2 * (voxel % 4) + part % 2;
        const std::size_t j = 2 * (voxel / 4 % 4) + part / 2 % 2;
        const std::size_t k = 2 * (voxel / 16) + part / 4;
        mean += ofFine[(k * 8 + j) * 8 + i] / 8;
      }
      EXPECT_NEAR(ofCoarse[voxel], mean, 1e-14);
    }
  }
}
} // namespace
