// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "Common/Stages.h"
#include "LostArea.h"
#include "NothingInside.h"
#include "Output/MassProperties.h"
#include "Output/MergePieces.h"
#include "Private/vtkInsideOutBodies.h"
#include "Private/vtkInsideOutCache.h"
#include "Private/vtkInsideOutMakeOutputs.h"
#include "Private/vtkInsideOutMakeTriangles.h"
#include "Private/vtkInsideOutMonitor.h"
#include "Private/vtkInsideOutOptions.h"
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
/** What of an input decides about the hull: the names of arrays, and when blocks were modified. */
struct ArrayNames
{
  std::string NonParticipating;
  std::string Bodies;
  vtkMTimeType BlocksTime = 0;
};

/** When the last one was modified: a composite data set does not tell. */
vtkMTimeType TimeOfBlocks(vtkDataObject* blocks)
{
  vtkMTimeType time = 0;
  vtkInsideOutVisitBlocks(blocks,
    [&](vtkDataObject* block, const std::string&) { time = std::max(time, block->GetMTime()); });
  return time;
}

/** What decides about the hull, to be compared. Does not compile once a parameter is added: it may
 * not be missing here. */
auto AsTuple(const HullMeshParameters& parameters, const ArrayNames& names)
{
  const auto& [chain, orientation, thicken, budgets, quadratureOrder] = parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  const auto& [width, all] = thicken;
  const auto& [seconds, mebibytes, engine] = budgets;
  const auto& [nonParticipating, bodies, blocksTime] = names;
  return std::make_tuple(mergeTolerance, countDuplicates, orientation, width, all, seconds,
    mebibytes, engine, quadratureOrder, nonParticipating, bodies, blocksTime);
}
} // namespace

