// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "Common/Stages.h"
#include "LostArea.h"
#include "NothingInside.h"
#include "Output/MassProperties.h"
#include "Output/MergePieces.h"
#include "Output/Topology.h"
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
/** What decides about the hull, to be compared. Does not compile once a parameter is added: it may
 * not be missing here. */
auto AsTuple(const HullMeshParameters& parameters, const std::string& nonParticipating)
{
  const auto& [chain, orientation, thicken, budgets, quadratureOrder] = parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  const auto& [width, all] = thicken;
  const auto& [seconds, mebibytes, engine] = budgets;
  return std::make_tuple(mergeTolerance, countDuplicates, orientation, width, all, seconds,
    mebibytes, engine, quadratureOrder, nonParticipating);
}
} // namespace

/** The hull of an input, which the segmentation does not change. */
struct vtkRobustTetrahedralize::HullOfInput
{
  HullOfInput(vtkPolyData* input, const HullMeshParameters& parameters,
    const std::string& nonParticipating, Monitor& monitor)
    : Surface(vtkInsideOutReadSurface(ShallowCopyOf(input), nonParticipating))
    , Outputs(this->Surface)
    , Hull(MeshHull(this->Surface.Soup, parameters, monitor))
    , Grid(this->Outputs.MakeGrid(this->Hull))
  {
  }

  static vtkSmartPointer<vtkPolyData> ShallowCopyOf(vtkPolyData* input)
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(input);
    return copy;
  }

  vtkInsideOutSurface Surface;
  vtkInsideOutMakeOutputs Outputs; ///< to be copied: each run has warnings of its own
  HullMesh Hull;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
};

class vtkRobustTetrahedralize::Cache
  : public vtkInsideOutCache<decltype(AsTuple(std::declval<HullMeshParameters>(), std::string())),
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

