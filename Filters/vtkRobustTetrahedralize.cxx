// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "Common/Stages.h"
#include "LostArea.h"
#include "NothingInside.h"
#include "Output/MassProperties.h"
#include "Output/MergePieces.h"
#include "Output/Topology.h"
#include "Private/vtkInsideOutBodies.h"
#include "Private/vtkInsideOutCache.h"
#include "Private/vtkInsideOutMakeOutputs.h"
#include "Private/vtkInsideOutMakeTriangles.h"
#include "Private/vtkInsideOutMonitor.h"
#include "Private/vtkInsideOutOptions.h"
#include "Private/vtkInsideOutPart.h"
#include "Private/vtkInsideOutReadCurve.h"
#include "Private/vtkInsideOutRefine.h"
#include "Private/vtkInsideOutRun.h"
#include "Private/vtkInsideOutSeedsPort.h"
#include "Private/vtkInsideOutTags.h"
#include "Private/vtkInsideOutWholeInput.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <tuple>

using namespace insideout;

vtkStandardNewMacro(vtkRobustTetrahedralize);

namespace
{
/** What of an input decides about the hull: the names of arrays; of blocks that are bodies their
 * names, and when the last was modified, which a composite data set does not tell. */
struct ArrayNames
{
  std::string NonParticipating;
  std::string Bodies;
  std::vector<std::string> BlockNames;
  vtkMTimeType BlocksTime = 0;
};

/** What decides about the hull, to be compared. Does not compile once a parameter is added: it may
 * not be missing here. */
auto AsTuple(const HullMeshParameters& parameters, const ArrayNames& names)
{
  const auto& [chain, orientation, thicken, budgets, quadratureOrder] = parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  const auto& [width, all] = thicken;
  const auto& [seconds, mebibytes, engine] = budgets;
  const auto& [nonParticipating, bodies, blockNames, blocksTime] = names;
  return std::make_tuple(mergeTolerance, countDuplicates, orientation, width, all, seconds,
    mebibytes, engine, quadratureOrder, nonParticipating, bodies, blockNames, blocksTime);
}

/** An input as one surface, and what of it decides about the hull. */
struct OneSurface
{
  vtkSmartPointer<vtkPolyData> Polygons;
  ArrayNames Names;
  std::vector<std::string> Warnings;
};

OneSurface ReadInput(vtkRobustTetrahedralize* filter, vtkDataObject* given)
{
  OneSurface input = { vtkPolyData::SafeDownCast(given),
    { filter->GetNonParticipatingArrayName(), filter->GetBodyArrayName(), {}, 0 }, {} };
  if (filter->GetBlocksAreBodies())
  {
    vtkInsideOutRefuseSpreadParts(filter);
    input.Polygons = vtkInsideOutJoinBlocks(given, input.Warnings);
    ArrayNames& names = input.Names;
    names.Bodies = vtkInsideOutBodyIds;
    vtkInsideOutVisitBlocks(given,
      [&](vtkDataObject* block, const std::string& name)
      {
        names.BlockNames.push_back(name);
        names.BlocksTime = std::max(names.BlocksTime, block->GetMTime());
      });
  }
  return input;
}

auto AsTuple(const PlanarHullParameters& parameters, const std::string& nonParticipating)
{
  const auto& [chain, orientation] = parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  return std::make_tuple(mergeTolerance, countDuplicates, orientation, nonParticipating);
}

/** The hull of an input, which the segmentation does not change. */
struct HullOfInput
{
  HullOfInput(vtkPolyData* input, const HullMeshParameters& parameters, const ArrayNames& names,
    Monitor& monitor)
    : Surface(vtkInsideOutReadSurface(ShallowCopyOf(input), names.NonParticipating))
    , Outputs(this->Surface)
    , Bodies(vtkInsideOutReadBodies(this->Surface, names.Bodies))
  {
    if (this->Bodies.AreThere())
    {
      HullOfBodies hull =
        MeshBodies(SplitBodies(this->Surface.Soup, this->Bodies.OfTriangle, this->Bodies.Names),
          parameters, monitor);
      this->Hull = std::move(hull.Whole);
      this->WOfBodies = std::move(hull.W);
    }
    else
    {
      this->Hull = MeshHull(this->Surface.Soup, parameters, monitor);
    }
    this->Grid = this->Outputs.MakeGrid(this->Hull);
    if (this->Bodies.AreThere())
    {
      vtkInsideOutAddBodyW(this->WOfBodies, this->Bodies.Names, this->Grid);
    }
  }

