// SPDX-License-Identifier: GPL-3.0-or-later
#include "Boolean/BodyRegions.h"
#include "Boolean/CellsOfExpression.h"
#include "Boolean/FillGaps.h"
#include "Boolean/FindGaps.h"
#include "Boolean/SegmentBodies.h"
#include "Boolean/SurfaceOfExpression.h"
#include "Common/Stages.h"
#include "GraphCut/ConnectCells.h"
#include "HullMesh.h"
#include "Output/RegionBoundaries.h"
#include "Refine/QuadraticCells.h"
#include "Refine/RefineTetrahedra.h"
#include "Support/BodiesOfSoups.h"
#include "Support/Hash.h"
#include "Support/HashGroups.h"
#include "Support/TestMeshes.h"

using namespace insideout;

namespace
{
constexpr ProgressRange Progress = { Stages::Extracting, 0, 1 };

/** How wide the gap between two of the bodies is, over the surface's diagonal. */
constexpr double Gap = 0x1p-10;

/** The surface, a box that crosses it, and a box behind a narrow gap beside that one. */
std::vector<Body> BodiesWith(const TriangleSoup& soup)
{
  Point low = PointIn(soup, 0.375, 0.3125, 0.25);
  Point high = PointIn(soup, 1.125, 0.8125, 0.875);
  const TriangleSoup box = testmeshes::Box(low, high);
  const double width = high[0] - low[0];
  low[0] = high[0] + Gap * DiagonalOf(soup);
  high[0] = low[0] + width;
  return testmeshes::BodiesOf({ soup, box, testmeshes::Box(low, high) });
}

/** The bodies on one mesh, and what each of them is. */
struct MeshedBodies
{
  HullMesh Hull;
  BodySegmentation Cut;
};

MeshedBodies MeshBodiesWith(const TriangleSoup& soup, const HullMeshParameters& given = {})
{
  HullMeshParameters parameters = given;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  Monitor monitor;
  MeshedBodies meshed;
  meshed.Hull = MeshHull(BodiesWith(soup), parameters, monitor);
  std::vector<BodyToSegment> bodies;
  for (const std::vector<double>& w : meshed.Hull.WOfBodies)
  {
    bodies.push_back({ std::to_string(bodies.size()), w, {}, {} });
  }
  meshed.Cut = SegmentBodies(meshed.Hull.Mesh, bodies, {}, monitor);
  return meshed;
}

void AddRegions(
  const std::string& name, const TetrahedralMesh& mesh, const BodyRegions& found, Hashes& hashes)
{
  Monitor monitor;
  const RegionBoundaries boundaries = FindRegionBoundaries(mesh, found.Regions, monitor, Progress);
  AddHash(name, hashes, found.Regions.OfCell, found.Regions.Count, found.Bodies, boundaries.Faces,
    boundaries.Regions);
}

/** The inside cells alone, with their regions; faces on facets of the first body have label 1. */
struct Solid
{
  TetrahedralMesh Mesh;
  std::vector<Id> Regions;
  std::vector<std::array<Id, 4>> Labels;
};

Solid SolidOf(const MeshedBodies& meshed, Id trianglesOfFirst)
{
  Monitor monitor;
  const HullMesh& hull = meshed.Hull;
  const BodyRegions found =
    FindBodyRegions(meshed.Cut.Inside, RegionRule::All, {}, monitor, Progress);
  Solid solid;
  std::vector<Tetrahedron> cells;
  for (Id cell = 0; cell < hull.Mesh.NumberOfCells(); ++cell)
  {
    if (found.Regions.OfCell[cell] == None)
    {
      continue;
    }
    cells.push_back(hull.Mesh.Cells[cell]);
    solid.Regions.push_back(found.Regions.OfCell[cell]);
    std::array<Id, 4>& labels = solid.Labels.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      const Id facet = hull.Mesh.Facets[cell][k];
      labels[k] = facet != None && SourceOfFacet(hull.Surface, facet, 1) < trianglesOfFirst;
    }
  }
  solid.Mesh = ConnectCells(hull.Mesh.Points, std::move(cells));
  return solid;
}
} // namespace

