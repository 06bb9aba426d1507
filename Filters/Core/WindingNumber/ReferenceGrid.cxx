// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ReferenceGrid.h"

#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/PlaceInBox.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerFacet = 60; // per pass, of two; a few cubes each

// Limits of cubes, and of entries of facets in cubes, per facet: more take longer to build, fewer
// make queries slower. MostEntries fits counts of 32 bits.
constexpr double CubesPerFacet = 2;
constexpr double EntriesPerFacet = 8;
constexpr double MostCubesPerAxis = 1024;
constexpr std::size_t MostEntries = std::numeric_limits<std::uint32_t>::max() / 2;

// References lie in this central fraction of each cube.
constexpr double Spread = 0.1;

// How many times the references are moved. If none works the chain was made to prevent it, and one
// tree of the whole is used instead.
constexpr int MostTries = 8;

// Margins in cube lengths: by how much the grid at least exceeds the chain, and by how much a cube
// is enlarged so that rounding loses no facet at its sides.
constexpr double Rim = 0.25;
constexpr double Margin = 1e-6;

// Coordinates are below 1, so that rounding moves the sides of longer cubes by less than the
// margin.
constexpr double LeastLength = 0x1p-28;

// The forward error of a 2 x 2 determinant of differences is below 4 * 2^-53 times its permanent.
constexpr double RelativeError = 0x1p-50;
constexpr double LeastDecided = 1e-250;

/** Sign of the determinant of the vectors from (x, y) to a and b, in the plane; 0 where doubles do
 * not decide. */
int QuickTurn(double x, double y, const Point& a, const Point& b)
{
  const double first = (a[0] - x) * (b[1] - y);
  const double second = (a[1] - y) * (b[0] - x);
  const double determinant = first - second;
  const double undecided = RelativeError * (std::abs(first) + std::abs(second)) + LeastDecided;
  return std::abs(determinant) <= undecided ? 0 : determinant > 0 ? 1 : -1;
}
} // namespace

ReferenceGrid::ReferenceGrid(const ChainFacets& facets)
  : Facets(facets)
{
  this->ChooseCubes();
  this->First.resize(this->Index(this->Cubes[0] - 1, this->Cubes[1] - 1, this->Cubes[2] - 1) + 2);
}

/** The smallest length that the limits of cubes and entries allow. */
void ReferenceGrid::ChooseCubes()
{
  Box all = this->Facets.BoxOf(0);
  // Facets with extents x, y, z have about (x / length + 1) (y / length + 1) (z / length + 1)
  // entries: a polynomial in 1 / length.
  double linear = 0, quadratic = 0, cubic = 0;
  for (Id f = 0; f < this->Facets.Size(); ++f)
  {
    const Box box = this->Facets.BoxOf(f);
    all.Add(box);
    const Point extent = Difference(box.High, box.Low);
    linear += extent[0] + extent[1] + extent[2];
    quadratic += extent[0] * extent[1] + extent[1] * extent[2] + extent[2] * extent[0];
    cubic += extent[0] * extent[1] * extent[2];
  }
  const double facets = this->Facets.Size();
  const Point extent = Difference(all.High, all.Low);
  const auto fits = [&](double length)
  {
    const double entries =
      facets + linear / length + quadratic / (length * length) + cubic / (length * length * length);
    double cubes = 1;
    double most = 0;
    for (const double x : extent)
    {
      cubes *= x / length + 1;
      most = std::max(most, x / length);
    }
    return entries <= EntriesPerFacet * facets && cubes <= CubesPerFacet * facets &&
      most <= MostCubesPerAxis;
  };
  this->Length = all.Extent(all.LongestAxis());
  while (fits(this->Length * 0.9))
  {
    this->Length *= 0.9;
  }
  this->CubesPerLength = 1 / this->Length;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = all.Low[axis] - Rim * this->Length;
    this->Cubes[axis] = static_cast<int>(extent[axis] * this->CubesPerLength + 2 * Rim) + 1;
  }
}