  static vtkSmartPointer<vtkPolyData> ShallowCopyOf(vtkPolyData* input)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(input);
    return copy;
  }

  vtkInsideOutSurface Surface;
  vtkInsideOutMakeOutputs Outputs; ///< to be copied: each run has warnings of its own
  vtkInsideOutBodies Bodies;
  HullMesh Hull;
  std::vector<std::vector<double>> WOfBodies; ///< where there are bodies
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
};

/** What is inside, and the regions of that. */
struct Segmented
{
  MeshSegmentation All;                             ///< inside any body
  std::vector<std::vector<unsigned char>> InBodies; ///< where there are bodies
  BodyRegions Regions;
};
} // namespace

class vtkRobustTetrahedralize::Cache
  : public vtkInsideOutCache<decltype(AsTuple(std::declval<HullMeshParameters>(), ArrayNames())),
      HullOfInput>
{
};

/** The same in two dimensions. */
struct vtkRobustTetrahedralize::HullInAPlane
{
  HullInAPlane(vtkPolyData* input, const PlanarHullParameters& parameters,
    const std::string& nonParticipating, Monitor& monitor)
    : Curve(vtkInsideOutReadCurve(
        HullOfInput::ShallowCopyOf(input), parameters.Orientation, nonParticipating))
    , Hull(vtkInsideOutMeshPlanarHull(this->Curve, parameters, monitor))
  {
  }

  vtkInsideOutCurve Curve;
  PlanarHull Hull;
};

class vtkRobustTetrahedralize::CacheInAPlane
  : public vtkInsideOutCache<decltype(AsTuple(std::declval<PlanarHullParameters>(), std::string())),
      HullInAPlane>
{
};

vtkRobustTetrahedralize::vtkRobustTetrahedralize()
  : Hulls(new Cache)
  , HullsInAPlane(new CacheInAPlane)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  const SegmentMeshParameters segment;
  this->Gamma = segment.Cut.Gamma;
  this->Sigma = segment.Cut.Sigma;
  this->DataTerm = static_cast<int>(segment.Cut.DataTerm);
  this->ConstrainFacets = segment.ConstrainFacets;
  const HullMeshParameters hull;
  this->Orientation = static_cast<int>(hull.Orientation);
  this->Thicken = hull.Thicken.Width;
  this->ThickenAll = hull.Thicken.All;
  this->MergeTolerance = hull.Chain.MergeTolerance;
  this->CountDuplicates = hull.Chain.CountDuplicates;
  this->QuadratureOrder = hull.QuadratureOrder;
  this->Engine = static_cast<int>(hull.Budgets.Engine);
  this->TimeBudget = hull.Budgets.TimeBudget;
  this->MemoryBudget = hull.Budgets.MemoryBudget;
  const RefinementParameters refining;
  this->EdgeLength = refining.Sizes.EdgeLength;
  this->Grading = refining.Sizes.Grading;
  this->MaximumVolume = refining.Sizes.MaximumVolume;
  this->Surface = static_cast<int>(refining.Surface);
  this->SurfaceTolerance = refining.SurfaceTolerance;
  this->FeatureAngle = refining.FeatureAngle;
}

vtkRobustTetrahedralize::~vtkRobustTetrahedralize() = default;

void vtkRobustTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimension: " << this->Dimension << "\n";
  os << indent << "Gamma: " << this->Gamma << "\n";
  os << indent << "Sigma: " << this->Sigma << "\n";
  os << indent << "DataTerm: " << this->DataTerm << "\n";
  os << indent << "ConstrainFacets: " << this->ConstrainFacets << "\n";
  os << indent << "NonManifold: " << this->NonManifold << "\n";
  os << indent << "SeparateOverlaps: " << this->SeparateOverlaps << "\n";
  os << indent << "ConstrainedFacetsArrayName: " << this->ConstrainedFacetsArrayName << "\n";
  os << indent << "ExtractInside: " << this->ExtractInside << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "Thicken: " << this->Thicken << "\n";
  os << indent << "ThickenAll: " << this->ThickenAll << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "MergeCoplanarPieces: " << this->MergeCoplanarPieces << "\n";
  os << indent << "SplitSeams: " << this->SplitSeams << "\n";
  os << indent << "TagArrayName: " << this->TagArrayName << "\n";
  os << indent << "BodyArrayName: " << this->BodyArrayName << "\n";
  os << indent << "BlocksAreBodies: " << this->BlocksAreBodies << "\n";
  os << indent << "RegionRule: " << this->RegionRule << "\n";
  os << indent << "Priority: " << this->Priority << "\n";
  os << indent << "QuadratureOrder: " << this->QuadratureOrder << "\n";
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
  os << indent << "Refine: " << this->Refine << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "Grading: " << this->Grading << "\n";
  os << indent << "MaximumVolume: " << this->MaximumVolume << "\n";
  os << indent << "Surface: " << this->Surface << "\n";
  os << indent << "SurfaceTolerance: " << this->SurfaceTolerance << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "QuadraticCells: " << this->QuadraticCells << "\n";
}

int vtkRobustTetrahedralize::FillInputPortInformation(int port, vtkInformation* info)
{
  return vtkInsideOutFillPort(port, info, "vtkPolyData");
}

