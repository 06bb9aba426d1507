// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/LabelsInRows.h"

#include "Common/ParallelLoop.h"
#include "Common/PointPredicates.h"
#include "Common/SortUniquely.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerFacet = 60;

// Slices for which facets are listed at once, so that facets that span all slices take little
// memory.
constexpr Id SlicesPerSlab = 16;

// Error of the intersection of a facet with a slice: coordinates are below 1.
constexpr double Margin = 0x1p-48;

/** The extent in y of a facet's intersection with a slice, rounded outward. */
struct Extent
{
  double Low;
  double High;
};

Extent ExtentInSlice(const std::array<Point, 3>& corners, double z)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (int k = 0; k < 3; ++k)
  {
    const Point& a = corners[k];
    const Point& b = corners[(k + 1) % 3];
    const auto [least, most] = std::minmax(a[1], b[1]);
    if (a[2] == z)
    {
      low = std::min(low, a[1]);
      high = std::max(high, a[1]);
    }
    if ((a[2] < z && z < b[2]) || (b[2] < z && z < a[2]))
    {
      const double y = a[1] + (z - a[2]) / (b[2] - a[2]) * (b[1] - a[1]);
      low = std::min(low, std::max(y - Margin, least));
      high = std::max(high, std::min(y + Margin, most));
    }
  }
  return { low, high };
}

std::size_t FirstFrom(const std::vector<double>& axis, double x)
{
  return static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), x) - axis.begin());
}

std::size_t FirstAbove(const std::vector<double>& axis, double x)
{
  return static_cast<std::size_t>(std::upper_bound(axis.begin(), axis.end(), x) - axis.begin());
}

/** The side of the line from a to b, both projected along x, on which the row lies. */
int TurnOf(double y, double z, const Point& a, const Point& b)
{
  return Orient2D({ a[1], a[2] }, { b[1], b[2] }, { y, z });
}

/** The same for a row on the line, after its symbolic perturbation; 0 where a and b coincide. */
int MovedTurnOf(const Point& a, const Point& b)
{
  // The derivatives of the determinant by y and by z.
  const double first = a[2] - b[2];
  const double second = b[1] - a[1];
  const double sign = first != 0 ? first : second;
  return sign > 0 ? 1 : sign < 0 ? -1 : 0;
}
} // namespace

struct LabelsInRows::Row
{
  std::size_t FirstPlace; ///< in the slice
  double Y;
  double Z;
};

LabelsInRows::LabelsInRows(const ChainFacets& facets, const GridPlaces& grid)
  : Facets(facets)
  , Grid(grid)
  , Slices(static_cast<std::size_t>(facets.Size()))
  , InSlab(static_cast<std::size_t>((grid.Size(2) + SlicesPerSlab - 1) / SlicesPerSlab))
{
  ParallelLoop(facets.Size(), NanosecondsPerFacet,
    [&](Id f)
    {
      const Box box = facets.BoxOf(f);
      const bool misses = box.Low[0] > grid.Axes[0].back() || box.Low[1] > grid.Axes[1].back() ||
        box.High[1] < grid.Axes[1].front();
      this->Slices[f] = { static_cast<Id>(FirstFrom(grid.Axes[2], box.Low[2])),
        misses ? 0 : static_cast<Id>(FirstAbove(grid.Axes[2], box.High[2])) };
    });
  for (Id f = 0; f < facets.Size(); ++f)
  {
    const auto [first, last] = this->Slices[f];
    for (Id slab = first / SlicesPerSlab; slab * SlicesPerSlab < last; ++slab)
    {
      this->InSlab[slab].push_back(f);
    }
  }
}

void LabelsInRows::InSlice(
  Id slice, std::vector<double>& w, std::vector<std::size_t>& onChain) const
{
  w.assign(this->Grid.SizeOfSlice(), 0);
  onChain.clear();
  for (const Id f : this->InSlab[slice / SlicesPerSlab])
  {
    if (this->Slices[f].First <= slice && slice < this->Slices[f].Last)
    {
      this->AddRises(f, slice, w, onChain);
    }
  }
  const std::size_t size = this->Grid.Axes[0].size();
  for (std::size_t first = 0; first < w.size(); first += size)
  {
    double sum = 0;
    for (std::size_t i = first; i < first + size; ++i)
    {
      w[i] = sum += w[i];
    }
  }
  SortUniquely(onChain);
}

/** Add the jump of the winding number at the first place behind the facet in each row. */
void LabelsInRows::AddRises(
  Id f, Id slice, std::vector<double>& rises, std::vector<std::size_t>& onChain) const
{
  const std::vector<double>& axis = this->Grid.Axes[1];
  const double z = this->Grid.Axes[2][slice];
  const Extent extent = ExtentInSlice(this->Facets[f].Corners, z);
  for (std::size_t j = FirstFrom(axis, extent.Low); j < axis.size() && axis[j] <= extent.High; ++j)
  {
    this->AddRise(f, { j * this->Grid.Axes[0].size(), axis[j], z }, rises, onChain);
  }
}

int LabelsInRows::SideOf(Id f, const Row& row, std::size_t i) const
{
  return this->Facets.SideOf(f, { this->Grid.Axes[0][i], row.Y, row.Z });
}

void LabelsInRows::AddRise(
  Id f, const Row& row, std::vector<double>& rises, std::vector<std::size_t>& onChain) const
{
  const ChainFacets::Facet& facet = this->Facets[f];
  std::array<int, 3> turns;
  for (int k = 0; k < 3; ++k)
  {
    turns[k] = TurnOf(row.Y, row.Z, facet.Corners[k], facet.Corners[(k + 1) % 3]);
  }
  auto [least, most] = std::minmax({ turns[0], turns[1], turns[2] });
  if (least < 0 && most > 0)
  {
    return;
  }
  const std::vector<double>& axis = this->Grid.Axes[0];
  const Box box = this->Facets.BoxOf(f);
  const std::size_t first = FirstFrom(axis, box.Low[0]);
  const std::size_t last = FirstAbove(axis, box.High[0]);
  if (least * most == 0)
  {
    for (std::size_t i = first; i < last; ++i)
    {
      if (this->SideOf(f, row, i) == 0)
      {
        onChain.push_back(row.FirstPlace + i);
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      turns[k] =
        turns[k] != 0 ? turns[k] : MovedTurnOf(facet.Corners[k], facet.Corners[(k + 1) % 3]);
    }
    std::tie(least, most) = std::minmax({ turns[0], turns[1], turns[2] });
    if (least * most <= 0)
    {
      return;
    }
  }
  // The normal's x has the turns' sign: it tells whether the normal points behind the facet.
  const auto& [a, normal] = std::tie(facet.Corners[0], facet.Plane.Normal);
  const double x = a[0] + ((a[1] - row.Y) * normal[1] + (a[2] - row.Z) * normal[2]) / normal[0];
  std::size_t i = !(x > box.Low[0]) ? first : std::min(last, FirstFrom(axis, x));
  int side = 0;
  while (i > first && (side = least * this->SideOf(f, row, i - 1)) > 0)
  {
    --i;
  }
  if (i > first && side == 0)
  {
    onChain.push_back(row.FirstPlace + i - 1);
  }
  while (i < last && (side = least * this->SideOf(f, row, i)) <= 0)
  {
    if (side == 0)
    {
      onChain.push_back(row.FirstPlace + i);
    }
    ++i;
  }
  if (i < axis.size())
  {
    rises[row.FirstPlace + i] -= least * facet.Count;
  }
}
} // namespace insideout
