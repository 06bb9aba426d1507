// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/WindingNumberOfTriangles.h"

#include "Common/ChunkedLoop.h"
#include "Common/LoopProgress.h"
#include "Common/Stages.h"
#include "Planar/CountSegments.h"
#include "WindingNumber/PolylineWindingNumber.h"
#include "WindingNumber/SpatialOrder.h"

namespace insideout
{
namespace
{
/** Carry it from cell to cell, breadth first from the hull. */
std::vector<double> Walk(const SegmentComplex& curve, const PlanarMesh& mesh, Monitor& monitor)
{
  std::vector<double> w(mesh.Cells.size(), 0);
  std::vector<char> isReached(mesh.Cells.size(), 0);
  std::vector<Id> reached;
  reached.reserve(mesh.Cells.size());
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (mesh.Neighbors[cell][k] == None && !isReached[cell])
      {
        isReached[cell] = 1;
        w[cell] = MultiplicityOnEntering(curve, mesh, cell, k);
        reached.push_back(cell);
      }
    }
  }
  const LoopProgress progress(monitor, { Stages::WindingNumbers, 0, 1 }, mesh.Cells.size());
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    progress.Check(i);
    const Id cell = reached[i];
    for (int k = 0; k < 3; ++k)
    {
      const Id next = mesh.Neighbors[cell][k];
      if (next != None && !isReached[next])
      {
        isReached[next] = 1;
        w[next] = w[cell] - MultiplicityOnEntering(curve, mesh, cell, k);
        reached.push_back(next);
      }
    }
  }
  return w;
}

} // namespace

std::vector<double> WindingNumberOfTriangles(
  const SegmentComplex& curve, const PlanarMesh& mesh, const PlanarMetric& metric, Monitor& monitor)
{
  const bool canWalk =
    NumberOfOpenEnds(curve) == 0 && curve.NumberOfConstraints == curve.NumberOfSegments();
  std::vector<double> w = canWalk ? Walk(curve, mesh, monitor)
                                  : WindingNumberOfOtherTriangles(curve, curve.Points, mesh.Cells,
                                      metric, monitor, { Stages::WindingNumbers, 0, 1 });
  monitor.Check(Stages::WindingNumbers, 1);
  return w;
}

std::vector<double> WindingNumberOfOtherTriangles(const SegmentComplex& curve,
  const std::vector<PlanarPoint>& points, const std::vector<Triangle>& cells,
  const PlanarMetric& metric, Monitor& monitor, const ProgressRange& progress)
{
  std::vector<CountedSegment> segments;
  segments.reserve(curve.Segments.size());
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    segments.push_back({ curve.Segments[s][0], curve.Segments[s][1], curve.Multiplicity[s] });
  }
  const PolylineWindingNumber number(curve.Points, segments, metric);
  std::vector<double> w(cells.size());
  // Consecutive neighbors access data still in the cache.
  std::vector<Point> places;
  places.reserve(cells.size());
  for (const Triangle& cell : cells)
  {
    const PlanarPoint& corner = points[cell[0]];
    places.push_back({ { corner[0], corner[1], 0 } });
  }
  const std::vector<Id> order = SpatialOrder(places);
  const double nanosecondsPerCell = 10000;
  ChunkedLoop(static_cast<Id>(cells.size()), nanosecondsPerCell, monitor, progress,
    [&](Id i)
    {
      const Id cell = order[i];
      const auto& [a, b, c] = cells[cell];
      w[cell] = number.AtMean(points[a], points[b], points[c]);
    });
  return w;
}
} // namespace insideout