void vtkRobustTetrahedralize::SetBlocksAreBodies(bool blocksAreBodies)
{
  if (this->BlocksAreBodies == blocksAreBodies)
  {
    return;
  }
  this->BlocksAreBodies = blocksAreBodies;
  // VTK takes a composite data set to blocks where the filter does not take it as it is.
  vtkInformation* port = this->GetInputPortInformation(0);
  port->Remove(INPUT_REQUIRED_DATA_TYPE());
  port->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (blocksAreBodies)
  {
    port->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  this->Modified();
}

void vtkRobustTetrahedralize::SetSeedsData(vtkPointSet* seeds)
{
  this->SetInputData(1, seeds);
}

void vtkRobustTetrahedralize::SetSeedsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

int vtkRobustTetrahedralize::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

vtkPolyData* vtkRobustTetrahedralize::GetBoundary()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkRobustTetrahedralize::GetOutliers()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

namespace
{
std::vector<std::string> StagesWith(bool refine)
{
  std::vector<std::string> stages = { Stages::Validating, Stages::Orienting,
    Stages::FindingIntersections, Stages::Resolving, Stages::Tetrahedralizing,
    Stages::WindingNumbers, Stages::Segmenting, Stages::Extracting };
  if (refine)
  {
    stages.emplace_back(Stages::Refining);
  }
  return stages;
}

/** Outputs 1 and 2, and their counts. */
struct Surfaces
{
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Outliers;
  Statistics Counts;
  LostArea Lost;
};

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

/** What the points and triangles of the boundary are to be. */
struct BoundaryOptions
{
  bool MergePieces;
  bool SplitSeams;
  bool IsManifold;
};

/**
 * The solid's boundary, of one body.
 *
 * @param[in] parted the solid that was parted from the hull, or null
 */
vtkSmartPointer<vtkPolyData> MakeBoundary(const HullMesh& hull,
  const std::vector<unsigned char>& inside, const vtkInsideOutParting* parted,
  const BoundaryOptions& options, const TriangleSoup& soup, vtkInsideOutMakeOutputs& outputs,
  Statistics& counts, Monitor& monitor)
{
  const TetrahedralMesh& mesh = parted ? parted->Solid.Mesh : hull.Mesh;
  const std::vector<BoundaryFace> faces = BoundaryFaces(
    mesh, parted ? parted->Solid.Inside : inside, monitor, { Stages::Extracting, 0, 0.05 });
  // Of the hull's cells: those of a parted solid overlap.
  const std::vector<BoundaryFace> unparted =
    parted ? BoundaryFaces(hull.Mesh, inside, monitor, { Stages::Extracting, 0.05, 0.05 }) : faces;
  AppendTopology(
    FindTopology(hull.Mesh, inside, unparted, monitor, { Stages::Extracting, 0.05, 0.05 }), counts);
  std::vector<BoundaryTriangle> boundary =
    BoundaryTriangles(hull.Surface, mesh, faces, monitor, { Stages::Extracting, 0.05, 0.1 });
  if (options.MergePieces)
  {
    boundary = MergePieces(boundary, TrianglesInMesh(soup, hull.MergedInto, hull.Mesh), monitor,
      { Stages::Extracting, 0.1, 0.2 });
  }
  monitor.Check(Stages::Extracting, 0.2);
  if (options.IsManifold)
  {
    const ManifoldSurface manifold =
      ManifoldBoundary(parted->Solid, faces, monitor, { Stages::Extracting, 0.2, 0.3 });
    vtkInsideOutTellOfSharedPoints(manifold, counts, outputs.Warnings);
    return outputs.MakeManifoldBoundary(hull, mesh, manifold, boundary);
  }
  return options.SplitSeams
    ? outputs.MakeSeamedBoundary(hull, boundary, monitor, { Stages::Extracting, 0.2, 0.3 })
    : outputs.MakeBoundary(hull, mesh, boundary);
}

/** The boundary of several bodies and the interfaces between their regions, with tags. */
vtkSmartPointer<vtkPolyData> MakeBoundaryOfBodies(const HullMesh& hull, const BodyRegions& regions,
  const std::vector<std::string>& names, const vtkInsideOutTags* tags,
  vtkInsideOutMakeOutputs& outputs, Monitor& monitor)
{
  const RegionBoundaries boundaries =
    FindRegionBoundaries(hull.Mesh, regions.Regions, monitor, { Stages::Extracting, 0, 0.1 });
  vtkSmartPointer<vtkPolyData> boundary = outputs.MakeBoundary(hull.Mesh.Points, hull.Mesh.Origins,
    BoundaryTriangles(
      hull.Surface, hull.Mesh, boundaries.Faces, monitor, { Stages::Extracting, 0.1, 0.2 }),
    hull.TurnedTriangles, { "Turned", "BoundaryTag", "RegionIds" });
  vtkInsideOutAddRegionTags(boundaries, NamesOfRegions(regions, names), tags, boundary);
  return boundary;
}

/** Output 2, and what is lost. */
void AddOutliers(const HullMesh& hull, const std::vector<OutlierPiece>& outliers,
  vtkInsideOutMakeOutputs& outputs, Monitor& monitor, Surfaces& surfaces)
{
  monitor.Check(Stages::Extracting, 0.35);
  surfaces.Outliers = outputs.MakeOutliers(hull, outliers);
  monitor.Check(Stages::Extracting, 0.4);
  CountOutliers(hull, outliers, surfaces.Counts);
  surfaces.Lost = MeasureLostArea(hull, outliers);
  surfaces.Counts.emplace_back("LostShare", surfaces.Lost.Share);
}

/** The solid with copies of cells where it overlaps itself, and of points where it touches itself.
 */
vtkInsideOutParting Part(const HullMesh& hull, const std::vector<unsigned char>& inside,
  bool separateOverlaps, bool splitPoints, Monitor& monitor)
{
  vtkInsideOutParting parting;
  parting.Solid = UnpartedSolid(hull.Mesh, inside);
  if (separateOverlaps)
  {
    vtkInsideOutSeparateOverlaps(hull, parting, monitor, { Stages::Extracting, 0, 0 });
  }
  if (splitPoints)
  {
    vtkInsideOutSplitPoints(parting, monitor, { Stages::Extracting, 0, 0 });
  }
  return parting;
}

/** The solid's cells with their regions, and what it and each of these weigh. */
struct Solid
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<MassProperties> Masses; ///< of the regions
  MassProperties Mass;
  Statistics Counts;
};

Solid MakeSolid(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  const SolidRegions& regions, vtkUnstructuredGrid* grid, bool extractInside, Monitor& monitor)
{
  Solid solid;
  solid.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  solid.Grid->ShallowCopy(grid);
  vtkInsideOutAddInside(inside, solid.Grid);
  vtkInsideOutAddRegions(regions, solid.Grid);
  if (extractInside)
  {
    solid.Grid = vtkInsideOutExtractInside(solid.Grid, monitor, { Stages::Extracting, 0.45, 1 });
  }
  const auto insideCells = std::count(inside.begin(), inside.end(), 1);
  if (insideCells > 0)
  {
    solid.Masses = MeasureRegions(mesh, regions);
  }
  solid.Counts.emplace_back("InsideCells", insideCells);
  solid.Counts.emplace_back("Regions", regions.Count);
  solid.Mass = solid.Masses.size() == 1 ? solid.Masses.front() : MeasureMass(mesh, inside);
  return solid;
}

/** What the cut goes by. */
struct SegmentOptions
{
  SegmentMeshParameters Parameters;
  std::string ConstrainedFacetsArray;
  RegionRule Rule;
  std::string Priority;
};

/** @param[in] points that the seeds were read from, or null */
Segmented CutHull(const HullOfInput& kept, const std::vector<Seed>& given, vtkPointSet* points,
  const SegmentOptions& options, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const std::vector<unsigned char> chosen =
    vtkInsideOutReadChosenFacets(kept.Surface, options.ConstrainedFacetsArray, hull.Surface);
  const ProgressRange findingRegions = { Stages::Extracting, 0, 0 };
  Segmented segmented;
  if (!kept.Bodies.AreThere())
  {
    segmented.All = SegmentMesh(
      hull.Mesh, hull.W, PiecesOfFacets(hull.Mesh, chosen), given, options.Parameters, monitor);
    segmented.Regions.Regions =
      FindRegions(hull.Mesh, segmented.All.Inside, monitor, findingRegions);
    return segmented;
  }
  const std::vector<std::string>& names = kept.Bodies.Names;
  const std::vector<Id> priority = PriorityOf(names, vtkInsideOutSplitNames(options.Priority));
  const std::vector<std::vector<Seed>> seeds = vtkInsideOutSeedsOfBodies(given, points, names);
  const std::vector<std::vector<FacetPiece>> pieces =
    vtkInsideOutPiecesOfBodies(hull, kept.Bodies, chosen);
  std::vector<BodyToSegment> bodies;
  for (std::size_t b = 0; b < names.size(); ++b)
  {
    bodies.push_back({ names[b], kept.WOfBodies[b], pieces[b], seeds[b] });
  }
  BodySegmentation found = SegmentBodies(hull.Mesh, bodies, options.Parameters, monitor);
  segmented.InBodies = std::move(found.Inside);
  segmented.All.Statistics = std::move(found.Statistics);
  segmented.All.Warnings = std::move(found.Warnings);
  segmented.Regions =
    FindBodyRegions(segmented.InBodies, options.Rule, priority, monitor, findingRegions);
  for (const Id region : segmented.Regions.Regions.OfCell)
  {
    segmented.All.Inside.push_back(region != None);
  }
  return segmented;
}

/** Outputs 1 and 2 of one body. */
Surfaces MakeSurfaces(const HullOfInput& kept, const std::vector<unsigned char>& inside,
  const vtkInsideOutParting* parted, const BoundaryOptions& options, const vtkInsideOutTags& tags,
  vtkInsideOutMakeOutputs& outputs, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  Surfaces surfaces;
  surfaces.Boundary = MakeBoundary(
    hull, inside, parted, options, kept.Surface.Soup, outputs, surfaces.Counts, monitor);
  vtkInsideOutAddTags(tags, surfaces.Boundary);
  surfaces.Counts.emplace_back("SeamPoints", outputs.CountSeamPoints(hull));
  AddOutliers(hull,
    OutlierPieces(hull.Surface, hull.Mesh, inside, monitor, { Stages::Extracting, 0.3, 0.35 }),
    outputs, monitor, surfaces);
  return surfaces;
}

/** Outputs 1 and 2 of several bodies. @param[in] tags of the surface, or null */
Surfaces MakeSurfacesOfBodies(const HullOfInput& kept, const Segmented& segmented,
  const vtkInsideOutTags* tags, vtkInsideOutMakeOutputs& outputs, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const std::vector<unsigned char>& inside = segmented.All.Inside;
  const ProgressRange lookingAtTopology = { Stages::Extracting, 0, 0 };
  Surfaces surfaces;
  AppendTopology(
    FindTopology(hull.Mesh, inside, BoundaryFaces(hull.Mesh, inside, monitor, lookingAtTopology),
      monitor, lookingAtTopology),
    surfaces.Counts);
  surfaces.Boundary =
    MakeBoundaryOfBodies(hull, segmented.Regions, kept.Bodies.Names, tags, outputs, monitor);
  surfaces.Counts.emplace_back("SeamPoints", outputs.CountSeamPoints(hull));
  AddOutliers(hull,
    OutlierPieces(hull.Surface, hull.Mesh,
      vtkInsideOutIsInOwnBody(hull, kept.Bodies, segmented.InBodies), monitor,
      { Stages::Extracting, 0.3, 0.35 }),
    outputs, monitor, surfaces);
  return surfaces;
}

/** The grid of all cells, with where bodies are. */
vtkSmartPointer<vtkUnstructuredGrid> GridOf(const HullOfInput& kept, const Segmented& segmented)
{
  if (!kept.Bodies.AreThere())
  {
    return kept.Grid;
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(kept.Grid);
  vtkInsideOutAddBodies(kept.Bodies, segmented.InBodies, segmented.Regions, kept.Hull.Mesh, grid);
  return grid;
}

Solid MakeSolid(const HullOfInput& kept, const Segmented& segmented,
  const vtkInsideOutParting* parted, bool extractInside, Monitor& monitor)
{
  if (!parted)
  {
    return MakeSolid(kept.Hull.Mesh, segmented.All.Inside, segmented.Regions.Regions,
      GridOf(kept, segmented), extractInside, monitor);
  }
  const TetrahedralMesh& mesh = parted->Solid.Mesh;
  const SolidRegions regions =
    FindRegions(mesh, parted->Solid.Inside, monitor, { Stages::Extracting, 0.4, 0.45 });
  return MakeSolid(mesh, parted->Solid.Inside, regions,
    vtkInsideOutMakePartedGrid(kept.Grid, *parted), true, monitor);
}

/** Refine the solid, and its boundary with it. */
vtkInsideOutRefinement RefineSolid(const RefinementParameters& parameters, bool quadratic,
  Solid& solid, Surfaces& surfaces, Monitor& monitor)
{
  vtkInsideOutRefinement refinement =
    vtkInsideOutRefine(solid.Grid, surfaces.Boundary, parameters, quadratic, monitor);
  solid.Grid = refinement.Grid;
  surfaces.Boundary = refinement.Boundary;
  if (parameters.Surface == SurfaceTreatment::Remeshed)
  {
    refinement.Masses.resize(solid.Masses.size()); // the last regions may have no cell
    solid.Masses = refinement.Masses;
    solid.Mass = refinement.Mass;
  }
  return refinement;
}

void Append(const Statistics& more, Statistics& statistics)
{
  statistics.insert(statistics.end(), more.begin(), more.end());
}
} // namespace

int vtkRobustTetrahedralize::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOutRequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

void vtkRobustTetrahedralize::MakeTriangles(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  std::vector<std::string> stages = { Stages::Validating, Stages::Resolving, Stages::Triangulating,
    Stages::Orienting, Stages::WindingNumbers, Stages::Segmenting, Stages::Extracting };
  if (this->Refine)
  {
    stages.emplace_back(Stages::Refining);
  }
  vtkInsideOutMonitor monitor(this, stages);
  if (this->Refine && this->QuadraticCells)
  {
    throw Error(ErrorCode::InvalidParameter,
      "QuadraticCells makes tetrahedra only, and the input lies in a plane");
  }
  if (this->SeparateOverlaps)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the input lies in a plane, where SeparateOverlaps does nothing: it separates tetrahedra");
  }
  this->CheckOptions();
  const std::vector<Seed> seeds = vtkInsideOutReadSeeds(inputVector);
  const vtkInsideOutTags tags =
    vtkInsideOutReadTags(input, this->TagArrayName, vtkInsideOutFindBlocks(this));
  vtkInsideOutPlanarOptions options;
  options.Segment = vtkInsideOutSegmentMeshParameters(this);
  options.ConstrainedArray = this->ConstrainedFacetsArrayName;
  options.ExtractInside = this->ExtractInside;
  options.Refine = this->Refine;
  options.Refinement = vtkInsideOutRefinementParameters(this);
  options.SplitPoints = this->NonManifold == NONMANIFOLD_SPLIT;
  PlanarHullParameters parameters;
  parameters.Chain = vtkInsideOutChainParameters(this);
  parameters.Orientation = vtkInsideOutOrientation(this);
  const std::string& nonParticipating = this->NonParticipatingArrayName;
  const std::shared_ptr<HullInAPlane> kept = this->HullsInAPlane->Get(input,
    AsTuple(parameters, nonParticipating),
    [&]() { return std::make_shared<HullInAPlane>(input, parameters, nonParticipating, monitor); });
  if (this->GetReleaseDataFlag())
  {
    this->HullsInAPlane->Forget();
  }
  const vtkInsideOutTriangles triangles =
    vtkInsideOutMakeTriangles(kept->Curve, kept->Hull, seeds, tags, options, monitor);
  vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(triangles.Grid);
  vtkPolyData::GetData(outputVector, 1)->ShallowCopy(triangles.Boundary);
  vtkPolyData::GetData(outputVector, 2)->ShallowCopy(triangles.Outliers);
  if (this->Dimension == DIMENSION_AUTOMATIC)
  {
    vtkInsideOutWarn(this, { vtkInsideOutTwoDimensions(kept->Curve) });
  }
  vtkInsideOutWarn(this, triangles.Warnings);
  if (this->Thicken > 0)
  {
    vtkWarningMacro(<< "Thicken does nothing in two dimensions");
  }
}