/** The hull of an input, which the segmentation does not change. */
struct vtkRobustTetrahedralize::HullOfInput
{
  HullOfInput(vtkPolyData* input, const HullMeshParameters& parameters, const ArrayNames& names,
    Monitor& monitor)
    : Surface(vtkInsideOutReadSurface(ShallowCopyOf(input), names.NonParticipating))
    , Outputs(this->Surface)
    , Bodies(vtkInsideOutReadBodies(this->Surface, names.Bodies))
  {
    if (this->Bodies.AreThere())
    {
      HullOfBodies hull = MeshBodies(
        SplitBodies(this->Surface.Soup, this->Bodies.OfTriangle, this->Bodies.Names), parameters,
        monitor);
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
struct vtkRobustTetrahedralize::Segmented
{
  MeshSegmentation All;                            ///< inside any body
  std::vector<std::vector<unsigned char>> InBodies; ///< where there are bodies
  BodyRegions Regions;
};

class vtkRobustTetrahedralize::Cache
  : public vtkInsideOutCache<decltype(AsTuple(std::declval<HullMeshParameters>(), ArrayNames())),
      HullOfInput>
{
};

vtkRobustTetrahedralize::vtkRobustTetrahedralize()
  : Hulls(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  const SegmentMeshParameters segment;
  this->Gamma = segment.Cut.Gamma;
  this->Sigma = segment.Cut.Sigma;
  this->DataTerm = static_cast<int>(segment.Cut.DataTerm);
  this->ConstrainFacets = segment.ConstrainFacets;
  this->ConstrainManifold = segment.ConstrainManifold;
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
  os << indent << "ConstrainManifold: " << this->ConstrainManifold << "\n";
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

/** The solid's boundary, of one body. */
vtkSmartPointer<vtkPolyData> MakeBoundary(const HullMesh& hull,
  const std::vector<unsigned char>& inside, bool mergePieces, bool splitSeams,
  const TriangleSoup& soup, vtkInsideOutMakeOutputs& outputs, Monitor& monitor)
{
  const std::vector<BoundaryFace> faces =
    BoundaryFaces(hull.Mesh, inside, monitor, { Stages::Extracting, 0, 0.05 });
  std::vector<BoundaryTriangle> boundary =
    BoundaryTriangles(hull.Surface, hull.Mesh, faces, monitor, { Stages::Extracting, 0.05, 0.1 });
  if (mergePieces)
  {
    boundary = MergePieces(boundary, TrianglesInMesh(soup, hull.MergedInto, hull.Mesh), monitor,
      { Stages::Extracting, 0.1, 0.2 });
  }
  monitor.Check(Stages::Extracting, 0.2);
  return splitSeams
    ? outputs.MakeSeamedBoundary(hull, boundary, monitor, { Stages::Extracting, 0.2, 0.3 })
    : outputs.MakeBoundary(hull, boundary);
}

/** The boundary of several bodies and the interfaces between their regions, with tags. */
vtkSmartPointer<vtkPolyData> MakeBoundaryOfBodies(const HullMesh& hull, const BodyRegions& regions,
  const std::vector<std::string>& names, const vtkInsideOutTags* tags,
  vtkInsideOutMakeOutputs& outputs, Monitor& monitor)
{
  const RegionBoundaries boundaries =
    FindRegionBoundaries(hull.Mesh, regions.Regions, monitor, { Stages::Extracting, 0, 0.1 });
  vtkSmartPointer<vtkPolyData> boundary = outputs.MakeBoundary(hull,
    BoundaryTriangles(
      hull.Surface, hull.Mesh, boundaries.Faces, monitor, { Stages::Extracting, 0.1, 0.2 }));
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

/** The solid's cells with their regions, and what it and each of these weigh. */
struct Solid
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  std::vector<MassProperties> Masses; ///< of the regions
  MassProperties Mass;
  Statistics Counts;
};

/** @param[in] add what puts more arrays on the grid of the hull */
template <typename Add>
Solid MakeSolid(const HullMesh& hull, const std::vector<unsigned char>& inside,
  const SolidRegions& regions, vtkUnstructuredGrid* hullGrid, bool extractInside, const Add& add,
  Monitor& monitor)
{
  Solid solid;
  solid.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  solid.Grid->ShallowCopy(hullGrid);
  vtkInsideOutAddInside(inside, solid.Grid);
  vtkInsideOutAddRegions(regions, solid.Grid);
  add(solid.Grid);
  if (extractInside)
  {
    solid.Grid = vtkInsideOutExtractInside(solid.Grid, monitor, { Stages::Extracting, 0.45, 1 });
  }
  const auto insideCells = std::count(inside.begin(), inside.end(), 1);
  if (insideCells > 0)
  {
    solid.Masses = MeasureRegions(hull.Mesh, regions);
  }
  solid.Counts.emplace_back("InsideCells", insideCells);
  solid.Counts.emplace_back("Regions", regions.Count);
  solid.Mass = regions.Count == 1 ? MeasureRegions(hull.Mesh, regions).front()
                                  : MeasureMass(hull.Mesh, inside);
  return solid;
}
} // namespace

vtkRobustTetrahedralize::Segmented vtkRobustTetrahedralize::Segment(
  const HullOfInput& kept, const std::vector<Seed>& given, vtkPointSet* points, Monitor& monitor)
{
  const HullMesh& hull = kept.Hull;
  const std::vector<unsigned char> chosen =
    vtkInsideOutReadChosenFacets(kept.Surface, this->ConstrainedFacetsArrayName, hull.Surface);
  const SegmentMeshParameters parameters = vtkInsideOutSegmentMeshParameters(this);
  const ProgressRange findingRegions = { Stages::Extracting, 0.4, 0.45 };
  Segmented segmented;
  if (!kept.Bodies.AreThere())
  {
    segmented.All = SegmentMesh(hull.Mesh, hull.W, PiecesOfFacets(hull.Mesh, chosen),
      given, parameters, monitor);
    segmented.Regions.Regions =
      FindRegions(hull.Mesh, segmented.All.Inside, monitor, findingRegions);
    return segmented;
  }
  const std::vector<std::string>& names = kept.Bodies.Names;
  const std::vector<Id> priority = PriorityOf(names, vtkInsideOutSplitNames(this->Priority));
  const std::vector<std::vector<Seed>> seeds = vtkInsideOutSeedsOfBodies(given, points, names);
  const std::vector<std::vector<FacetPiece>> pieces =
    vtkInsideOutPiecesOfBodies(hull, kept.Bodies, chosen);
  std::vector<BodyToSegment> bodies;
  for (std::size_t b = 0; b < names.size(); ++b)
  {
    bodies.push_back({ names[b], kept.WOfBodies[b], pieces[b], seeds[b] });
  }
  BodySegmentation found = SegmentBodies(hull.Mesh, bodies, parameters, monitor);
  segmented.InBodies = std::move(found.Inside);
  segmented.All.Statistics = std::move(found.Statistics);
  segmented.All.Warnings = std::move(found.Warnings);
  segmented.Regions = FindBodyRegions(segmented.InBodies,
    static_cast<insideout::RegionRule>(this->RegionRule), priority, monitor, findingRegions);
  for (const Id region : segmented.Regions.Regions.OfCell)
  {
    segmented.All.Inside.push_back(region != None);
  }
  return segmented;
}

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
  vtkInsideOutMonitor monitor(this,
    { Stages::Validating, Stages::Resolving, Stages::Triangulating, Stages::Orienting,
      Stages::WindingNumbers, Stages::Segmenting, Stages::Extracting });
  if (this->Refine)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the input lies in a plane, where Refine cannot make better cells: it refines tetrahedra");
  }
  const std::vector<Seed> seeds = vtkInsideOutReadSeeds(inputVector);
  const vtkInsideOutTags tags =
    vtkInsideOutReadTags(input, this->TagArrayName, vtkInsideOutFindBlocks(this));
  vtkInsideOutPlanarOptions options;
  options.Hull.Chain = vtkInsideOutChainParameters(this);
  options.Hull.Orientation = vtkInsideOutOrientation(this);
  options.Segment = vtkInsideOutSegmentMeshParameters(this);
  options.ConstrainedArray = this->ConstrainedFacetsArrayName;
  options.ExtractInside = this->ExtractInside;
  const vtkInsideOutCurve curve =
    vtkInsideOutReadCurve(input, options.Hull.Orientation, this->NonParticipatingArrayName);
  const vtkInsideOutTriangles triangles =
    vtkInsideOutMakeTriangles(curve, seeds, tags, options, monitor);
  vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(triangles.Grid);
  vtkPolyData::GetData(outputVector, 1)->ShallowCopy(triangles.Boundary);
  vtkPolyData::GetData(outputVector, 2)->ShallowCopy(triangles.Outliers);
  if (this->Dimension == DIMENSION_AUTOMATIC)
  {
    vtkInsideOutWarn(this, { vtkInsideOutTwoDimensions(curve) });
  }
  vtkInsideOutWarn(this, triangles.Warnings);
  if (this->Thicken > 0)
  {
    vtkWarningMacro(<< "Thicken does nothing in two dimensions");
  }
}

void vtkRobustTetrahedralize::CheckRefinement()
{
  if (!this->Refine)
  {
    return;
  }
  if (!this->ExtractInside)
  {
    throw Error(ErrorCode::InvalidParameter,
      "Refine takes ExtractInside: of the hull only the solid can be refined");
  }
  if (this->Surface != KEPT && (this->MergeCoplanarPieces || this->SplitSeams))
  {
    throw Error(ErrorCode::InvalidParameter,
      std::string(this->MergeCoplanarPieces ? "MergeCoplanarPieces" : "SplitSeams") +
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
  if (areThere && (this->MergeCoplanarPieces || this->SplitSeams))
  {
    throw Error(ErrorCode::InvalidParameter,
      std::string(this->MergeCoplanarPieces ? "MergeCoplanarPieces" : "SplitSeams") +
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
      vtkSmartPointer<vtkPolyData> input = vtkPolyData::SafeDownCast(given);
      ArrayNames names = { this->NonParticipatingArrayName, this->BodyArrayName, 0 };
      if (this->BlocksAreBodies)
      {
        input = vtkInsideOutJoinBlocks(given);
        names.Bodies = vtkInsideOutBodyIds;
        names.BlocksTime = TimeOfBlocks(given);
      }
      const bool isPlanar =
        vtkInsideOutDimensionOf(input, this->Dimension, this->Thicken > 0) == DIMENSION_2;
      this->CheckBodies(isPlanar);
      if (isPlanar)
      {
        this->MakeTriangles(inputVector, outputVector);
        return;
      }
      vtkInsideOutMonitor monitor(this, StagesWith(this->Refine));
      this->CheckRefinement();
      const std::vector<Seed> seeds = vtkInsideOutReadSeeds(inputVector);
      if (!names.Bodies.empty())
      {
        PriorityOf(vtkInsideOutReadTags(input, names.Bodies, {}).Names,
          vtkInsideOutSplitNames(this->Priority)); // it throws before the work begins
      }
      const vtkInsideOutTags tags =
        vtkInsideOutReadTags(input, this->TagArrayName, vtkInsideOutFindBlocks(this));
      const HullMeshParameters parameters = vtkInsideOutHullMeshParameters(this);
      const std::shared_ptr<HullOfInput> kept =
        this->Hulls->Get(given, AsTuple(parameters, names),
          [&]() { return std::make_shared<HullOfInput>(input, parameters, names, monitor); });
      if (this->GetReleaseDataFlag())
      {
        this->Hulls->Forget();
      }
      const HullMesh& hull = kept->Hull;
      vtkInsideOutMakeOutputs outputs = kept->Outputs;

      Stopwatch stopwatch;
      const Segmented segmented = this->Segment(*kept, seeds, vtkPointSet::GetData(inputVector[1]), monitor);
      const MeshSegmentation& segmentation = segmented.All;
      const double cutSeconds = stopwatch.Lap();
      const ProgressRange findingOutliers = { Stages::Extracting, 0.3, 0.35 };
      Surfaces surfaces;
      if (kept->Bodies.AreThere())
      {
        surfaces.Boundary = MakeBoundaryOfBodies(hull, segmented.Regions, kept->Bodies.Names,
          this->TagArrayName.empty() ? nullptr : &tags, outputs, monitor);
        AddOutliers(hull,
          OutlierPieces(hull.Surface, hull.Mesh,
            vtkInsideOutIsInOwnBody(hull, kept->Bodies, segmented.InBodies), monitor,
            findingOutliers),
          outputs, monitor, surfaces);
      }
      else
      {
        surfaces.Boundary = MakeBoundary(hull, segmentation.Inside, this->MergeCoplanarPieces,
          this->SplitSeams, kept->Surface.Soup, outputs, monitor);
        vtkInsideOutAddTags(tags, surfaces.Boundary);
        AddOutliers(hull,
          OutlierPieces(hull.Surface, hull.Mesh, segmentation.Inside, monitor, findingOutliers),
          outputs, monitor, surfaces);
      }
      surfaces.Counts.emplace_back("SeamPoints", outputs.CountSeamPoints(hull));
      Solid solid = MakeSolid(
        hull, segmentation.Inside, segmented.Regions.Regions, kept->Grid, this->ExtractInside,
        [&](vtkUnstructuredGrid* grid)
        {
          if (kept->Bodies.AreThere())
          {
            vtkInsideOutAddBodies(
              kept->Bodies, segmented.InBodies, segmented.Regions, hull.Mesh, grid);
          }
        },
        monitor);

      vtkInsideOutRefinement refinement;
      if (this->Refine && !solid.Masses.empty())
      {
        refinement = vtkInsideOutRefine(solid.Grid, surfaces.Boundary,
          vtkInsideOutRefinementParameters(this), this->QuadraticCells, monitor);
        solid.Grid = refinement.Grid;
        surfaces.Boundary = refinement.Boundary;
        if (this->Surface == REMESHED)
        {
          solid.Masses = refinement.Masses;
          solid.Masses.resize(segmented.Regions.Regions.Count);
          solid.Mass = refinement.Mass;
        }
      }
      Statistics statistics = hull.Statistics;
      statistics.emplace_back("SecondsCut", cutSeconds);
      statistics.insert(
        statistics.end(), segmentation.Statistics.begin(), segmentation.Statistics.end());
      statistics.insert(statistics.end(), solid.Counts.begin(), solid.Counts.end());
      AppendMass(solid.Mass, statistics);
      statistics.emplace_back("BoundaryFaces", surfaces.Boundary->GetNumberOfCells());
      statistics.insert(statistics.end(), surfaces.Counts.begin(), surfaces.Counts.end());
      statistics.insert(
        statistics.end(), refinement.Statistics.begin(), refinement.Statistics.end());
      statistics.emplace_back("PeakMemory", PeakMemory());

      vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(solid.Grid);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(surfaces.Boundary);
      vtkPolyData::GetData(outputVector, 2)->ShallowCopy(surfaces.Outliers);
      vtkInsideOutAddStatistics(statistics, vtkUnstructuredGrid::GetData(outputVector, 0));
      outputs.AddLeftOutCells(hull.Surface, vtkUnstructuredGrid::GetData(outputVector, 0));
      vtkInsideOutAddMasses(solid.Masses, vtkUnstructuredGrid::GetData(outputVector, 0));
      vtkInsideOutWarn(this, hull.Warnings);
      vtkInsideOutWarn(this, segmentation.Warnings);
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
