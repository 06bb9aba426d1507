// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FacetsNearOthers.h"

#include "Common/Box.h"
#include "Common/ParallelLoop.h"
#include "Common/RawVector.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>

namespace insideout
{
namespace
{
/** Limit of the mean number of cells per facet: a grid that exceeds it is made coarser. */
constexpr std::size_t CellsPerFacet = 16;

/** Facets in more cells than this are taken for near: visiting the cells would take longer. */
constexpr std::size_t MostCells = 64;

constexpr Id Several = -2; ///< sets in one cell

constexpr double NanosecondsPerRange = 30; ///< for finding or visiting one range

using GridPlace = std::array<std::uint16_t, 3>;

/** The cells of a grid that a box meets. */
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

  /** In a grid with cells twice as wide. */
  void Coarsen()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->First[axis] /= 2;
      this->Last[axis] /= 2;
    }
  }
};

/**
 * A grid of cubes over a box: the number along its longest side is the cube root of the number of
 * facets.
 */
class FacetGrid
{
public:
  FacetGrid(const Box& bounds, std::size_t facets)
    : Low(bounds.Low)
    , Size(static_cast<std::size_t>(std::min(std::ceil(std::cbrt(facets)), 65535.0)))
    , PerLength(static_cast<double>(this->Size) / bounds.Extent(bounds.LongestAxis()))
  {
  }

  /**
   * The cells that meet a cube with this center and half width. Places are assigned to cells
   * monotonically along each axis, despite rounding.
   */
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
    return static_cast<std::uint16_t>(place > 0 ? std::min(place, last) : 0); // 0 also for NaN
  }

  const Point Low;
  std::size_t Size; ///< cells along each axis
  const double PerLength;
};

/** Add a set to those of a cell; the order does not matter. */
void AddTo(Id& setIn, Id set)
{
  Id known = __atomic_load_n(&setIn, __ATOMIC_RELAXED);
  while (known != set && known != Several &&
    !__atomic_compare_exchange_n(
      &setIn, &known, known == None ? set : Several, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
  {
  }
}

/** Call visit(first, last) for ranges that cover all facets. */
template <class Visit>
void ForStretches(std::size_t facets, const Visit& visit)
{
  constexpr std::size_t FacetsPerTurn = 1024;
  ParallelLoop((facets + FacetsPerTurn - 1) / FacetsPerTurn, FacetsPerTurn * NanosecondsPerRange,
    [&](std::size_t turn)
    { visit(turn * FacetsPerTurn, std::min((turn + 1) * FacetsPerTurn, facets)); });
}

RawVector<CellRange> CellsAround(
  const std::vector<Point>& points, const FacetGrid& grid, double radius)
{
  RawVector<CellRange> around(points.size());
  ParallelLoop(points.size(), NanosecondsPerRange,
    [&](std::size_t p) { around[p] = grid.CellsOf(points[p], radius); });
  return around;
}

CellRange CellsOf(const Triangle& facet, const RawVector<CellRange>& around)
{
  CellRange range = around[facet[0]];
  range.Add(around[facet[1]]);
  range.Add(around[facet[2]]);
  return range;
}

std::vector<Id> MarkedFacets(const std::vector<char>& marks)
{
  std::vector<Id> marked;
  for (std::size_t f = 0; f < marks.size(); ++f)
  {
    if (marks[f])
    {
      marked.push_back(static_cast<Id>(f));
    }
  }
  return marked;
}
} // namespace

std::vector<Id> FacetsNearOthers(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf, double radius)
{
  if (std::adjacent_find(setOf.begin(), setOf.end(), std::not_equal_to<>()) == setOf.end())
  {
    return {}; // a single set
  }
  FacetGrid grid(BoundingBox(points), facets.size());
  const RawVector<CellRange> around = CellsAround(points, grid, radius);
  RawVector<CellRange> ranges(facets.size());
  std::atomic<std::size_t> size{ 0 };
  ForStretches(facets.size(),
    [&](std::size_t first, std::size_t last)
    {
      std::size_t own = 0;
      for (std::size_t f = first; f < last; ++f)
      {
        ranges[f] = CellsOf(facets[f], around);
        own += ranges[f].Size();
      }
      size += own;
    });
  while (size > CellsPerFacet * facets.size()) // ends at a single cell at the latest
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
  ParallelLoop(facets.size(), NanosecondsPerRange,
    [&](std::size_t f)
    {
      if (setOf[f] != None)
      {
        grid.Visit(ranges[f], [&](std::size_t cell) { AddTo(setIn[cell], setOf[f]); });
      }
    });
  std::vector<char> isNear(facets.size(), 0);
  ParallelLoop(facets.size(), NanosecondsPerRange,
    [&](std::size_t f)
    {
      bool meets = false;
      grid.Visit(ranges[f], [&](std::size_t cell) { meets |= setIn[cell] == Several; });
      isNear[f] = meets && setOf[f] != None;
    });
  return MarkedFacets(isNear);
}

std::vector<Id> FacetsNearNew(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Id firstNew)
{
  const std::size_t old = static_cast<std::size_t>(firstNew);
  std::vector<char> isNear(facets.size(), 1);
  if (old == 0)
  {
    return MarkedFacets(isNear);
  }
  if (old == facets.size())
  {
    return {};
  }
  const FacetGrid grid(BoundingBox(points), facets.size());
  const RawVector<CellRange> around = CellsAround(points, grid, 0);
  std::vector<char> isNearNew(grid.NumberOfCells(), 0);
  for (std::size_t f = old; f < facets.size(); ++f)
  {
    grid.Visit(CellsOf(facets[f], around), [&](std::size_t cell) { isNearNew[cell] = 1; });
  }
  ParallelLoop(old, NanosecondsPerRange,
    [&](std::size_t f)
    {
      const CellRange range = CellsOf(facets[f], around);
      bool meets = range.Size() > MostCells;
      if (!meets)
      {
        grid.Visit(range, [&](std::size_t cell) { meets |= isNearNew[cell] != 0; });
      }
      isNear[f] = meets;
    });
  return MarkedFacets(isNear);
}
} // namespace insideout