/** Whether the solid is more than a choice of the hull's cells. */
bool vtkRobustTetrahedralize::PartsSolid()
{
  return this->NonManifold == NONMANIFOLD_SPLIT || this->SeparateOverlaps;
}

void vtkRobustTetrahedralize::CheckOptions()
{
  const auto refuse = [](const std::string& words)
  { throw Error(ErrorCode::InvalidParameter, words); };
  const std::string parting =
    this->SeparateOverlaps ? "SeparateOverlaps" : "NonManifold of the kind Split";
  const bool changesPieces = this->MergeCoplanarPieces || this->SplitSeams;
  const std::string pieces = this->MergeCoplanarPieces ? "MergeCoplanarPieces" : "SplitSeams";
  if (this->Refine && !this->ExtractInside)
  {
    refuse("Refine takes ExtractInside: of the hull only the solid can be refined");
  }
  if (this->PartsSolid() && !this->ExtractInside)
  {
    refuse(parting + " takes ExtractInside: of the hull only the solid can be parted");
  }
  if (this->PartsSolid() && changesPieces)
  {
    refuse(pieces + " does not go together with " + parting);
  }
  if (this->Refine && this->Surface != KEPT && (this->PartsSolid() || changesPieces))
  {
    refuse((changesPieces ? pieces : parting) +
      " takes a surface that is kept where the solid is refined");
  }
}

