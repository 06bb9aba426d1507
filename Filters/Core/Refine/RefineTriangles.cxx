// SPDX-License-Identifier: GPL-3.0-or-later
#include "Refine/RefineTriangles.h"

#include "Common/Error.h"
#include "Common/Stages.h"
#include "Output/Regions.h"
#include "Planar/TriangleLocator.h"
#include "Refine/PlanarRefiner.h"

#include <algorithm>

namespace insideout
{
namespace
{
/** In degrees. */
struct Angles
{
  double Least = 0;
  double Quantile = 0; ///< the value that a hundredth of all values do not exceed
  double Most = 0;
};

Angles AnglesOf(const std::vector<PlanarPoint>& points, const std::vector<Triangle>& cells,
  const PlanarMetric& metric)
{
  std::vector<double> all;
  for (const Triangle& cell : cells)
  {
    for (int k = 0; k < 3; ++k)
    {
      all.push_back(
        AngleAt(points[cell[k]], points[cell[(k + 1) % 3]], points[cell[(k + 2) % 3]], metric));
    }
  }
  if (all.empty())
  {
    return {};
  }
  std::sort(all.begin(), all.end());
  return { all.front(), all[(all.size() - 1) / 100], all.back() };
}

/** Locates input cells for places, on the same side of all segments as another cell. */
class InputCells
{
public:
  InputCells(const SegmentComplex& curve, const PlanarMesh& mesh,
    const std::vector<unsigned char>& inside, Monitor& monitor)
    : Locator(curve.Points, mesh)
  {
    std::vector<std::array<Id, 3>> neighbors = mesh.Neighbors; // not across segments
    for (std::size_t c = 0; c < neighbors.size(); ++c)
    {
      for (int k = 0; k < 3; ++k)
      {
        neighbors[c][k] = mesh.Segments[c][k] == None ? neighbors[c][k] : None;
      }
    }
    this->Sides = FindRegions(neighbors, inside, monitor, { Stages::Refining, 0.8, 0.85 });
  }

  /** The nearest cell itself, if rounding put the place outside all of them. */
  Id Find(const PlanarPoint& place, Id near) const
  {
    const Id found = this->Locator.Find(
      place, [&](Id cell) { return this->Sides.OfCell[cell] == this->Sides.OfCell[near]; });
    return found == None ? near : found;
  }

private:
  const TriangleLocator Locator;
  SolidRegions Sides;
};

/** Copy the points that cells use, and the cells with these. */
void TakeCells(const SegmentComplex& curve, const RefinableTriangles& mesh, const InputCells& cells,
  RefinedTriangles& result)
{
  const auto given = static_cast<Id>(curve.Points.size());
  std::vector<Id> nearPoints(mesh.Points().size(), None);
  for (const RefinableTriangles::Cell& cell : mesh.Cells())
  {
    for (const Id p : cell.Corners)
    {
      nearPoints[p] = cell.Near;
    }
  }
  std::vector<Id> numbers(nearPoints.size(), None);
  for (Id p = 0; p < static_cast<Id>(nearPoints.size()); ++p)
  {
    if (nearPoints[p] != None)
    {
      const PlanarPoint& place = mesh.Points()[p];
      numbers[p] = static_cast<Id>(result.Curve.Points.size());
      result.Curve.Points.push_back(place);
      result.Curve.Origins.push_back(p < given ? curve.Origins[p] : PointOrigin());
      result.OriginalPoints.push_back(p < given ? p : None);
      result.CellsOfPoints.push_back(cells.Find(place, nearPoints[p]));
    }
  }
  for (const RefinableTriangles::Cell& cell : mesh.Cells())
  {
    PlanarPoint middle = { 0, 0 };
    Triangle corners = cell.Corners;
    for (Id& p : corners)
    {
      middle[0] += mesh.Points()[p][0] / 3;
      middle[1] += mesh.Points()[p][1] / 3;
      p = numbers[p];
    }
    result.Mesh.Cells.push_back(corners);
    result.Mesh.Neighbors.push_back(cell.Neighbors);
    result.OriginalCells.push_back(cells.Find(middle, cell.Near));
  }
}

/** Copy the pieces of segments that are edges of cells, each once. */
void TakeSegments(const SegmentComplex& curve, const PlanarMesh& input,
  const RefinableTriangles& mesh, RefinedTriangles& result)
{
  PlanarMesh& made = result.Mesh;
  SegmentComplex& pieces = result.Curve;
  made.Segments.assign(made.Cells.size(), { { None, None, None } });
  made.SegmentSides.assign(made.Cells.size(), { { 0, 0, 0 } });
  for (Id c = 0; c < made.NumberOfCells(); ++c)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id source = mesh.Cells()[c].Sources[k];
      const Id segment = source == None ? None : input.Segments[source / 3][source % 3];
      if (segment == None || made.Segments[c][k] != None)
      {
        continue;
      }
      const std::int8_t side = input.SegmentSides[source / 3][source % 3];
      const auto [a, b] = EdgeOf(made.Cells[c], k);
      const Id piece = pieces.NumberOfSegments();
      pieces.Segments.push_back(side > 0 ? Segment{ { a, b } } : Segment{ { b, a } });
      pieces.Multiplicity.push_back(curve.Multiplicity[segment]);
      pieces.Sources.insert(pieces.Sources.end(),
        curve.Sources.begin() + curve.SourceOffsets[segment],
        curve.Sources.begin() + curve.SourceOffsets[segment + 1]);
      pieces.SourceOffsets.push_back(static_cast<Id>(pieces.Sources.size()));
      made.Segments[c][k] = piece;
      made.SegmentSides[c][k] = side;
      const Id beyond = made.Neighbors[c][k];
      if (beyond != None)
      {
        const auto& back = made.Neighbors[beyond];
        const auto j = std::find(back.begin(), back.end(), c) - back.begin();
        made.Segments[beyond][j] = piece;
        made.SegmentSides[beyond][j] = static_cast<std::int8_t>(-side);
      }
    }
  }
  pieces.NumberOfConstraints = pieces.NumberOfSegments();
}

