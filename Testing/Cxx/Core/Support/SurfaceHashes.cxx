// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/SurfaceOfExpression.h"
#include "Common/Box.h"
#include "Common/Stages.h"
#include "Common/Vectors.h"
#include "GraphCut/SegmentMesh.h"
#include "LostArea.h"
#include "NothingInside.h"
#include "Output/ManifoldBoundary.h"
#include "Output/MergePieces.h"
#include "Output/SeparateOverlaps.h"
#include "Output/SplitSeams.h"
#include "Output/VoxelFractions.h"
#include "Support/Hash.h"
#include "Support/HashGroups.h"
#include "Support/TestMeshes.h"

#include <algorithm>
#include <numeric>

using namespace insideout;

namespace
{
constexpr ProgressRange Progress = { Stages::Extracting, 0, 1 };

std::vector<unsigned char> AddLabels(const std::string& name, const HullMesh& hull,
  const std::vector<Seed>& seeds, const SegmentMeshParameters& parameters, Hashes& hashes)
{
  Monitor monitor;
  MeshSegmentation found =
    SegmentMesh(hull.Mesh, hull.W, PiecesOfFacets(hull.Mesh), seeds, parameters, monitor);
  AddHash(name, hashes, found.Inside);
  AddHash(name + ", figures", hashes, found.Statistics, found.Warnings);
  return found.Inside;
}

/** The surface twice, with a gap between the copies that is as wide as the surface. */
TriangleSoup Twice(const TriangleSoup& soup)
{
  TriangleSoup other = soup;
  const double shift = 2 * (PointIn(soup, 1, 0, 0)[0] - PointIn(soup, 0, 0, 0)[0]);
  for (Point& p : other.Points)
  {
    p[0] += shift;
  }
  return testmeshes::Join(soup, other);
}
} // namespace

HullMesh ExactHull(const TriangleSoup& soup, HullMeshParameters parameters)
{
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  Monitor monitor;
  return MeshHull(soup, parameters, monitor);
}

void AddHull(const std::string& name, const HullMesh& hull, Hashes& hashes)
{
  const FacetComplex& surface = hull.Surface;
  AddHash(name + ", resolved", hashes, surface.Points, surface.Origins, surface.Facets,
    surface.Multiplicity, surface.SourceOffsets, surface.Sources, surface.NumberOfConstraints);
  AddHash(name + ", triangles", hashes, hull.MergedInto, hull.DegenerateTriangles,
    hull.TurnedTriangles, hull.SheetTriangles);
  AddHash(name + ", cells", hashes, hull.Mesh.Points, hull.Mesh.Origins, hull.Mesh.Cells,
    hull.Mesh.Neighbors, hull.Mesh.Facets, hull.Mesh.FacetSides, hull.Mesh.LostFacets);
  AddHash(name + ", w", hashes, hull.W);
  AddHash(name + ", figures", hashes, hull.Statistics, hull.Warnings);
}

double DiagonalOf(const TriangleSoup& soup)
{
  return Distance(PointIn(soup, 0, 0, 0), PointIn(soup, 1, 1, 1));
}

Point PointIn(const TriangleSoup& soup, double x, double y, double z)
{
  const Box box = BoundingBox(soup.Points);
  return { box.Low[0] + x * box.Extent(0), box.Low[1] + y * box.Extent(1),
    box.Low[2] + z * box.Extent(2) };
}

void AddRepair(const TriangleSoup& soup, Hashes& hashes)
{
  Monitor monitor;
  HullMesh hull = ResolveHull(OneBody(soup), {}, monitor);
  const auto repaired = SurfaceOfExpression(hull, { SetOperation::Union, 1 }, monitor);
  AddHash("is closed", hashes, repaired.has_value());
  if (repaired)
  {
    AddHash("boundary", hashes, repaired->Boundary, repaired->MinimumW, repaired->MaximumW);
    AddHash("outliers", hashes, repaired->Outliers);
    AddHash("volume", hashes, VolumeWithin(hull.Surface.Points, repaired->Boundary));
  }
}

void AddThickening(const TriangleSoup& soup, Hashes& hashes)
{
  constexpr std::size_t mostTriangles = 6; // slabs of more that cross take long to resolve
  TriangleSoup few = soup;
  few.Triangles.resize(std::min(few.Triangles.size(), mostTriangles));
  few = testmeshes::Join(
    few, testmeshes::Box(PointIn(soup, 0.25, 0.25, 0.25), PointIn(soup, 0.75, 0.75, 0.75)));
  HullMeshParameters parameters;
  parameters.Thicken.Width = DiagonalOf(soup) / 64;
  AddHull("sheets", ExactHull(few, parameters), hashes);
  parameters.Thicken.All = true;
  AddHull("all", ExactHull(few, parameters), hashes);
}

void AddPartsApart(const TriangleSoup& soup, Hashes& hashes)
{
  HullMeshParameters parameters;
  parameters.PartsApart = true;
  AddHull("two", ExactHull(Twice(soup), parameters), hashes);
}