void AddBodies(const TriangleSoup& soup, Hashes& hashes)
{
  Monitor monitor;
  MeshedBodies meshed = MeshBodiesWith(soup);
  const TetrahedralMesh& mesh = meshed.Hull.Mesh;
  AddHull("hull", meshed.Hull, hashes);
  AddHash("w of each", hashes, meshed.Hull.WOfBodies);
  AddHash("labels", hashes, meshed.Cut.Inside);
  AddHash("labels, figures", hashes, meshed.Cut.Statistics, meshed.Cut.Warnings);
  const std::vector<Id> priority = { 1, 0, 2 };
  for (const RegionRule rule : { RegionRule::Priority, RegionRule::All })
  {
    AddRegions(rule == RegionRule::All ? "all regions" : "regions by priority", mesh,
      FindBodyRegions(meshed.Cut.Inside, rule, priority, monitor, Progress), hashes);
  }
  const double tolerance = 2 * Gap * DiagonalOf(soup);
  const FilledGaps filled = FillGaps(mesh, tolerance, priority, meshed.Cut.Inside, monitor);
  AddHash("filled gaps", hashes, filled.Cells, filled.Volume, meshed.Cut.Inside);

  HullMeshParameters parameters;
  parameters.Chain.MergeTolerance = tolerance;
  AddHull("merged", MeshBodiesWith(soup, parameters).Hull, hashes);
}

void AddBooleans(const TriangleSoup& soup, Hashes& hashes)
{
  Monitor monitor;
  const ResolvedBodies bodies = ResolveBodies(BodiesWith(soup), {}, monitor);
  AddHash("resolved", hashes, bodies.Surface.Points, bodies.Surface.Origins, bodies.Surface.Facets,
    bodies.Surface.Multiplicity, bodies.Surface.Sources, bodies.MergedInto, bodies.TurnedTriangles);
  AddHash("counts", hashes, bodies.CountOffsets, bodies.BodyCounts);
  const double tolerance = 2 * Gap * DiagonalOf(soup);
  AddHash("has gaps", hashes, MayHaveGaps(bodies, tolerance, monitor));
  const std::vector<std::string> names = { "A", "B", "C" };
  for (const std::string text : { "A | B | C", "A & (B | C)", "A - B - C", "A ^ B ^ C" })
  {
    const SetExpression expression(text, names);
    const auto surface = SurfaceOfExpression(bodies, expression, monitor);
    AddHash(
      text + ", surface", hashes, surface ? surface->Boundary : std::vector<BoundaryTriangle>());
  }
  for (const double gaps : { 0.0, tolerance })
  {
    const CellsOfExpression cells =
      FindCellsOfExpression(bodies, names, SetExpression("A ^ B - C", names), gaps, monitor);
    const std::string name = gaps > 0 ? "cells, gaps filled" : "cells";
    AddHash(name, hashes, cells.Mesh.Points, cells.Mesh.Cells, cells.Inside, cells.Boundary);
    AddHash(name + ", figures", hashes, cells.Statistics, cells.Warnings);
  }
}

void AddRefinement(const TriangleSoup& soup, Hashes& hashes)
{
  const Solid solid = SolidOf(MeshBodiesWith(soup), static_cast<Id>(soup.Triangles.size()));
  using Treatment = std::pair<std::string, SurfaceTreatment>;
  for (const auto& [name, treatment] :
    { Treatment("kept", SurfaceTreatment::Kept), Treatment("split", SurfaceTreatment::Split),
      Treatment("remeshed", SurfaceTreatment::Remeshed) })
  {
    RefinementParameters parameters;
    parameters.Surface = treatment;
    parameters.Sizes.EdgeLength = DiagonalOf(soup) / 4;
    parameters.Sizes.Grading = 1;
    parameters.Labels = solid.Labels;
    Monitor monitor;
    const RefinedMesh refined = RefineTetrahedra(solid.Mesh, solid.Regions, parameters, monitor);
    AddHash(name, hashes, refined.Points, refined.Cells);
    AddHash(name + ", origins", hashes, refined.OriginalPoints, refined.OriginalCells,
      refined.OriginalFaces, refined.CellsOfPoints);
    AddHash(name + ", figures", hashes, refined.Statistics);
    const QuadraticCells quadratic =
      MakeQuadraticCells(static_cast<Id>(refined.Points.size()), refined.Cells);
    AddHash(name + ", second order", hashes, quadratic.Cells, quadratic.Edges);
  }
}