/** @param[in] parted the solid that was parted from the hull, or null */
Surfaces MakeSurfaces(const HullMesh& hull, const std::vector<unsigned char>& inside,
  const vtkInsideOutParting* parted, const BoundaryOptions& options, const TriangleSoup& soup,
  vtkInsideOutMakeOutputs& outputs, Monitor& monitor)
{
  Surfaces surfaces;
  const TetrahedralMesh& mesh = parted ? parted->Solid.Mesh : hull.Mesh;
  const std::vector<BoundaryFace> faces = BoundaryFaces(
    mesh, parted ? parted->Solid.Inside : inside, monitor, { Stages::Extracting, 0, 0.05 });
  // Of the hull's cells: those of a parted solid overlap.
  const std::vector<BoundaryFace> unparted =
    parted ? BoundaryFaces(hull.Mesh, inside, monitor, { Stages::Extracting, 0.05, 0.05 }) : faces;
  AppendTopology(
    FindTopology(hull.Mesh, inside, unparted, monitor, { Stages::Extracting, 0.05, 0.05 }),
    surfaces.Counts);
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
    surfaces.Boundary = outputs.MakeManifoldBoundary(hull, mesh, manifold, boundary);
    vtkInsideOutTellOfSharedPoints(manifold, surfaces.Counts, outputs.Warnings);
  }
  else
  {
    surfaces.Boundary = options.SplitSeams
      ? outputs.MakeSeamedBoundary(hull, boundary, monitor, { Stages::Extracting, 0.2, 0.3 })
      : outputs.MakeBoundary(hull, mesh, boundary);
  }
  monitor.Check(Stages::Extracting, 0.3);
  surfaces.Counts.emplace_back("SeamPoints", outputs.CountSeamPoints(hull));

  const std::vector<OutlierPiece> outliers =
    OutlierPieces(hull.Surface, hull.Mesh, inside, monitor, { Stages::Extracting, 0.3, 0.35 });
  monitor.Check(Stages::Extracting, 0.35);
  surfaces.Outliers = outputs.MakeOutliers(hull, outliers);
  monitor.Check(Stages::Extracting, 0.4);
  CountOutliers(hull, outliers, surfaces.Counts);
  surfaces.Lost = MeasureLostArea(hull, outliers);
  surfaces.Counts.emplace_back("LostShare", surfaces.Lost.Share);
  return surfaces;
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
  vtkUnstructuredGrid* grid, bool extractInside, Monitor& monitor)
{
  const SolidRegions regions =
    FindRegions(mesh, inside, monitor, { Stages::Extracting, 0.4, 0.45 });
  Solid solid;
  solid.Grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  solid.Grid->ShallowCopy(grid);
  vtkInsideOutAddInside(inside, solid.Grid);
  vtkInsideOutAddRegions(regions, solid.Grid);
  if (extractInside)
  {
    solid.Grid = vtkInsideOutExtractInside(solid.Grid, monitor, { Stages::Extracting, 0.45, 1 });
  }
  solid.Masses = MeasureRegions(mesh, regions);
  solid.Counts.emplace_back("InsideCells", std::count(inside.begin(), inside.end(), 1));
  solid.Counts.emplace_back("Regions", regions.Count);
  solid.Mass = regions.Count == 1 ? solid.Masses.front() : MeasureMass(mesh, inside);
  return solid;
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
  options.Hull.Chain = vtkInsideOutChainParameters(this);
  options.Hull.Orientation = vtkInsideOutOrientation(this);
  options.Segment = vtkInsideOutSegmentMeshParameters(this);
  options.ConstrainedArray = this->ConstrainedFacetsArrayName;
  options.ExtractInside = this->ExtractInside;
  options.Refine = this->Refine;
  options.Refinement = vtkInsideOutRefinementParameters(this);
  options.SplitPoints = this->NonManifold == NON_MANIFOLD_SPLIT;
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

/** Whether the solid is more than a choice of the hull's cells. */
bool vtkRobustTetrahedralize::PartsSolid()
{
  return this->NonManifold == NON_MANIFOLD_SPLIT || this->SeparateOverlaps;
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

int vtkRobustTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  return vtkInsideOutRunOnWhole(this, outputVector,
    [&]()
    {
      if (vtkInsideOutDimensionOf(input, this->Dimension, this->Thicken > 0) == DIMENSION_2)
      {
        this->MakeTriangles(inputVector, outputVector);
        return;
      }
      vtkInsideOutMonitor monitor(this, StagesWith(this->Refine));
      this->CheckOptions();
      const std::vector<Seed> seeds = vtkInsideOutReadSeeds(inputVector);
      const vtkInsideOutTags tags =
        vtkInsideOutReadTags(input, this->TagArrayName, vtkInsideOutFindBlocks(this));
      const HullMeshParameters parameters = vtkInsideOutHullMeshParameters(this);
      const std::string& nonParticipating = this->NonParticipatingArrayName;
      const std::shared_ptr<HullOfInput> kept =
        this->Hulls->Get(input, AsTuple(parameters, nonParticipating),
          [&]()
          { return std::make_shared<HullOfInput>(input, parameters, nonParticipating, monitor); });
      if (this->GetReleaseDataFlag())
      {
        this->Hulls->Forget();
      }
      const HullMesh& hull = kept->Hull;
      vtkInsideOutMakeOutputs outputs = kept->Outputs;

      Stopwatch stopwatch;
      const std::vector<unsigned char> chosen =
        vtkInsideOutReadChosenFacets(kept->Surface, this->ConstrainedFacetsArrayName, hull.Surface);
      const MeshSegmentation segmentation = SegmentMesh(hull.Mesh, hull.W,
        PiecesOfFacets(hull.Mesh, chosen), seeds, vtkInsideOutSegmentMeshParameters(this), monitor);
      const double cutSeconds = stopwatch.Lap();
      vtkInsideOutParting parting;
      if (this->PartsSolid())
      {
        parting = Part(hull, segmentation.Inside, this->SeparateOverlaps,
          this->NonManifold == NON_MANIFOLD_SPLIT, monitor);
      }
      const bool isParted = this->PartsSolid();
      Surfaces surfaces = MakeSurfaces(hull, segmentation.Inside, isParted ? &parting : nullptr,
        { this->MergeCoplanarPieces, this->SplitSeams, this->NonManifold == NON_MANIFOLD_SPLIT },
        kept->Surface.Soup, outputs, monitor);
      vtkInsideOutAddTags(tags, surfaces.Boundary);
      Solid solid = isParted
        ? MakeSolid(parting.Solid.Mesh, parting.Solid.Inside,
            vtkInsideOutMakePartedGrid(kept->Grid, parting), true, monitor)
        : MakeSolid(hull.Mesh, segmentation.Inside, kept->Grid, this->ExtractInside, monitor);

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
          solid.Mass = refinement.Mass;
        }
      }
      Statistics statistics = hull.Statistics;
      statistics.emplace_back("SecondsCut", cutSeconds);
      statistics.insert(
        statistics.end(), segmentation.Statistics.begin(), segmentation.Statistics.end());
      statistics.insert(statistics.end(), parting.Statistics.begin(), parting.Statistics.end());
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
