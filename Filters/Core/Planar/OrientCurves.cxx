// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/OrientCurves.h"

#include "Common/BoxTree.h"
#include "Common/Buckets.h"
#include "Common/Stages.h"
#include "Orient/ChooseTurns.h"
#include "Output/Regions.h"
#include "WindingNumber/PolylineWindingNumber.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace insideout
{
namespace
{
/** A chain with a gap of more than this fraction of its length is a sheet. Half a circle has 0.64,
 * and no well-defined area. */
constexpr double LargestGap = 0.5;

/** Chains of segments, joined through points of exactly two segments, with each segment's direction
 * relative to the first. */
struct Chain
{
  std::vector<Id> Segments;
  std::vector<char> IsAgainst; ///< per segment, its chain
};

/** Traces segments that count. */
class ChainFinder
{
public:
  explicit ChainFinder(const SegmentComplex& curve)
    : Curve(curve)
    , SegmentsOfPoints(curve.Points.size(),
        [&](auto visit)
        {
          for (Id s = 0; s < curve.NumberOfSegments(); ++s)
          {
            for (int k = 0; curve.Multiplicity[s] != 0 && k < 2; ++k)
            {
              visit(static_cast<std::size_t>(curve.Segments[s][k]), s);
            }
          }
        })
    , IsTaken(curve.Segments.size(), 0)
  {
  }

  std::vector<Chain> Find()
  {
    std::vector<Chain> chains;
    for (Id s = 0; s < this->Curve.NumberOfSegments(); ++s)
    {
      if (this->Curve.Multiplicity[s] != 0 && !this->IsTaken[s])
      {
        Chain chain;
        this->Take(s, false, chain);
        this->Follow(s, 1, chain);
        this->Follow(s, 0, chain);
        chains.push_back(std::move(chain));
      }
    }
    return chains;
  }

private:
  void Take(Id segment, bool isAgainst, Chain& chain)
  {
    this->IsTaken[segment] = 1;
    chain.Segments.push_back(segment);
    chain.IsAgainst.push_back(isAgainst);
  }

  /** Trace from one end of a segment. */
  void Follow(Id segment, int end, Chain& chain)
  {
    const int firstEnd = end;
    Id point = this->Curve.Segments[segment][end];
    while (this->SegmentsOfPoints[point].Size() == 2)
    {
      const auto two = this->SegmentsOfPoints[point];
      const Id next = *two.begin() == segment ? *(two.begin() + 1) : *two.begin();
      if (this->IsTaken[next] ||
        std::abs(this->Curve.Multiplicity[next]) != std::abs(this->Curve.Multiplicity[segment]))
      {
        return;
      }
      const int arrival = this->Curve.Segments[next][0] == point ? 0 : 1;
      const bool runsOn = (arrival == 0) == (firstEnd == 1);
      const bool isAsFirst =
        this->Curve.Multiplicity[next] * this->Curve.Multiplicity[chain.Segments[0]] > 0;
      this->Take(next, runsOn != isAsFirst, chain);
      segment = next;
      point = this->Curve.Segments[next][1 - arrival];
    }
  }

  const SegmentComplex& Curve;
  const Buckets<Id> SegmentsOfPoints;
  std::vector<char> IsTaken;
};

/** Turn the minority by length of each chain's segments against the others. */
void TurnTheLesser(const SegmentComplex& curve, const PlanarMetric& metric, const Chain& chain,
  std::vector<char>& turned)
{
  double along = 0;
  double against = 0;
  for (std::size_t i = 0; i < chain.Segments.size(); ++i)
  {
    const Segment& segment = curve.Segments[chain.Segments[i]];
    (chain.IsAgainst[i] ? against : along) +=
      metric.Distance(curve.Points[segment[0]], curve.Points[segment[1]]);
  }
  for (std::size_t i = 0; i < chain.Segments.size(); ++i)
  {
    turned[chain.Segments[i]] = (chain.IsAgainst[i] != 0) == (against <= along);
  }
}

/** A chain that encloses an area. */
struct CurveShell
{
  std::vector<CountedSegment> Segments; ///< including a segment across the gap
  std::vector<Id> Members;              ///< segments of the curve
  double Area = 0;                      ///< signed area
  bool IsOpen = false;                  ///< has a gap
  Box Bounds = Box::Empty();
};

Point Flat(const PlanarPoint& p)
{
  return { { p[0], p[1], 0 } };
}

/** The chain with its gap closed; without segments if it is a sheet. */
CurveShell ShellOf(const SegmentComplex& curve, const PlanarMetric& metric, const Chain& chain,
  const std::vector<char>& turned)
{
  CurveShell shell;
  std::map<Id, int> ends;
  double length = 0;
  for (const Id s : chain.Segments)
  {
    const Segment& segment = curve.Segments[s];
    const int count = turned[s] ? -curve.Multiplicity[s] : curve.Multiplicity[s];
    shell.Segments.push_back({ segment[0], segment[1], count });
    ends[segment[0]] -= count;
    ends[segment[1]] += count;
    length += metric.Distance(curve.Points[segment[0]], curve.Points[segment[1]]);
  }
  std::vector<Id> loose;
  for (const auto& [point, count] : ends)
  {
    if (count != 0)
    {
      loose.push_back(point);
    }
  }
  const double gap =
    loose.size() == 2 ? metric.Distance(curve.Points[loose[0]], curve.Points[loose[1]]) : 0;
  if (loose.size() > 2 || gap > LargestGap * length)
  {
    return CurveShell();
  }
  shell.IsOpen = loose.size() == 2;
  if (shell.IsOpen)
  {
    shell.Segments.push_back({ loose[0], loose[1], ends[loose[0]] });
  }
  shell.Members = chain.Segments;
  const PlanarPoint& origin = curve.Points[shell.Segments.front().From];
  for (const CountedSegment& segment : shell.Segments)
  {
    shell.Area +=
      segment.Count * AreaOf(origin, curve.Points[segment.From], curve.Points[segment.To], metric);
    shell.Bounds.Add(Flat(curve.Points[segment.From]));
    shell.Bounds.Add(Flat(curve.Points[segment.To]));
  }
  return shell;
}

/** A region between segments, or a triangle: its area, and a place within its largest triangle. */
struct CurveRegion
{
  double Area = 0;
  double Largest = -1;
  PlanarPoint Place{ { 0, 0 } };
};

/**
 * @param[in] areOpen shells have gaps, which would connect regions: each triangle then is a region
 */
std::vector<CurveRegion> FindCurveRegions(const SegmentComplex& curve, const PlanarMesh& mesh,
  const PlanarMetric& metric, bool areOpen, Monitor& monitor)
{
  std::vector<std::array<Id, 3>> neighbors = mesh.Neighbors; // not across segments
  for (std::size_t c = 0; c < neighbors.size(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      neighbors[c][k] = mesh.Segments[c][k] == None && !areOpen ? neighbors[c][k] : None;
    }
  }
  const SolidRegions regions = FindRegions(neighbors,
    std::vector<unsigned char>(mesh.Cells.size(), 1), monitor, { Stages::Orienting, 0, 0.5 });
  std::vector<CurveRegion> found(regions.Count);
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    const PlanarPoint& p = curve.Points[mesh.Cells[c][0]];
    const PlanarPoint& q = curve.Points[mesh.Cells[c][1]];
    const PlanarPoint& r = curve.Points[mesh.Cells[c][2]];
    const double area = AreaOf(p, q, r, metric);
    CurveRegion& region = found[regions.OfCell[c]];
    region.Area += area;
    if (area > region.Largest)
    {
      region.Largest = area;
      region.Place = { (p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3 };
    }
  }
  return found;
}

/** The winding number of each shell around each region, in ChooseTurns' format. */
std::vector<ShellRegion> WindAround(const std::vector<CurveShell>& shells,
  const std::vector<CurveRegion>& regions, const SegmentComplex& curve, Monitor& monitor)
{
  std::vector<Box> places;
  places.reserve(regions.size());
  for (const CurveRegion& region : regions)
  {
    places.push_back({ Flat(region.Place), Flat(region.Place) });
  }
  const BoxTree tree(std::move(places));
  std::vector<std::vector<ShellWinding>> windings(regions.size());
  const LoopProgress progress(monitor, { Stages::Orienting, 0.5, 1 }, shells.size());
  for (std::size_t s = 0; s < shells.size(); ++s)
  {
    progress.CheckNow(s);
    std::vector<PlanarPoint> points; // an evaluator of its own: its cost depends on its points
    std::vector<CountedSegment> segments;
    for (const CountedSegment& segment : shells[s].Segments)
    {
      const Id first = static_cast<Id>(points.size());
      points.push_back(curve.Points[segment.From]);
      points.push_back(curve.Points[segment.To]);
      segments.push_back({ first, first + 1, segment.Count });
    }
    const PolylineWindingNumber number(std::move(points), segments);
    tree.Visit(shells[s].Bounds,
      [&](Id region)
      {
        const int w = static_cast<int>(std::lround(number.At(regions[region].Place)));
        if (w != 0)
        {
          windings[region].push_back({ static_cast<Id>(s), w });
        }
      });
  }
  std::map<std::vector<ShellWinding>, double> areas;
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    if (!windings[r].empty())
    {
      areas[windings[r]] += regions[r].Area;
    }
  }
  std::vector<ShellRegion> found;
  for (const auto& [winding, area] : areas)
  {
    found.push_back({ winding, area });
  }
  return found;
}

/** One per segment of the given curve. */
std::vector<char> ChooseSegments(const SegmentComplex& given, Orientation orientation,
  const Plane& plane, const PlanarMesh& mesh, const SegmentComplex& curve,
  std::vector<std::string>& warnings, Monitor& monitor)
{
  std::vector<char> turned(given.Segments.size(), orientation == Orientation::Reverse);
  if (orientation == Orientation::AsGiven || orientation == Orientation::Reverse)
  {
    return turned;
  }
  std::vector<CurveShell> shells;
  for (const Chain& chain : ChainFinder(given).Find())
  {
    TurnTheLesser(given, plane.Metric, chain, turned);
    CurveShell shell = ShellOf(given, plane.Metric, chain, turned);
    if (!shell.Segments.empty())
    {
      shells.push_back(std::move(shell));
    }
  }
  const auto disagreeing = std::count(turned.begin(), turned.end(), 1);
  ShellTurns turns;
  if (orientation == Orientation::Outward)
  {
    for (const CurveShell& shell : shells)
    {
      turns.Turned.push_back(shell.Area < 0);
    }
  }
  else
  {
    std::vector<Id> sizes;
    for (const CurveShell& shell : shells)
    {
      sizes.push_back(static_cast<Id>(shell.Members.size()));
    }
    const bool areOpen = std::any_of(
      shells.begin(), shells.end(), [](const CurveShell& shell) { return shell.IsOpen; });
    const std::vector<CurveRegion> regions =
      FindCurveRegions(curve, mesh, plane.Metric, areOpen, monitor);
    turns = ChooseTurns(WindAround(shells, regions, curve, monitor), sizes);
  }
  Id turnedShells = 0;
  for (std::size_t s = 0; s < shells.size(); ++s)
  {
    turnedShells += turns.Turned[s] != 0;
    for (const Id member : shells[s].Members)
    {
      turned[member] = (turned[member] != 0) != (turns.Turned[s] != 0);
    }
  }
  if (orientation == Orientation::Automatic && disagreeing > 0)
  {
    warnings.push_back(std::to_string(disagreeing) +
      " segments run the other way than those that they meet and are turned over");
  }
  if (orientation == Orientation::Automatic && turnedShells > 0)
  {
    warnings.push_back(std::to_string(turnedShells) + " of " + std::to_string(shells.size()) +
      " closed curves are inside out and are turned over");
  }
  return turned;
}
} // namespace