Box ReferenceGrid::BoxOf(std::size_t cube) const
{
  const std::size_t ny = static_cast<std::size_t>(this->Cubes[1]);
  const std::size_t nz = static_cast<std::size_t>(this->Cubes[2]);
  const std::array<std::size_t, 3> index = { cube / (ny * nz), cube / nz % ny, cube % nz };
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double i = static_cast<double>(index[axis]);
    box.Low[axis] = this->Origin[axis] + (i - Margin) * this->Length;
    box.High[axis] = this->Origin[axis] + (i + 1 + Margin) * this->Length;
  }
  return box;
}

Point ReferenceGrid::ReferenceOf(std::size_t cube) const
{
  const std::size_t ny = static_cast<std::size_t>(this->Cubes[1]);
  const std::size_t nz = static_cast<std::size_t>(this->Cubes[2]);
  return { this->Coordinate(0, static_cast<int>(cube / (ny * nz))),
    this->Coordinate(1, static_cast<int>(cube / nz % ny)),
    this->Coordinate(2, static_cast<int>(cube % nz)) };
}

/** The cubes that the facet's box meets. */
ReferenceGrid::Range ReferenceGrid::RangeOf(Id facet) const
{
  const Box box = this->Facets.BoxOf(facet);
  Range range;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double low = (box.Low[axis] - this->Origin[axis]) * this->CubesPerLength;
    const double high = (box.High[axis] - this->Origin[axis]) * this->CubesPerLength;
    range.First[axis] = static_cast<int>(std::max(low - Margin, 0.0));
    range.Last[axis] = std::min(static_cast<int>(high + Margin), this->Cubes[axis] - 1);
  }
  return range;
}

/**
 * Call visit(cube, side of the reference) for every cube that is wanted and that the facet may
 * meet.
 *
 * @return false where a reference lies in the facet's plane
 */
template <typename Visit>
bool ReferenceGrid::ForCubesOf(
  Id facet, const std::vector<char>& isWanted, const Visit& visit) const
{
  const Range range = this->RangeOf(facet);
  const PlaneOfTriangle& plane = this->Facets[facet].Plane;
  const Point& corner = this->Facets[facet].Corners[0];
  // The distance from a reference to the farthest corner of its cube.
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double farthest = std::max(this->Offset[axis], 1 - this->Offset[axis]) + 2 * Margin;
    reach += std::abs(plane.Normal[axis]) * farthest * this->Length;
  }
  for (int i = range.First[0]; i <= range.Last[0]; ++i)
  {
    const double x = corner[0] - this->Coordinate(0, i);
    for (int j = range.First[1]; j <= range.Last[1]; ++j)
    {
      const double y = corner[1] - this->Coordinate(1, j);
      for (int k = range.First[2]; k <= range.Last[2]; ++k)
      {
        const std::size_t cube = this->Index(i, j, k);
        if (!isWanted.empty() && !isWanted[cube])
        {
          continue;
        }
        const double z = corner[2] - this->Coordinate(2, k);
        const double product = x * plane.Normal[0] + y * plane.Normal[1] + z * plane.Normal[2];
        if (std::abs(product) > reach + plane.UndecidedSide * 8)
        {
          continue;
        }
        const int quickSide = QuickSide(plane, { x, y, z });
        const int side =
          quickSide != 0 ? quickSide : this->Facets.SideOf(facet, this->ReferenceOf(cube));
        if (side == 0)
        {
          return false;
        }
        visit(cube, side);
      }
    }
  }
  return true;
}

/**
 * Where the facet crosses a wanted column of references, add the jump of the winding number at the
 * next reference above.
 *
 * @return false where doubles do not decide
 */
