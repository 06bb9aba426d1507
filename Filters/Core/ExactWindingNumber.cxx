// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactWindingNumber.h"

#include "HoleCaps.h"

namespace insideout
{
ExactWindingNumber::ExactWindingNumber(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
  : Exponent(LargestExponent(points))
  , Points(ScaledPoints(points, this->Exponent))
  , Boundary(CountedBoundary(triangles, static_cast<Id>(points.size())))
  , Caps(CapHoles(this->Points, this->Boundary))
  , Tree(this->Points, CloseChain(triangles, this->Caps), monitor, progress)
  , SumOfCaps(this->Points, this->Caps)
{
}

void ExactWindingNumber::Evaluate(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  const std::vector<Point> points = ScaledPoints(sites.Points, this->Exponent);
  const Sites scaled = { points, sites.Cells, sites.Weights };
  const double middle =
    this->IsClosed() ? progress.End : progress.Begin + (progress.End - progress.Begin) / 8;
  this->Tree.Evaluate(scaled, order, w, monitor, { progress.Stage, progress.Begin, middle });
  this->SumOfCaps.Add(scaled, order, w, monitor, { progress.Stage, middle, progress.End });
}

double ExactWindingNumber::At(const Point& point) const
{
  const std::vector<Point> points = ScaledPoints({ point }, this->Exponent);
  return this->Tree.At(SiteAt(points.front())) + this->SumOfCaps.At(points.front());
}
} // namespace insideout
