// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactWindingNumber.h"

#include "HoleCaps.h"

namespace insideout
{
ExactWindingNumber::ExactWindingNumber(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
  : Caps(CapHoles(points, CountedBoundary(triangles, static_cast<Id>(points.size()))))
  , Tree(points, CloseChain(triangles, this->Caps), monitor, progress)
  , SumOfCaps(points, this->Caps)
{
}

void ExactWindingNumber::Evaluate(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  const double middle =
    this->SumOfCaps.IsEmpty() ? progress.End : progress.Begin + (progress.End - progress.Begin) / 8;
  this->Tree.Evaluate(sites, order, w, monitor, { progress.Stage, progress.Begin, middle });
  this->SumOfCaps.Add(sites, order, w, monitor, { progress.Stage, middle, progress.End });
}

double ExactWindingNumber::At(const Point& point) const
{
  return this->Tree.At(SiteAt(point)) + this->SumOfCaps.At(point);
}
} // namespace insideout