bool ReferenceGrid::AddRises(Id f, const std::vector<char>& isWantedColumn)
{
  const Range range = this->RangeOf(f);
  const ChainFacets::Facet& facet = this->Facets[f];
  const auto& [a, b, c] = facet.Corners;
  for (int i = range.First[0]; i <= range.Last[0]; ++i)
  {
    const double x = this->Coordinate(0, i);
    for (int j = range.First[1]; j <= range.Last[1]; ++j)
    {
      if (!isWantedColumn.empty() && !isWantedColumn[this->ColumnOf(i, j)])
      {
        continue;
      }
      const double y = this->Coordinate(1, j);
      const std::array<int, 3> turns = { QuickTurn(x, y, a, b), QuickTurn(x, y, b, c),
        QuickTurn(x, y, c, a) };
      const int least = std::min(std::min(turns[0], turns[1]), turns[2]);
      const int most = std::max(std::max(turns[0], turns[1]), turns[2]);
      if (least < 0 && most > 0)
      {
        continue;
      }
      if (least * most == 0)
      {
        return false;
      }
      const PlaneOfTriangle& plane = facet.Plane;
      const auto sideOfReference = [&](int k) {
        return least * this->Facets.SideOf(f, { x, y, this->Coordinate(2, k) });
      };
      const double height =
        a[2] + ((a[0] - x) * plane.Normal[0] + (a[1] - y) * plane.Normal[1]) / plane.Normal[2];
      const double place = (height - this->Origin[2]) * this->CubesPerLength - this->Offset[2] + 1;
      int k = !(place > 0) ? 0 : place < this->Cubes[2] ? static_cast<int>(place) : this->Cubes[2];
      int side = 0;
      while (k > 0 && (side = sideOfReference(k - 1)) > 0)
      {
        --k;
      }
      if (k > 0 && side == 0)
      {
        return false;
      }
      while (k < this->Cubes[2] && (side = sideOfReference(k)) < 0)
      {
        ++k;
      }
      if (k < this->Cubes[2])
      {
        if (side == 0)
        {
          return false;
        }
        int& rise = this->Value[this->Index(i, j, k)];
#pragma omp atomic
        rise -= least * facet.Count;
      }
    }
  }
  return true;
}

/** Per column, whether a cube in it is wanted; empty for all. */
std::vector<char> ReferenceGrid::ColumnsOf(const std::vector<char>& isWanted) const
{
  const std::size_t height = static_cast<std::size_t>(this->Cubes[2]);
  std::vector<char> columns(isWanted.size() / height);
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    const auto first = isWanted.begin() + static_cast<std::ptrdiff_t>(column * height);
    columns[column] = std::find(first, first + this->Cubes[2], 1) != first + this->Cubes[2];
  }
  return columns;
}

bool ReferenceGrid::Try(const std::vector<char>& isWanted)
{
  const Id facets = this->Facets.Size();
  const std::size_t cubes = this->NumberOfCubes();
  this->Value.assign(cubes, 0);
  std::vector<std::uint32_t> next(cubes, 0);
  const std::vector<char> isWantedColumn = this->ColumnsOf(isWanted);
  std::atomic<bool> decided{ true };
  ParallelLoop(facets, NanosecondsPerFacet,
    [&](Id f)
    {
      const bool good = this->AddRises(f, isWantedColumn) &&
        this->ForCubesOf(f, isWanted,
          [&](std::size_t cube, int)
          {
            std::uint32_t& count = next[cube];
#pragma omp atomic
            ++count;
          });
      if (!good)
      {
        decided = false;
      }
    });
  if (!decided)
  {
    return false;
  }
  std::size_t sum = 0;
  for (std::size_t cube = 0; cube < cubes; ++cube)
  {
    const std::uint32_t count = next[cube];
    this->First[cube] = next[cube] = static_cast<std::uint32_t>(sum);
    sum += count;
    if (cube % static_cast<std::size_t>(this->Cubes[2]) != 0)
    {
      this->Value[cube] += this->Value[cube - 1];
    }
  }
  if (sum > MostEntries)
  {
    return false;
  }
  this->First[cubes] = static_cast<std::uint32_t>(sum);
  this->Entries.resize(sum, SidedFacet(0, 0));
  ParallelLoop(facets, NanosecondsPerFacet,
    [&](Id f)
    {
      this->ForCubesOf(f, isWanted,
        [&](std::size_t cube, int side)
        {
          std::uint32_t place;
          std::uint32_t& counter = next[cube];
#pragma omp atomic capture
          place = counter++;
          this->Entries[place] = SidedFacet(f, side);
        });
    });
  return true;
}

bool ReferenceGrid::Fill(const std::vector<char>& isWanted)
{
  for (int j = 0; this->Length >= LeastLength && j < MostTries; ++j)
  {
    this->Offset = PlaceInBox({ 0, 0, 0 }, { 1, 1, 1 }, j, Spread);
    if (this->Try(isWanted))
    {
      return true;
    }
  }
  return false;
}
} // namespace insideout
