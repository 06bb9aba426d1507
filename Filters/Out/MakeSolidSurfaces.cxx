// SPDX-License-Identifier: GPL-3.0-or-later
#include "Out/MakeSolidSurfaces.h"

#include "Common/Stages.h"
#include "Out/TagByRules.h"
#include "Output/MergePieces.h"
#include "Output/RegionBoundaries.h"
#include "Output/Topology.h"

#include <vtkPolyData.h>

#include <algorithm>

namespace vtkInsideOut
{
using namespace insideout;

namespace
{
void CountOutliers(
  const HullMesh& hull, const std::vector<OutlierPiece>& pieces, Statistics& statistics)
{
  const auto count = [&](OutlierReason reason)
  {
    return std::count_if(pieces.begin(), pieces.end(),
      [&](const OutlierPiece& piece) { return piece.Reason == reason; });
  };
  statistics.emplace_back("OutlierFacets", pieces.size() + hull.DegenerateTriangles.size());
  statistics.emplace_back("OutliersByEnergy", count(OutlierReason::Energy));
  statistics.emplace_back("OutliersLost", count(OutlierReason::Lost));
  statistics.emplace_back("OutliersLeftOut", count(OutlierReason::LeftOut));
  statistics.emplace_back("OutliersDegenerate", hull.DegenerateTriangles.size());
}

/** Triangles of the boundary with the requested data, manifoldness aside. */
vtkSmartPointer<vtkPolyData> MakeBoundary(const KeptHull& kept,
  const std::vector<BoundaryTriangle>& boundary, bool splitSeams, MakeOutputs& outputs,
  Monitor& monitor)
{
  return splitSeams
    ? outputs.MakeSeamedBoundary(kept.Hull, boundary, monitor, { Stages::Extracting, 0.2, 0.3 })
    : outputs.MakeBoundary(kept.Hull, kept.Hull.Mesh, boundary);
}

/** The same triangles, or the input triangles that they are pieces of. */
std::vector<BoundaryTriangle> MergedIfAsked(const KeptHull& kept,
  std::vector<BoundaryTriangle> boundary, const BoundaryOptions& options, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  return options.MergePieces
    ? MergePieces(boundary, TrianglesInMesh(kept.Surface.Soup, hull.MergedInto, hull.Mesh.Origins),
        monitor, { Stages::Extracting, 0.1, 0.2 })
    : boundary;
}

/**
 * The solid's boundary, of one body without a name.
 *
 * @param[in] unparted the boundary in the hull: cells of a parted solid overlap
 */
vtkSmartPointer<vtkPolyData> MakeBoundary(const KeptHull& kept,
  const std::vector<BoundaryFace>& unparted, const Parting* parted, const BoundaryOptions& options,
  MakeOutputs& outputs, Statistics& counts, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const TetrahedralMesh& mesh = parted ? parted->Solid.Mesh : hull.Mesh;
  const std::vector<BoundaryFace> faces = parted
    ? BoundaryFaces(mesh, parted->Solid.Inside, monitor, { Stages::Extracting, 0.05, 0.05 })
    : unparted;
  const std::vector<BoundaryTriangle> boundary = MergedIfAsked(kept,
    BoundaryTriangles(hull.Surface, mesh, faces, monitor, { Stages::Extracting, 0.05, 0.1 }),
    options, monitor);
  monitor.Check(Stages::Extracting, 0.2);
  if (options.IsManifold)
  {
    const ManifoldSurface manifold =
      ManifoldBoundary(parted->Solid, faces, monitor, { Stages::Extracting, 0.2, 0.3 });
    TellOfSharedPoints(manifold, counts, outputs.Warnings);
    return outputs.MakeManifoldBoundary(hull, mesh, manifold, boundary);
  }
  return parted ? outputs.MakeBoundary(hull, mesh, boundary)
                : MakeBoundary(kept, boundary, options.SplitSeams, outputs, monitor);
}

/** The boundary of the solid and the interfaces between its regions, tagged by the surface, or by
 * the regions' bodies. */
vtkSmartPointer<vtkPolyData> MakeBoundaryOfRegions(const KeptHull& kept, const BodyRegions& regions,
  bool tagBodies, const Tags& tags, MakeOutputs& outputs, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const RegionBoundaries boundaries =
    FindRegionBoundaries(hull.Mesh, regions.Regions, monitor, { Stages::Extracting, 0, 0.1 });
  vtkSmartPointer<vtkPolyData> boundary = outputs.MakeBoundary(hull.Mesh.Points, hull.Mesh.Origins,
    BoundaryTriangles(
      hull.Surface, hull.Mesh, boundaries.Faces, monitor, { Stages::Extracting, 0.1, 0.2 }),
    hull.TurnedTriangles, { "Turned", "BoundaryTag", "RegionIds" });
  AddRegionIds(boundaries, boundary);
  if (kept.Bodies.AreNamed())
  {
    AddRegionTags(boundaries, NamesOfRegions(regions, kept.Bodies.Names),
      tagBodies ? &tags : nullptr, boundary);
  }
  else
  {
    AddTags(tags, boundary);
  }
  return boundary;
}

/** Output 2 and lost areas, and the points on seams. */
void AddOutliers(const HullMesh& hull, const std::vector<OutlierPiece>& outliers,
  MakeOutputs& outputs, Monitor& monitor, SolidSurfaces& surfaces)
{
  surfaces.Counts.emplace_back("SeamPoints", outputs.CountSeamPoints(hull));
  monitor.Check(Stages::Extracting, 0.35);
  surfaces.Outliers = outputs.MakeOutliers(hull, outliers);
  monitor.Check(Stages::Extracting, 0.4);
  CountOutliers(hull, outliers, surfaces.Counts);
  surfaces.Lost = MeasureLostArea(hull, outliers);
  surfaces.Counts.emplace_back("LostShare", surfaces.Lost.Share);
}
void AddRuledTags(const BoundaryOptions& options, MakeOutputs& outputs, vtkPolyData* boundary)
{
  const std::vector<std::string> warnings = TagByRules(options.TagRules, boundary);
  outputs.Warnings.insert(outputs.Warnings.end(), warnings.begin(), warnings.end());
}
} // namespace

SolidSurfaces MakeSolidSurfaces(const KeptHull& kept, const SegmentedHull& segmented,
  const Parting* parted, const BoundaryOptions& options, const Tags& tags, MakeOutputs& outputs,
  Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const std::vector<unsigned char>& inside = segmented.All.Inside;
  const ProgressRange findingOutliers = { Stages::Extracting, 0.3, 0.35 };
  SolidSurfaces surfaces;
  const std::vector<BoundaryFace> faces =
    BoundaryFaces(hull.Mesh, inside, monitor, { Stages::Extracting, 0, 0.05 });
  AppendTopology(
    FindTopology(hull.Mesh, inside, faces, monitor, { Stages::Extracting, 0.05, 0.05 }),
    surfaces.Counts);
  if (segmented.HasInterfaces)
  {
    surfaces.Boundary =
      MakeBoundaryOfRegions(kept, segmented.Regions, options.TagBodies, tags, outputs, monitor);
  }
  else
  {
    surfaces.Boundary =
      MakeBoundary(kept, faces, parted, options, outputs, surfaces.Counts, monitor);
    AddTags(tags, surfaces.Boundary);
  }
  AddRuledTags(options, outputs, surfaces.Boundary);
  const std::vector<OutlierPiece> outliers = kept.Bodies.AreNamed()
    ? OutlierPieces(hull.Surface, hull.Mesh, IsInOwnBody(hull, kept.Bodies, segmented.InBodies),
        monitor, findingOutliers)
    : OutlierPieces(hull.Surface, hull.Mesh, inside, monitor, findingOutliers);
  AddOutliers(hull, outliers, outputs, monitor, surfaces);
  return surfaces;
}

SolidSurfaces MakeRepairedSurfaces(const KeptHull& kept, const ExpressionSurface& repaired,
  const BoundaryOptions& options, const Tags& tags, MakeOutputs& outputs, Monitor& monitor)
{
  SolidSurfaces surfaces;
  surfaces.Counts.emplace_back("Volume", VolumeWithin(kept.Hull.Mesh.Points, repaired.Boundary));
  surfaces.Boundary = MakeBoundary(kept, MergedIfAsked(kept, repaired.Boundary, options, monitor),
    options.SplitSeams, outputs, monitor);
  AddTags(tags, surfaces.Boundary);
  AddRuledTags(options, outputs, surfaces.Boundary);
  AddOutliers(kept.Hull, repaired.Outliers, outputs, monitor, surfaces);
  return surfaces;
}
} // namespace vtkInsideOut
