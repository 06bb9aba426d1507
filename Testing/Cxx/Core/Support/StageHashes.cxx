// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/StageHashes.h"

#include "GraphCut/SegmentMesh.h"
#include "HullMesh.h"
#include "Quality/QualityOfMesh.h"
#include "Quality/SolidDefects.h"
#include "Support/Hash.h"
#include "WindingNumber/SurfaceWindingNumber.h"

using namespace insideout;

Hashes HashStages(const TriangleSoup& soup)
{
  constexpr ProgressRange progress = { "extracting", 0, 1 };
  Monitor monitor;
  Hashes hashes;
  const auto add = [&hashes](const std::string& name, const auto&... outputs)
  { AddHash(name, hashes, outputs...); };

  const SurfaceDefects defects = FindSurfaceDefects(soup, 0, Orientation::Automatic, monitor);
  add("defects", defects.Triangles, defects.Points, defects.Lines, defects.NearPoints);

  HullMeshParameters parameters;
  parameters.Budgets.Engine = TetrahedralizationEngine::Exact;
  const HullMesh hull = MeshHull(soup, parameters, monitor);
  const FacetComplex& surface = hull.Surface;
  add("resolved points", surface.Points, surface.Origins);
  add("resolved facets", surface.Facets, surface.Multiplicity, surface.Sources);
  add("points", hull.Mesh.Points, hull.Mesh.Origins);
  add("cells", hull.Mesh.Cells, hull.Mesh.Facets, hull.Mesh.FacetSides, hull.Mesh.LostFacets);
  add("w", hull.W);

  const std::vector<FacetPiece> pieces = PiecesOfFacets(hull.Mesh);
  std::vector<unsigned char> inside;
  for (const bool constrain : { true, false })
  {
    SegmentMeshParameters constraints;
    constraints.ConstrainFacets = constraints.FillNonManifold = constrain;
    inside = SegmentMesh(hull.Mesh, hull.W, pieces, {}, constraints, monitor).Inside;
    add(constrain ? "labels with constraints" : "labels", inside);
  }
  add("boundary",
    BoundaryTriangles(
      surface, hull.Mesh, BoundaryFaces(hull.Mesh, inside, monitor, progress), monitor, progress));
  add("outliers", OutlierPieces(surface, hull.Mesh, inside, monitor, progress));

  const SolidDefects solid = FindSolidDefects(hull.Mesh.Points, hull.Mesh.Cells, {}, monitor);
  add("solid defects", solid.Orientations, solid.Regions, solid.ContactPairs);
  const MeshQuality quality = QualityOfMesh(hull.Mesh.Points, hull.Mesh.Cells, monitor, progress);
  add("quality", quality.Histogram, quality.MinDihedralAngle, quality.DihedralAngle1Percent,
    quality.MaxRadiusEdgeRatio, quality.RadiusEdgeRatio99Percent, quality.AverageMeanRatio,
    quality.SurfaceEdgesUnder10Degrees);

  for (const WindingNumberMethod method : { WindingNumberMethod::Exact, WindingNumberMethod::Naive,
         WindingNumberMethod::Hierarchical, WindingNumberMethod::Approximate })
  {
    const SurfaceWindingNumber w(surface, { method }, monitor);
    add("w at points, method " + std::to_string(static_cast<int>(method)),
      w.At(hull.Mesh.Points, monitor));
  }
  return hashes;
}