void vtkRobustTetrahedralize::CheckBodies(bool isPlanar)
{
  using insideout::RegionRule;
  static_assert(BY_PRIORITY == static_cast<int>(RegionRule::Priority));
  static_assert(ALL == static_cast<int>(RegionRule::All));
  const bool areThere = this->BlocksAreBodies || !this->BodyArrayName.empty();
  const std::string option = this->BlocksAreBodies ? "BlocksAreBodies" : "BodyArrayName";
  if (this->BlocksAreBodies && !this->BodyArrayName.empty())
  {
    throw Error(ErrorCode::InvalidParameter,
      "BlocksAreBodies and BodyArrayName both say what is a body: set one of them");
  }
  if (areThere && isPlanar)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the input lies in a plane, where " + option + " has no meaning: bodies are in space");
  }
  if (areThere && (this->MergeCoplanarPieces || this->SplitSeams || this->PartsSolid()))
  {
    const std::string parting =
      this->SeparateOverlaps ? "SeparateOverlaps" : "NonManifold of the kind Split";
    throw Error(ErrorCode::InvalidParameter,
      (this->MergeCoplanarPieces ? "MergeCoplanarPieces"
          : this->SplitSeams     ? "SplitSeams"
                                 : parting) +
        " takes one body: it would part interfaces from their cells");
  }
}

int vtkRobustTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkInsideOutRunOnWhole(this, outputVector,
    [&]()
    {
      vtkDataObject* given = vtkDataObject::GetData(inputVector[0]);
      const auto [input, names, inputWarnings] = ReadInput(this, given);
      const bool isPlanar =
        vtkInsideOutDimensionOf(input, this->Dimension, this->Thicken > 0) == DIMENSION_2;
      this->CheckBodies(isPlanar);
      if (isPlanar)
      {
        this->MakeTriangles(inputVector, outputVector);
        return;
      }
      vtkInsideOutMonitor monitor(this, StagesWith(this->Refine));
      this->CheckOptions();
      const std::vector<Seed> seeds = vtkInsideOutReadSeeds(inputVector);
      if (!names.Bodies.empty())
      {
        PriorityOf(vtkInsideOutReadTags(input, names.Bodies, {}).Names,
          vtkInsideOutSplitNames(this->Priority)); // it throws before the work begins
      }
      const vtkInsideOutTags tags =
        vtkInsideOutReadTags(input, this->TagArrayName, vtkInsideOutFindBlocks(this));
      const HullMeshParameters parameters = vtkInsideOutHullMeshParameters(this);
      const std::shared_ptr<HullOfInput> kept = this->Hulls->Get(given, AsTuple(parameters, names),
        [&, &surface = input, &arrays = names]()
        { return std::make_shared<HullOfInput>(surface, parameters, arrays, monitor); });
      if (this->GetReleaseDataFlag())
      {
        this->Hulls->Forget();
      }
      const HullMesh& hull = kept->Hull;
      vtkInsideOutMakeOutputs outputs = kept->Outputs;

      Stopwatch stopwatch;
      const Segmented segmented = CutHull(*kept, seeds, vtkPointSet::GetData(inputVector[1]),
        { vtkInsideOutSegmentMeshParameters(this), this->ConstrainedFacetsArrayName,
          static_cast<insideout::RegionRule>(this->RegionRule), this->Priority },
        monitor);
      const MeshSegmentation& segmentation = segmented.All;
      const double cutSeconds = stopwatch.Lap();
      vtkInsideOutParting parting;
      const bool isParted = this->PartsSolid();
      if (isParted)
      {
        parting = Part(hull, segmentation.Inside, this->SeparateOverlaps,
          this->NonManifold == NONMANIFOLD_SPLIT, monitor);
      }
      Surfaces surfaces = kept->Bodies.AreThere()
        ? MakeSurfacesOfBodies(
            *kept, segmented, this->TagArrayName.empty() ? nullptr : &tags, outputs, monitor)
        : MakeSurfaces(*kept, segmentation.Inside, isParted ? &parting : nullptr,
            { this->MergeCoplanarPieces, this->SplitSeams, this->NonManifold == NONMANIFOLD_SPLIT },
            tags, outputs, monitor);
      Solid solid =
        MakeSolid(*kept, segmented, isParted ? &parting : nullptr, this->ExtractInside, monitor);

      vtkInsideOutRefinement refinement;
      if (this->Refine && !solid.Masses.empty())
      {
        refinement = RefineSolid(
          vtkInsideOutRefinementParameters(this), this->QuadraticCells, solid, surfaces, monitor);
      }
      Statistics statistics = hull.Statistics;
      statistics.emplace_back("SecondsCut", cutSeconds);
      Append(segmentation.Statistics, statistics);
      Append(parting.Statistics, statistics);
      Append(solid.Counts, statistics);
      AppendMass(solid.Mass, statistics);
      statistics.emplace_back("BoundaryFaces", surfaces.Boundary->GetNumberOfCells());
      Append(surfaces.Counts, statistics);
      Append(refinement.Statistics, statistics);
      statistics.emplace_back("PeakMemory", PeakMemory());

      vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(solid.Grid);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(surfaces.Boundary);
      vtkPolyData::GetData(outputVector, 2)->ShallowCopy(surfaces.Outliers);
      vtkInsideOutAddStatistics(statistics, vtkUnstructuredGrid::GetData(outputVector, 0));
      outputs.AddLeftOutCells(hull.Surface, vtkUnstructuredGrid::GetData(outputVector, 0));
      vtkInsideOutAddMasses(solid.Masses, vtkUnstructuredGrid::GetData(outputVector, 0));
      vtkInsideOutWarn(this, inputWarnings);
      vtkInsideOutWarn(this, hull.Warnings);
      vtkInsideOutWarn(this, segmentation.Warnings);
      vtkInsideOutWarn(this, parting.Warnings);
      vtkInsideOutWarn(this, outputs.Warnings);
      vtkInsideOutWarn(this, refinement.Warnings);
      if (solid.Masses.empty())
      {
        vtkWarningMacro(<< NothingInside(hull));
      }
      else if (const std::string warning = WarningAbout(surfaces.Lost); !warning.empty())
      {
        vtkWarningMacro(<< warning);
      }
    });
}
