// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ExactWindingNumber.h"

#include "WindingNumber/HoleCaps.h"
#include "WindingNumber/SpatialOrder.h"

#include <numeric>

namespace insideout
{
ExactWindingNumber::ExactWindingNumber(const std::vector<Point>& points,
  std::vector<CountedTriangle> triangles, const std::vector<CountedEdge>& boundary,
  Monitor& monitor, const ProgressRange& progress)
  : Caps(CapHoles(points, boundary))
  , Tree(points, CloseChain(std::move(triangles), this->Caps), monitor, progress)
  , SumOfCaps(points, this->Caps)
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
  std::vector<Id> order(sites.Cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<double> w(sites.Cells.size());
  const double middle = (progress.Begin + progress.End) / 2;
  this->Tree.Evaluate(sites, order, w, monitor, { progress.Stage, progress.Begin, middle });
  if (!this->SumOfCaps.IsEmpty())
  {
    this->SumOfCaps.Add(sites, order, w, monitor, { progress.Stage, middle, progress.End });
  }
  return w;
}

double ExactWindingNumber::At(const Point& point) const
{
  return this->Tree.At(point) + this->SumOfCaps.At(point);
}
} // namespace insideout
