// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FacetsNearOthers.h"

#include "Common/Box.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

namespace insideout
{
namespace
{
/** A grid in which facets take more cells than this on average is made coarser. */
constexpr std::size_t CellsPerFacet = 16;

constexpr Id Several = -2; ///< sets in one cell

using GridPlace = std::array<std::uint16_t, 3>;

/** The cells of a grid that a box reaches into. */
struct CellRange
{
  GridPlace First;
  GridPlace Last;

  std::size_t Size() const
  {
    std::size_t size = 1;
    for (int axis = 0; axis < 3; ++axis)
    {
      size *= static_cast<std::size_t>(this->Last[axis] - this->First[axis]) + 1;
    }
    return size;
  }

  void Add(const CellRange& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->First[axis] = std::min(this->First[axis], other.First[axis]);
      this->Last[axis] = std::max(this->Last[axis], other.Last[axis]);
    }
  }

  /** In a grid of cells twice as wide. */
  void Coarsen()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->First[axis] /= 2;
      this->Last[axis] /= 2;
    }
  }
};

/** A grid of cubes over a box: as many along its longest side as there would be along each side of
 * a cube with a facet in each cell. */
class FacetGrid
{
public:
  FacetGrid(const Box& bounds, std::size_t facets)
    : Low(bounds.Low)
    , Size(static_cast<std::size_t>(std::min(std::ceil(std::cbrt(facets)), 65535.0)))
    , PerLength(static_cast<double>(this->Size) / bounds.Extent(bounds.LongestAxis()))
  {
  }

  /** The cells that a cube of twice the radius reaches into. A place that comes before another
   * along an axis is in no later cell, whatever is rounded. */
  CellRange CellsOf(const Point& centre, double radius) const
  {
    CellRange range;
    for (int axis = 0; axis < 3; ++axis)
    {
      range.First[axis] = this->CellOf(centre[axis] - radius, axis);
      range.Last[axis] = this->CellOf(centre[axis] + radius, axis);
    }
    return range;
  }

  void Coarsen() { this->Size = (this->Size + 1) / 2; }

  std::size_t NumberOfCells() const { return this->Size * this->Size * this->Size; }

  template <class Visitor>
  void Visit(const CellRange& range, const Visitor& visit) const
  {
    for (std::size_t k = range.First[2]; k <= range.Last[2]; ++k)
    {
      for (std::size_t j = range.First[1]; j <= range.Last[1]; ++j)
      {
        for (std::size_t i = range.First[0]; i <= range.Last[0]; ++i)
        {
          visit((k * this->Size + j) * this->Size + i);
        }
      }
    }
  }

private:
  std::uint16_t CellOf(double coordinate, int axis) const
  {
    const double place = (coordinate - this->Low[axis]) * this->PerLength;
    const double last = static_cast<double>(this->Size - 1);
    return static_cast<std::uint16_t>(place > 0 ? std::min(place, last) : 0); // 0 if not a number
  }

  const Point Low;
  std::size_t Size; ///< cells along each axis
  const double PerLength;
};
} // namespace

std::vector<Id> FacetsNearOthers(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf, double radius)
{
  if (std::adjacent_find(setOf.begin(), setOf.end(), std::not_equal_to<>()) == setOf.end())
  {
    return {}; // a single set
  }
  FacetGrid grid(BoundingBox(points), facets.size());
  std::vector<CellRange> around; // each point
  around.reserve(points.size());
  for (const Point& p : points)
  {
    around.push_back(grid.CellsOf(p, radius));
  }
  std::vector<CellRange> ranges;
  ranges.reserve(facets.size());
  std::size_t size = 0;
  for (const auto& [a, b, c] : facets)
  {
    CellRange range = around[a];
    range.Add(around[b]);
    range.Add(around[c]);
    ranges.push_back(range);
    size += range.Size();
  }
  while (size > CellsPerFacet * facets.size()) // which ends with a single cell
  {
    grid.Coarsen();
    size = 0;
    for (CellRange& range : ranges)
    {
      range.Coarsen();
      size += range.Size();
    }
  }

  std::vector<Id> setIn(grid.NumberOfCells(), None);
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    grid.Visit(ranges[f],
      [&](std::size_t cell)
      {
        if (setOf[f] != None && setIn[cell] != setOf[f])
        {
          setIn[cell] = setIn[cell] == None ? setOf[f] : Several;
        }
      });
  }
  std::vector<Id> near;
  for (std::size_t f = 0; f < facets.size(); ++f)
  {
    bool isNear = false;
    grid.Visit(ranges[f], [&](std::size_t cell) { isNear |= setIn[cell] == Several; });
    if (isNear && setOf[f] != None)
    {
      near.push_back(static_cast<Id>(f));
    }
  }
  return near;
}
} // namespace insideout