void AddSeeds(const TriangleSoup& soup, Hashes& hashes)
{
  const HullMesh hull = ExactHull(soup);
  const std::vector<Seed> seeds = { { PointIn(soup, 0.5, 0.5, 0.5), false },
    { PointIn(soup, 0.375, 0.25, 0.625), true }, { PointIn(soup, 0.75, 0.625, 0.25), true },
    { soup.Points.front(), true }, { PointIn(soup, 0.5, 0.5, 0.5), true },
    { PointIn(soup, 2, 2, 2), true } };
  for (const bool constrain : { false, true })
  {
    SegmentMeshParameters parameters;
    parameters.ConstrainFacets = parameters.FillNonManifold = constrain;
    AddLabels(constrain ? "with constraints" : "alone", hull, seeds, parameters, hashes);
  }
  SegmentMeshParameters parameters;
  parameters.Topology.Regions.SeededRegions = true;
  AddLabels("seeded regions", hull, seeds, parameters, hashes);
}

void AddTopology(const TriangleSoup& soup, Hashes& hashes)
{
  const HullMesh hull = ExactHull(Twice(soup));
  const auto add = [&](const std::string& name, const auto& change)
  {
    SegmentMeshParameters parameters;
    change(parameters);
    AddLabels(name, hull, {}, parameters, hashes);
  };
  using Parameters = SegmentMeshParameters;
  add("as cut", [](Parameters&) {});
  add("by volume", [](Parameters& p) { p.Cut.DataTerm = DataTerm::VolumeWeighted; });
  add("smooth", [](Parameters& p) { p.Cut = { 10, 0.5, DataTerm::Uniform }; });
  add("threshold", [](Parameters& p) { p.Cut.Gamma = 0; });
  add("largest region", [](Parameters& p) { p.Topology.Regions.LargestRegions = 1; });
  add("filled cavities", [](Parameters& p) { p.Topology.Regions.FillCavities = true; });
  for (const bool isManifold : { false, true })
  {
    const std::string suffix = isManifold ? ", manifold" : "";
    const auto goal = [&](TopologyGoal wanted)
    {
      return [=](Parameters& p)
      {
        p.FillNonManifold = isManifold;
        p.Topology.Goal = wanted;
      };
    };
    add("one component" + suffix, goal(TopologyGoal::OneComponent));
    add("simply connected" + suffix, goal(TopologyGoal::SimplyConnected));
  }
}

void AddOutputs(const TriangleSoup& soup, Hashes& hashes)
{
  Monitor monitor;
  const HullMesh hull = ExactHull(soup);
  const TetrahedralMesh& mesh = hull.Mesh;
  const std::vector<unsigned char> inside = AddLabels("labels", hull, {}, {}, hashes);
  AddHull("hull", hull, hashes);

  const SolidRegions regions = FindRegions(mesh, inside, monitor, Progress);
  AddHash("regions", hashes, regions.OfCell, regions.Count);
  AddHash("masses", hashes, MeasureMass(mesh, inside), MeasureRegions(mesh, regions));
  const std::vector<BoundaryFace> faces = BoundaryFaces(mesh, inside, monitor, Progress);
  const SolidTopology topology = FindTopology(mesh, inside, faces, monitor, Progress);
  AddHash("topology", hashes, topology.Solid, topology.Boundary);
  const std::vector<OutlierPiece> outliers =
    OutlierPieces(hull.Surface, mesh, inside, monitor, Progress);
  AddHash("messages", hashes, WarningsAbout(MeasureLostArea(hull, outliers)), NothingInside(hull));

  const std::vector<BoundaryTriangle> boundary =
    BoundaryTriangles(hull.Surface, mesh, faces, monitor, Progress);
  const std::vector<Triangle> given = TrianglesInMesh(soup, hull.MergedInto, mesh.Origins);
  AddHash("merged pieces", hashes, MergePieces(boundary, given, monitor, Progress));
  std::vector<Id> alike(soup.Points.size());
  std::iota(alike.begin(), alike.end(), 0);
  const SeamedSurface seamed = SplitSeams(boundary, soup, given, alike, mesh, monitor, Progress);
  AddHash("split seams", hashes, seamed.Triangles, seamed.Places, seamed.Origins);

  std::array<std::vector<double>, 3> sides;
  for (const double part : { 0.0, 0.25, 0.5, 1.0 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      sides[axis].push_back(PointIn(soup, part, part, part)[axis]);
    }
  }
  AddHash("voxels of the hull", hashes,
    VoxelFractions(mesh.Points, mesh.Cells, sides, monitor, Progress));
}

void AddParting(const TriangleSoup& soup, Hashes& hashes)
{
  Monitor monitor;
  const HullMesh hull = ExactHull(soup);
  const std::vector<unsigned char> inside =
    SegmentMesh(hull.Mesh, hull.W, {}, {}, {}, monitor).Inside;
  PartedSolid solid = UnpartedSolid(hull.Mesh, inside);
  const OverlapCounts overlaps = SeparateOverlaps(hull.Surface, hull.W, solid, monitor, Progress);
  AddHash("overlaps", hashes, overlaps.Overlaps, overlaps.Separated, overlaps.CopiedCells,
    overlaps.Left, solid.Mesh.Cells, solid.Inside, solid.Places, solid.Originals);

  solid = UnpartedSolid(hull.Mesh, inside);
  PartPoints(solid, std::vector<unsigned char>(solid.Places.size(), 1), monitor, Progress);
  AddHash("points", hashes, solid.Mesh.Cells, solid.Inside, solid.Places, solid.Originals);
  const std::vector<BoundaryFace> faces =
    BoundaryFaces(solid.Mesh, solid.Inside, monitor, Progress);
  const ManifoldSurface manifold = ManifoldBoundary(solid, faces, monitor, Progress);
  AddHash("manifold boundary", hashes, faces, manifold.Triangles, manifold.Places,
    manifold.SharedPoints, manifold.LeftEdges);
}
