// SPDX-License-Identifier: GPL-3.0-or-later
#include "Common/Stages.h"
#include "Planar/CurveWindingNumber.h"
#include "Planar/SegmentTriangles.h"
#include "Refine/RefineTriangles.h"
#include "Support/Hash.h"
#include "Support/HashGroups.h"

using namespace insideout;

namespace
{
constexpr ProgressRange Progress = { Stages::Extracting, 0, 1 };

/**
 * The edges of all triangles that face up, drawn along z into the plane 2 z = x: those within a
 * patch cancel. An open curve lacks each seventh.
 */
SegmentSoup CurveOf(const TriangleSoup& soup, bool isOpen)
{
  SegmentSoup curve;
  for (const Point& p : soup.Points)
  {
    curve.Points.push_back({ p[0], p[1], p[0] / 2 });
  }
  std::size_t count = 0;
  for (const auto& [a, b, c] : soup.Triangles)
  {
    const Point &p = soup.Points[a], &q = soup.Points[b], &r = soup.Points[c];
    if ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) <= 0)
    {
      continue;
    }
    for (const Segment& segment : { Segment{ { a, b } }, Segment{ { b, c } }, Segment{ { c, a } } })
    {
      if (!isOpen || ++count % 7 != 0)
      {
        curve.Segments.push_back(segment);
      }
    }
  }
  return curve;
}

PlanarHull HullOf(const SegmentSoup& curve, Orientation orientation = Orientation::Automatic)
{
  PlanarHullParameters parameters;
  parameters.Orientation = orientation;
  Monitor monitor;
  return MeshPlanarHull(curve, FindPlane(curve.Points), parameters, monitor);
}

std::vector<unsigned char> AddLabels(const std::string& name, const PlanarHull& hull,
  const std::vector<Seed>& seeds, const SegmentMeshParameters& parameters, Hashes& hashes)
{
  Monitor monitor;
  MeshSegmentation found = SegmentTriangles(hull.Curve, hull.Mesh, hull.Plane, hull.W,
    PiecesOfSegments(hull.Mesh), seeds, parameters, monitor);
  AddHash(name, hashes, found.Inside);
  AddHash(name + ", figures", hashes, found.Statistics, found.Warnings);
  return found.Inside;
}

void AddMesh(
  const std::string& name, const SegmentComplex& curve, const PlanarMesh& mesh, Hashes& hashes)
{
  AddHash(name + ", curve", hashes, curve.Points, curve.Origins, curve.Segments, curve.Multiplicity,
    curve.SourceOffsets, curve.Sources, curve.NumberOfConstraints);
  AddHash(
    name + ", triangles", hashes, mesh.Cells, mesh.Neighbors, mesh.Segments, mesh.SegmentSides);
}

void AddSolid(const std::string& name, const PlanarHull& hull,
  const std::vector<unsigned char>& inside, Hashes& hashes)
{
  Monitor monitor;
  const SolidRegions regions = FindRegions(hull.Mesh, inside, monitor, Progress);
  AddHash(name + ", regions", hashes, regions.OfCell,
    MeasureRegions(hull.Curve, hull.Mesh, hull.Plane, regions));
  AddHash(name + ", boundary", hashes, BoundaryEdges(hull.Mesh, inside));
  AddHash(name + ", outliers", hashes, OutlierSegments(hull.Curve, hull.Mesh, inside));
  PlanarHull split = hull;
  SplitPoints(split.Curve, split.Mesh, inside, monitor, Progress);
  AddMesh(name + ", split points", split.Curve, split.Mesh, hashes);
}
} // namespace

void AddPlane(const TriangleSoup& soup, Hashes& hashes)
{
  for (const bool isOpen : { false, true })
  {
    const std::string name = isOpen ? "open" : "closed";
    const SegmentSoup curve = CurveOf(soup, isOpen);
    Monitor monitor;
    const PlanarHull hull = HullOf(curve);
    AddMesh(name, hull.Curve, hull.Mesh, hashes);
    AddHash(
      name + ", segments", hashes, hull.MergedInto, hull.DegenerateSegments, hull.TurnedSegments);
    AddHash(name + ", w", hashes, hull.W, hull.Areas.Winding);
    AddHash(name + ", figures", hashes, hull.Statistics, hull.Warnings);
    AddHash(
      name + ", w at points", hashes, CurveWindingNumber(hull).At(soup.Points, monitor, Progress));
    AddHash(name + ", w of the reverse", hashes, HullOf(curve, Orientation::Reverse).W);

    const CurveDefects defects = FindCurveDefects(curve, hull.Plane, {}, monitor);
    AddHash(name + ", defects", hashes, defects.Segments, defects.Points, defects.IntersectingPairs,
      defects.TurnedSegments, defects.Areas.Winding, defects.Warnings);

    const Point middle = PointIn(soup, 0.5, 0.5, 0.5);
    const std::vector<Seed> seeds = { { { middle[0], middle[1], middle[0] / 2 }, false },
      { curve.Points.front(), true } };
    SegmentMeshParameters parameters;
    AddSolid(name, hull, AddLabels(name + ", labels", hull, {}, parameters, hashes), hashes);
    AddLabels(name + ", seeded", hull, seeds, parameters, hashes);
    parameters.ConstrainFacets = parameters.FillNonManifold = true;
    AddLabels(name + ", constrained", hull, seeds, parameters, hashes);
    parameters.Topology.Goal = TopologyGoal::SimplyConnected;
    AddLabels(name + ", simply connected", hull, {}, parameters, hashes);
  }
}

void AddPlanarRefinement(const TriangleSoup& soup, Hashes& hashes)
{
  const PlanarHull hull = HullOf(CurveOf(soup, false));
  Monitor monitor;
  const std::vector<unsigned char> inside =
    SegmentTriangles(hull.Curve, hull.Mesh, hull.Plane, hull.W, {}, {}, {}, monitor).Inside;
  for (const SurfaceTreatment treatment : { SurfaceTreatment::Kept, SurfaceTreatment::Split })
  {
    for (const double length : { 0.0, DiagonalOf(soup) / 32 })
    {
      const std::string name = std::string(treatment == SurfaceTreatment::Kept ? "kept" : "split") +
        (length > 0 ? ", short edges" : "");
      RefinementParameters parameters;
      parameters.Surface = treatment;
      parameters.Sizes.EdgeLength = length;
      const RefinedTriangles refined =
        RefineTriangles(hull.Curve, hull.Mesh, inside, hull.Plane, parameters, monitor);
      AddMesh(name, refined.Curve, refined.Mesh, hashes);
      AddHash(name + ", origins", hashes, refined.OriginalPoints, refined.OriginalCells,
        refined.CellsOfPoints);
      AddHash(name + ", figures", hashes, refined.Statistics, refined.Warnings);
    }
  }
}
