// SPDX-License-Identifier: GPL-3.0-or-later
#include "Output/MassProperties.h"

#include "Common/Buckets.h"
#include "Common/DoubleDouble.h"
#include "Common/ParallelLoop.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "Output/InsideBoundary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace insideout
{
namespace
{
/** Cells per block of the pairwise sums, which reduce rounding errors. */
constexpr std::size_t CellsPerBlock = 64;

/** Nanoseconds per cell. */
constexpr double NanosecondsPerCell = 30;

/** The integrals of 1, x, y, z, x x, y y, z z, x y, y z and x z. */
using Moments = std::array<double, 10>;
constexpr std::array<std::array<int, 2>, 6> Pairs = { { { { 0, 0 } }, { { 1, 1 } }, { { 2, 2 } },
  { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } } } };

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

/** Some cells of a mesh, scaled to prevent over- and underflow of products of their coordinates. */
class Part
{
public:
  Part(const TetrahedralMesh& mesh, const Buckets<Id>::Range& cells);

  MassProperties Measure() const;

private:
  Moments MomentsAbout(const Point& origin) const;
  std::array<Point, 4> CornersFrom(const Point& origin, Id cell) const;

  const TetrahedralMesh& Mesh;
  const Buckets<Id>::Range Cells;
  int Exponent = 0; ///< exponent of a bound of all coordinates
  PowerOfTwo Scale{ 0 };
  Point Middle = { { 0, 0, 0 } };
};

Part::Part(const TetrahedralMesh& mesh, const Buckets<Id>::Range& cells)
  : Mesh(mesh)
  , Cells(cells)
{
  if (cells.Size() == 0)
  {
    return;
  }
  Point low = mesh.Points[mesh.Cells[*cells.First][0]];
  Point high = low;
  double largest = 0;
  for (int k = 0; k < 3; ++k)
  {
    for (const Id cell : cells)
    {
      for (const Id p : mesh.Cells[cell])
      {
        low[k] = std::min(low[k], mesh.Points[p][k]);
        high[k] = std::max(high[k], mesh.Points[p][k]);
      }
    }
    largest = std::max({ largest, std::abs(low[k]), std::abs(high[k]) });
  }
  std::frexp(largest, &this->Exponent);
  this->Scale = PowerOfTwo(-this->Exponent);
  for (int k = 0; k < 3; ++k)
  {
    this->Middle[k] = this->Scale.Times(low[k]) / 2 + this->Scale.Times(high[k]) / 2;
  }
}

std::array<Point, 4> Part::CornersFrom(const Point& origin, Id cell) const
{
  std::array<Point, 4> corners;
  for (int i = 0; i < 4; ++i)
  {
    const Point& point = this->Mesh.Points[this->Mesh.Cells[cell][i]];
    for (int k = 0; k < 3; ++k)
    {
      corners[i][k] = this->Scale.Times(point[k]) - origin[k];
    }
  }
  return corners;
}

Moments Part::MomentsAbout(const Point& origin) const
{
  std::vector<Moments> blocks((this->Cells.Size() + CellsPerBlock - 1) / CellsPerBlock, Moments{});
  ParallelLoop(blocks.size(), CellsPerBlock * NanosecondsPerCell,
    [&](std::size_t block)
    {
      const std::size_t end = std::min((block + 1) * CellsPerBlock, this->Cells.Size());
      for (std::size_t i = block * CellsPerBlock; i < end; ++i)
      {
        AddCell(this->CornersFrom(origin, this->Cells.First[i]), blocks[block]);
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

MassProperties Part::Measure() const
{
  MassProperties mass;
  const Moments rough = this->MomentsAbout(this->Middle);
  if (!(rough[0] > 0))
  {
    return mass;
  }
  // Repeat about the center: for cells far from the first origin, moments would be differences of
  // large numbers.
  Point center;
  for (int k = 0; k < 3; ++k)
  {
    center[k] = this->Middle[k] + rough[1 + k] / rough[0];
  }
  const Moments moments = this->MomentsAbout(center);
  mass.Volume = std::ldexp(moments[0], 3 * this->Exponent);
  for (int k = 0; k < 3; ++k)
  {
    mass.CenterOfMass[k] = std::ldexp(center[k] + moments[1 + k] / moments[0], this->Exponent);
  }
  const double xx = moments[4];
  const double yy = moments[5];
  const double zz = moments[6];
  mass.Inertia = { { yy + zz, xx + zz, xx + yy, -moments[7], -moments[8], -moments[9] } };
  for (double& inertia : mass.Inertia)
  {
    inertia = std::ldexp(inertia, 5 * this->Exponent);
  }
  return mass;
}
} // namespace

MassProperties MeasureMass(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside)
{
  CheckLabels(mesh, inside);
  const Buckets<Id> cells(1,
    [&](const auto& visit)
    {
      for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
      {
        if (inside[cell] != 0)
        {
          visit(0, cell);
        }
      }
    });
  return Part(mesh, cells[0]).Measure();
}

std::vector<MassProperties> MeasureRegions(const TetrahedralMesh& mesh, const SolidRegions& regions)
{
  const Buckets<Id> cells(static_cast<std::size_t>(regions.Count),
    [&](const auto& visit)
    {
      for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
      {
        if (regions.OfCell[cell] != None)
        {
          visit(static_cast<std::size_t>(regions.OfCell[cell]), cell);
        }
      }
    });
  std::vector<MassProperties> masses;
  for (Id region = 0; region < regions.Count; ++region)
  {
    masses.push_back(Part(mesh, cells[static_cast<std::size_t>(region)]).Measure());
  }
  return masses;
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
