// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarOutputs.h"

#include "Output/PartCells.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
bool IsInside(const std::vector<unsigned char>& inside, Id cell)
{
  return cell != None && inside[cell] != 0;
}
} // namespace

std::vector<BoundaryEdge> BoundaryEdges(
  const PlanarMesh& mesh, const std::vector<unsigned char>& inside)
{
  std::vector<BoundaryEdge> edges;
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; inside[cell] != 0 && k < 3; ++k)
    {
      if (!IsInside(inside, mesh.Neighbors[cell][k]))
      {
        edges.push_back(
          { EdgeOf(mesh.Cells[cell], k), mesh.Segments[cell][k], mesh.SegmentSides[cell][k] > 0 });
      }
    }
  }
  return edges;
}

std::vector<OutlierSegment> OutlierSegments(
  const SegmentComplex& curve, const PlanarMesh& mesh, const std::vector<unsigned char>& inside)
{
  std::vector<char> isKept(curve.Segments.size(), 0);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    for (int k = 0; inside[cell] != 0 && k < 3; ++k)
    {
      if (mesh.Segments[cell][k] != None)
      {
        isKept[mesh.Segments[cell][k]] = 1;
      }
    }
  }
  std::vector<OutlierSegment> outliers;
  for (Id s = 0; s < curve.NumberOfSegments(); ++s)
  {
    if (!isKept[s])
    {
      outliers.push_back(
        { s, s < curve.NumberOfConstraints ? OutlierReason::Energy : OutlierReason::LeftOut });
    }
  }
  return outliers;
}

std::vector<std::vector<Id>> JoinAlong(
  const std::vector<Segment>& segments, const std::vector<Id>& keys)
{
  const Id count = static_cast<Id>(segments.size());
  Id points = 0;
  for (const Segment& segment : segments)
  {
    points = std::max({ points, segment[0] + 1, segment[1] + 1 });
  }
  constexpr Id Several = -2;
  std::vector<Id> begins(points, None); // the segment that begins or ends at each point
  std::vector<Id> ends(points, None);
  for (Id s = 0; s < count; ++s)
  {
    Id& begin = begins[segments[s][0]];
    Id& end = ends[segments[s][1]];
    begin = begin == None ? s : Several;
    end = end == None ? s : Several;
  }
  const auto follows = [&](Id point) // the segment that continues the one that ends there
  {
    const Id from = ends[point];
    const Id to = begins[point];
    return from >= 0 && to >= 0 && keys[from] == keys[to] ? to : None;
  };
  std::vector<std::vector<Id>> lines;
  std::vector<char> isUsed(count, 0);
  const auto addFrom = [&](Id first)
  {
    std::vector<Id> line;
    for (Id s = first; s != None && !isUsed[s]; s = follows(segments[s][1]))
    {
      isUsed[s] = 1;
      line.push_back(s);
    }
    lines.push_back(std::move(line));
  };
  for (Id s = 0; s < count; ++s)
  {
    if (follows(segments[s][0]) == None) // nothing continues here
    {
      addFrom(s);
    }
  }
  for (Id s = 0; s < count; ++s)
  {
    if (!isUsed[s])
    {
      addFrom(s);
    }
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

Id SplitPoints(SegmentComplex& curve, PlanarMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  const std::size_t before = curve.Points.size();
  PartedCells<3> parted = PartCells(
    mesh.Cells, mesh.Neighbors, inside, std::vector<unsigned char>(before, 1), monitor, progress);
  mesh.Cells = std::move(parted.Cells);
  for (std::size_t p = before; p < parted.Places.size(); ++p)
  {
    const Id place = parted.Places[p];
    curve.Points.push_back(PlanarPoint(curve.Points[place]));
    curve.Origins.push_back(PointOrigin(curve.Origins[place]));
  }
  return static_cast<Id>(parted.Places.size() - before);
}

SolidRegions FindRegions(const PlanarMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress)
{
  return FindRegions(mesh.Neighbors, inside, monitor, progress);
}

std::vector<AreaProperties> MeasureRegions(const SegmentComplex& curve, const PlanarMesh& mesh,
  const Plane& plane, const SolidRegions& regions)
{
  struct Sums
  {
    double Area = 0;
    PlanarPoint Moment{ { 0, 0 } };
  };
  std::vector<Sums> sums(regions.Count);
  for (Id cell = 0; cell < mesh.NumberOfCells(); ++cell)
  {
    if (regions.OfCell[cell] != None)
    {
      Sums& sum = sums[regions.OfCell[cell]];
      const PlanarPoint& a = curve.Points[mesh.Cells[cell][0]];
      const PlanarPoint& b = curve.Points[mesh.Cells[cell][1]];
      const PlanarPoint& c = curve.Points[mesh.Cells[cell][2]];
      const double area = AreaOf(a, b, c, plane.Metric);
      sum.Area += area;
      for (int k = 0; k < 2; ++k)
      {
        sum.Moment[k] += area * (a[k] + b[k] + c[k]) / 3;
      }
    }
  }
  std::vector<AreaProperties> measured;
  for (const Sums& sum : sums)
  {
    measured.push_back({ std::ldexp(sum.Area, 2 * plane.Exponent),
      plane.Lift({ sum.Moment[0] / sum.Area, sum.Moment[1] / sum.Area }) });
  }
  return measured;
}
} // namespace insideout
