// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ExactWindingNumber.h"

#include "Common/ChunkedLoop.h"
#include "WindingNumber/CapsInGrid.h"
#include "WindingNumber/LabelsInRows.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
// Slices of a grid for which the polynomials of the caps are evaluated and held at once.
constexpr Id SlicesAtOnce = 64;
} // namespace

ExactWindingNumber::ExactWindingNumber(const std::vector<Point>& points,
  std::vector<CountedTriangle> triangles, const std::vector<CountedEdge>& boundary,
  Monitor& monitor, const ProgressRange& progress, std::size_t sites)
  : Caps(CapHolesInOrder(points, boundary))
  , Tree(points, CloseChain(std::move(triangles), this->Caps.InIds()), monitor, progress)
  , SumOfCaps(this->Caps.Points, this->Caps.Caps, sites, monitor, progress)
{
}

std::vector<double> ExactWindingNumber::Evaluate(
  const std::vector<Point>& at, Monitor& monitor, const ProgressRange& progress) const
{
  std::vector<double> w(at.size());
  const double middle =
    this->SumOfCaps.IsEmpty() ? progress.End : progress.Begin + (progress.End - progress.Begin) / 8;
  this->Tree.Evaluate(at, w, monitor, { progress.Stage, progress.Begin, middle });
  if (!this->SumOfCaps.IsEmpty())
  {
    const std::vector<Tetrahedron> cells = CellsOfPoints(at.size());
    this->SumOfCaps.Add(
      { at, cells }, SpatialOrder(at), w, monitor, { progress.Stage, middle, progress.End });
  }
  return w;
}

std::vector<double> ExactWindingNumber::Evaluate(
  const Sites& sites, Monitor& monitor, const ProgressRange& progress) const
{
  const std::vector<Id> order = SpatialOrder(sites);
  std::vector<double> w(sites.Cells.size());
  const double middle = (progress.Begin + progress.End) / 2;
  this->Tree.Evaluate(sites, order, w, monitor, { progress.Stage, progress.Begin, middle });
  if (!this->SumOfCaps.IsEmpty())
  {
    this->SumOfCaps.Add(sites, order, w, monitor, { progress.Stage, middle, progress.End });
  }
  return w;
}

void ExactWindingNumber::EvaluateInGrid(const GridPlaces& grid, std::optional<double> sideOf,
  const SliceVisitor& visit, Monitor& monitor, const ProgressRange& progress) const
{
  const LabelsInRows labels(this->Tree.AllFacets(), grid);
  const Id slices = grid.Size(2);
  // Values off the chain are whole numbers, so this small a change keeps the side.
  const double negligible = sideOf ? std::abs(*sideOf - std::round(*sideOf)) : 0;
  const double nanosecondsPerPlace = this->Caps.Caps.empty() ? 2 : 20;
  for (Id first = 0; first < slices; first += SlicesAtOnce)
  {
    const Id last = std::min(slices, first + SlicesAtOnce);
    const ProgressRange part = { progress.Stage, progress.At(static_cast<double>(first) / slices),
      progress.At(static_cast<double>(last) / slices) };
    const CapsInGrid caps(
      this->Caps.Points, this->Caps.Caps, negligible, grid, first, last, monitor, part);
    ChunkedLoop(last - first, nanosecondsPerPlace * static_cast<double>(grid.SizeOfSlice()),
      monitor, part,
      [&](Id i)
      {
        std::vector<double> w;
        std::vector<std::size_t> onChain;
        labels.InSlice(first + i, w, onChain);
        for (const std::size_t place : onChain)
        {
          w[place] = this->Tree.At(grid.InSlice(first + i, place));
        }
        caps.AddInSlice(first + i, w);
        for (std::size_t k = 0; sideOf && k < onChain.size(); ++k)
        {
          w[onChain[k]] = this->At(grid.InSlice(first + i, onChain[k]));
        }
        visit(first + i, w);
      });
  }
}

double ExactWindingNumber::At(const Point& point) const
{
  return this->Tree.At(point) + this->SumOfCaps.At(point);
}
} // namespace insideout