void AddStatistics(const SegmentComplex& curve, const PlanarMesh& mesh,
  const std::vector<unsigned char>& inside, const Plane& plane, RefinedTriangles& result)
{
  std::vector<Triangle> before;
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    if (inside[c] != 0)
    {
      before.push_back(mesh.Cells[c]);
    }
  }
  for (const auto& [angles, prefix] :
    { std::pair(AnglesOf(curve.Points, before, plane.Metric), std::string("Before")),
      std::pair(AnglesOf(result.Curve.Points, result.Mesh.Cells, plane.Metric), std::string()) })
  {
    result.Statistics.emplace_back(prefix + "MinAngle", angles.Least);
    result.Statistics.emplace_back(prefix + "Angle1Percent", angles.Quantile);
    result.Statistics.emplace_back(prefix + "MaxAngle", angles.Most);
  }
  result.Statistics.emplace_back("RefinedCells", result.Mesh.NumberOfCells());
}
} // namespace

RefinedTriangles RefineTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const std::vector<unsigned char>& inside, const Plane& plane,
  const RefinementParameters& parameters, Monitor& monitor)
{
  if (parameters.Surface == SurfaceTreatment::Remeshed)
  {
    throw Error(ErrorCode::InvalidParameter,
      "in a plane refinement can keep or split the boundary, not remesh it");
  }
  PlanarRefiner refiner(curve, mesh, inside, plane, parameters, monitor);
  refiner.Run();

  RefinedTriangles result;
  TakeCells(curve, refiner.Result(), InputCells(curve, mesh, inside, monitor), result);
  monitor.Check(Stages::Refining, 0.95);
  TakeSegments(curve, mesh, refiner.Result(), result);
  const auto added = std::count(result.OriginalPoints.begin(), result.OriginalPoints.end(), None);
  result.Statistics.emplace_back("AddedPoints", added);
  result.Statistics.emplace_back("SurfacePoints", refiner.SurfacePoints());
  if (parameters.Sizes.MaximumVolume > 0)
  {
    const Id large = refiner.CountLargeCells();
    result.Statistics.emplace_back("CellsAboveMaximumVolume", large);
    if (large > 0)
    {
      result.Warnings.push_back(std::to_string(large) + " of " +
        std::to_string(result.Mesh.NumberOfCells()) +
        " triangles are larger than MaximumVolume: edges that stay as they are may allow no "
        "smaller ones");
    }
  }
  const bool isKept = parameters.Surface == SurfaceTreatment::Kept;
  if (const Id cells = refiner.CountLongCells();
      isKept && parameters.Sizes.EdgeLength > 0 && cells > 0)
  {
    result.Warnings.push_back(std::to_string(cells) + " of " +
      std::to_string(result.Mesh.NumberOfCells()) +
      " triangles have edges that are much longer than EdgeLength: they lie beside long edges that "
      "are kept, and smaller ones would be flat. Where the surface is split those are cut");
  }
  AddStatistics(curve, mesh, inside, plane, result);
  if (refiner.RanOut())
  {
    result.Warnings.push_back("refining ended at " + std::to_string(added) +
      " new points, with thin triangles left: parts of the curve lie too close to each other");
  }
  monitor.Check(Stages::Refining, 1);
  return result;
}
} // namespace insideout