CurveTurns OrientCurves(const SegmentComplex& given, Orientation orientation, const Plane& plane,
  const PlanarMesh& mesh, SegmentComplex& curve, Monitor& monitor)
{
  monitor.Check(Stages::Orienting, 0);
  CurveTurns turns;
  const std::vector<char> turned =
    ChooseSegments(given, orientation, plane, mesh, curve, turns.Warnings, monitor);
  // Turn each given segment with its first piece: both run the same way.
  Id numberOfSources = 0;
  for (const SegmentSource& source : given.Sources)
  {
    numberOfSources = std::max(numberOfSources, source.Segment + 1);
  }
  std::vector<Id> segmentOf(numberOfSources, None);
  std::vector<char> isFirst(numberOfSources, 0);
  for (Id s = 0; s < given.NumberOfSegments(); ++s)
  {
    for (Id i = given.SourceOffsets[s]; i < given.SourceOffsets[s + 1]; ++i)
    {
      segmentOf[given.Sources[i].Segment] = s;
      isFirst[given.Sources[i].Segment] = i == given.SourceOffsets[s];
      if (turned[s])
      {
        turns.Segments.push_back(given.Sources[i].Segment);
      }
    }
  }
  std::sort(turns.Segments.begin(), turns.Segments.end());
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    int count = 0;
    for (Id i = curve.SourceOffsets[s]; i < curve.SourceOffsets[s + 1]; ++i)
    {
      SegmentSource& source = curve.Sources[i];
      const Id of = segmentOf[source.Segment];
      source.Reversed = source.Reversed != (turned[of] != 0);
      count += !isFirst[source.Segment] ? 0
        : source.Reversed               ? -given.Multiplicity[of]
                                        : given.Multiplicity[of];
    }
    curve.Multiplicity[s] = static_cast<std::int16_t>(count);
  }
  monitor.Check(Stages::Orienting, 1);
  return turns;
}
} // namespace insideout
