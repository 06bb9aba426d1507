// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/MassProperties.h"

#include "Common/DoubleDouble.h"
#include "Common/ParallelLoop.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace insideout
{
namespace
{
/** Cells are added up in blocks of so many, and then the blocks: for few rounding errors. */
constexpr std::size_t CellsPerBlock = 64;

/** What a cell takes. */
constexpr double NanosecondsPerCell = 30;

/** The integrals of 1, x, y, z, x x, y y, z z, x y, y z and x z. */
using Moments = std::array<double, 10>;
constexpr std::array<std::array<int, 2>, 6> Pairs = { { { { 0, 0 } }, { { 1, 1 } }, { { 2, 2 } },
  { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } } } };

Point MiddleOf(const std::vector<Point>& points)
{
  Point middle = { { 0, 0, 0 } };
  for (int k = 0; k < 3 && !points.empty(); ++k)
  {
    const auto ends = std::minmax_element(
      points.begin(), points.end(), [k](const Point& p, const Point& q) { return p[k] < q[k]; });
    middle[k] = (*ends.first)[k] / 2 + (*ends.second)[k] / 2;
  }
  return middle;
}

void AddCell(const std::array<Point, 4>& corners, Moments& moments)
{
  const double volume = Determinant(Difference(corners[1], corners[0]),
                          Difference(corners[2], corners[0]), Difference(corners[3], corners[0])) /
    6;
  Point sum;
  for (int k = 0; k < 3; ++k)
  {
    sum[k] = (corners[0][k] + corners[1][k]) + (corners[2][k] + corners[3][k]);
    moments[1 + k] += volume * (sum[k] / 4);
  }
  moments[0] += volume;
  for (std::size_t pair = 0; pair < Pairs.size(); ++pair)
  {
    const auto [i, j] = Pairs[pair];
    double products = sum[i] * sum[j];
    for (const Point& corner : corners)
    {
      products += corner[i] * corner[j];
    }
    moments[4 + pair] += volume * (products / 20);
  }
}

Moments MomentsAbout(const Point& origin, const std::vector<Point>& points,
  const std::vector<Tetrahedron>& cells, const std::vector<unsigned char>& inside)
{
  std::vector<Moments> blocks((cells.size() + CellsPerBlock - 1) / CellsPerBlock, Moments{});
  ParallelLoop(blocks.size(), CellsPerBlock * NanosecondsPerCell,
    [&](std::size_t block)
    {
      const std::size_t end = std::min((block + 1) * CellsPerBlock, cells.size());
      for (std::size_t cell = block * CellsPerBlock; cell < end; ++cell)
      {
        if (inside[cell] != 0)
        {
          std::array<Point, 4> corners;
          for (int k = 0; k < 4; ++k)
          {
            corners[k] = Difference(points[cells[cell][k]], origin);
          }
          AddCell(corners, blocks[block]);
        }
      }
    });
  std::array<DoubleDouble, 10> sums;
  for (const Moments& block : blocks)
  {
    for (std::size_t k = 0; k < sums.size(); ++k)
    {
      sums[k] = sums[k] + DoubleDouble(block[k]);
    }
  }
  Moments moments;
  std::transform(sums.begin(), sums.end(), moments.begin(),
    [](const DoubleDouble& sum) { return static_cast<double>(sum); });
  return moments;
}
} // namespace

MassProperties MeasureMass(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  MassProperties mass;
  const int exponent = LargestExponent(mesh.Points);
  const std::vector<Point> points = ScaledPoints(mesh.Points, -exponent);
  const Point middle = MiddleOf(points);
  const Moments rough = MomentsAbout(middle, points, mesh.Cells, inside);
  if (!(rough[0] > 0))
  {
    return mass;
  }
  // Once more about the center: of what is far from the middle, differences of large numbers would
  // be taken.
  Point center;
  for (int k = 0; k < 3; ++k)
  {
    center[k] = middle[k] + rough[1 + k] / rough[0];
  }
  const Moments moments = MomentsAbout(center, points, mesh.Cells, inside);
  mass.Volume = std::ldexp(moments[0], 3 * exponent);
  for (int k = 0; k < 3; ++k)
  {
    mass.CenterOfMass[k] = std::ldexp(center[k] + moments[1 + k] / moments[0], exponent);
  }
  const double xx = moments[4];
  const double yy = moments[5];
  const double zz = moments[6];
  mass.Inertia = { { yy + zz, xx + zz, xx + yy, -moments[7], -moments[8], -moments[9] } };
  for (double& inertia : mass.Inertia)
  {
    inertia = std::ldexp(inertia, 5 * exponent);
  }
  return mass;
}

void AppendMass(const MassProperties& mass, Statistics& statistics)
{
  statistics.emplace_back("Volume", mass.Volume);
  const std::array<const char*, 3> axes = { { "X", "Y", "Z" } };
  for (int k = 0; k < 3; ++k)
  {
    statistics.emplace_back(std::string("CenterOfMass") + axes[k], mass.CenterOfMass[k]);
  }
  for (std::size_t pair = 0; pair < Pairs.size(); ++pair)
  {
    statistics.emplace_back(
      std::string("Inertia") + axes[Pairs[pair][0]] + axes[Pairs[pair][1]], mass.Inertia[pair]);
  }
}
} // namespace insideout
