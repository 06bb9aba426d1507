// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactWindingNumber.h"

#include "ChunkedLoop.h"
#include "HoleCaps.h"

namespace insideout
{
namespace
{
/** The chain less its caps, which has no boundary. */
std::vector<CountedTriangle> CloseChain(const std::vector<CountedTriangle>& triangles,
  const std::vector<std::vector<CountedTriangle>>& caps)
{
  if (caps.empty())
  {
    return triangles;
  }
  std::vector<CountedTriangle> closed = triangles;
  for (const std::vector<CountedTriangle>& cap : caps)
  {
    for (const CountedTriangle& triangle : cap)
    {
      closed.push_back({ triangle.Corners, -triangle.Count });
    }
  }
  return AddChains(closed);
}
} // namespace

ExactWindingNumber::ExactWindingNumber(std::vector<Point> points,
  const std::vector<CountedTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
  : Points(std::move(points))
  , Exponent(LargestExponent(this->Points))
  , Boundary(CountedBoundary(triangles, static_cast<Id>(this->Points.size())))
  , Caps(CapHoles(this->Points, this->Boundary))
  , Tree(this->Points, CloseChain(triangles, this->Caps), this->Exponent, monitor, progress)
  , SumOfCaps(this->Points, this->Caps, this->Exponent)
{
}

void ExactWindingNumber::Evaluate(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  const double middle =
    this->IsClosed() ? progress.End : progress.Begin + (progress.End - progress.Begin) / 8;
  this->EvaluateClosed(sites, order, w, monitor, { progress.Stage, progress.Begin, middle });
  this->AddCaps(sites, order, w, monitor, { progress.Stage, middle, progress.End });
}

void ExactWindingNumber::EvaluateClosed(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  const std::size_t sitesPerCall = 256;
  const Id calls = static_cast<Id>((order.size() + sitesPerCall - 1) / sitesPerCall);
  const double nanosecondsPerSite = 500;
  ChunkedLoop(calls, nanosecondsPerSite * sitesPerCall, monitor, progress,
    [&](Id call)
    {
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      for (std::size_t i = first; i < std::min(order.size(), first + sitesPerCall); ++i)
      {
        Site site = sites[order[i]];
        for (Point& corner : site.Corners)
        {
          corner = Scaled(corner, this->Exponent);
        }
        w[order[i]] = this->Tree.At(site);
      }
    });
}

void ExactWindingNumber::AddCaps(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  this->SumOfCaps.Add(sites, order, w, monitor, progress);
}
} // namespace insideout
