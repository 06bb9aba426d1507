// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "Common/Stages.h"
#include "Common/Team.h"
#include "Private/vtkInsideOutBlock.h"
#include "Private/vtkInsideOutCache.h"
#include "Private/vtkInsideOutHull.h"
#include "Private/vtkInsideOutMakeTetrahedra.h"
#include "Private/vtkInsideOutMakeTriangles.h"
#include "Private/vtkInsideOutMeshAhead.h"
#include "Private/vtkInsideOutMonitor.h"
#include "Private/vtkInsideOutOptions.h"
#include "Private/vtkInsideOutRun.h"
#include "Private/vtkInsideOutSeedsPort.h"
#include "Private/vtkInsideOutWholeInput.h"

#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <optional>

using namespace insideout;

vtkStandardNewMacro(vtkRobustTetrahedralize);

class vtkRobustTetrahedralize::Cache
  : public vtkInsideOutCache<decltype(vtkInsideOutAsTuple(
                               HullMeshParameters(), vtkInsideOutHullArrays())),
      vtkInsideOutHull>
{
};

class vtkRobustTetrahedralize::CacheInAPlane
  : public vtkInsideOutCache<decltype(vtkInsideOutAsTuple(PlanarHullParameters(), std::string())),
      vtkInsideOutPlanarHull>
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
  this->LargestRegions = static_cast<int>(segment.Topology.Regions.LargestRegions);
  this->MinimumRegionVolume = segment.Topology.Regions.MinimumRegionVolume;
  this->SeededRegions = segment.Topology.Regions.SeededRegions;
  this->FillCavities = segment.Topology.Regions.FillCavities;
  this->Topology = static_cast<int>(segment.Topology.Goal);
  const HullMeshParameters hull;
  this->Orientation = static_cast<int>(hull.Orientation);
  this->Thicken = hull.Thicken.Width;
  this->ThickenAll = hull.Thicken.All;
  this->MergeTolerance = hull.Chain.MergeTolerance;
  this->CountDuplicates = hull.Chain.CountDuplicates;
  this->QuadratureOrder = hull.QuadratureOrder;
  this->PartsApart = hull.PartsApart;
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
  os << indent << "LargestRegions: " << this->LargestRegions << "\n";
  os << indent << "MinimumRegionVolume: " << this->MinimumRegionVolume << "\n";
  os << indent << "SeededRegions: " << this->SeededRegions << "\n";
  os << indent << "FillCavities: " << this->FillCavities << "\n";
  os << indent << "Topology: " << this->Topology << "\n";
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
  os << indent << "SurfaceOnly: " << this->SurfaceOnly << "\n";
  os << indent << "TagArrayName: " << this->TagArrayName << "\n";
  os << indent << "BodyArrayName: " << this->BodyArrayName << "\n";
  os << indent << "BlocksAreBodies: " << this->BlocksAreBodies << "\n";
  os << indent << "BlocksAtOnce: " << this->BlocksAtOnce << "\n";
  os << indent << "PartsApart: " << this->PartsApart << "\n";
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
/** An input as one surface, and what of it decides about the hull. */
struct OneSurface
{
  vtkSmartPointer<vtkPolyData> Polygons;
  vtkInsideOutHullArrays Names;
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
    vtkInsideOutHullArrays& names = input.Names;
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

HullMeshParameters HullParametersOf(vtkRobustTetrahedralize* filter)
{
  HullMeshParameters parameters = vtkInsideOutHullMeshParameters(filter);
  parameters.PartsApart = filter->GetPartsApart();
  return parameters;
}

vtkInsideOutSolidOptions SolidOptionsOf(vtkRobustTetrahedralize* filter)
{
  static_assert(vtkRobustTetrahedralize::BY_PRIORITY == static_cast<int>(RegionRule::Priority));
  static_assert(vtkRobustTetrahedralize::ALL == static_cast<int>(RegionRule::All));
  vtkInsideOutSolidOptions options;
  options.Segment = { vtkInsideOutSegmentMeshParameters(filter),
    filter->GetConstrainedFacetsArrayName(), static_cast<RegionRule>(filter->GetRegionRule()),
    filter->GetPriority(), filter->GetMergeTolerance() };
  options.SplitPoints = filter->GetNonManifold() == vtkRobustTetrahedralize::NONMANIFOLD_SPLIT;
  options.SeparateOverlaps = filter->GetSeparateOverlaps();
  options.Boundary = { filter->GetMergeCoplanarPieces(), filter->GetSplitSeams(),
    options.SplitPoints };
  options.TagBodies = !std::string(filter->GetTagArrayName()).empty();
  options.ExtractInside = filter->GetExtractInside();
  options.Refine = filter->GetRefine();
  options.Refinement = vtkInsideOutRefinementParameters(filter);
  options.QuadraticCells = filter->GetQuadraticCells();
  return options;
}

vtkInsideOutPlanarOptions PlanarOptionsOf(vtkRobustTetrahedralize* filter)
{
  vtkInsideOutPlanarOptions options;
  options.Segment = vtkInsideOutSegmentMeshParameters(filter);
  options.ConstrainedArray = filter->GetConstrainedFacetsArrayName();
  options.ExtractInside = filter->GetExtractInside();
  options.Refine = filter->GetRefine();
  options.Refinement = vtkInsideOutRefinementParameters(filter);
  options.SplitPoints = filter->GetNonManifold() == vtkRobustTetrahedralize::NONMANIFOLD_SPLIT;
  return options;
}
} // namespace

void vtkRobustTetrahedralize::PutOut(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  vtkPolyData* outliers, vtkInformationVector* outputVector)
{
  auto* output = vtkUnstructuredGrid::GetData(outputVector, 0);
  if (this->SurfaceOnly)
  {
    output->GetFieldData()->ShallowCopy(grid->GetFieldData());
  }
  else
  {
    output->ShallowCopy(grid);
  }
  vtkPolyData::GetData(outputVector, 1)->ShallowCopy(boundary);
  vtkPolyData::GetData(outputVector, 2)->ShallowCopy(outliers);
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
  std::vector<std::string> stages = { Stages::Validating, Stages::Resolving, Stages::Triangulating,
    Stages::Orienting, Stages::WindingNumbers, Stages::Segmenting, Stages::Extracting };
  if (this->Refine)
  {
    stages.emplace_back(Stages::Refining);
  }
  vtkInsideOutMonitor monitor(this, stages);
  this->CheckPlanarOptions();
  this->CheckOptions();
  const std::vector<Seed> seeds = vtkInsideOutReadSeeds(inputVector);
  const vtkInsideOutTags tags =
    vtkInsideOutReadTags(input, this->TagArrayName, vtkInsideOutFindBlocks(this));
  PlanarHullParameters parameters;
  parameters.Chain = vtkInsideOutChainParameters(this);
  parameters.Orientation = vtkInsideOutOrientation(this);
  const std::string& nonParticipating = this->NonParticipatingArrayName;
  const std::shared_ptr<vtkInsideOutPlanarHull> kept = this->HullsInAPlane->Get(input,
    vtkInsideOutAsTuple(parameters, nonParticipating),
    [&]() {
      return std::make_shared<vtkInsideOutPlanarHull>(input, parameters, nonParticipating, monitor);
    });
  if (this->GetReleaseDataFlag())
  {
    this->HullsInAPlane->Forget(input);
  }
  const vtkInsideOutTriangles triangles =
    vtkInsideOutMakeTriangles(kept->Curve, kept->Hull, seeds, tags, PlanarOptionsOf(this), monitor);
  this->PutOut(triangles.Grid, triangles.Boundary, triangles.Outliers, outputVector);
  if (this->Dimension == DIMENSION_AUTOMATIC)
  {
    vtkInsideOutWarn(this, { vtkInsideOutTwoDimensions(kept->Curve) });
  }
  vtkInsideOutWarn(this, triangles.Warnings);
  if (this->Thicken > 0)
  {
    vtkWarningMacro(<< "Thicken does nothing in two dimensions");
  }
  if (this->PartsApart)
  {
    vtkWarningMacro(<< "PartsApart does nothing in two dimensions");
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
  if (this->PartsApart && this->Topology != TOPOLOGY_ANY)
  {
    refuse("Topology takes one hull, and PartsApart leaves no cells between parts to join them by");
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

void vtkRobustTetrahedralize::CheckPlanarOptions()
{
  const auto refuse = [](const std::string& words)
  { throw Error(ErrorCode::InvalidParameter, words); };
  if (this->Refine && this->QuadraticCells)
  {
    refuse("QuadraticCells makes tetrahedra only, and the input lies in a plane");
  }
  if (this->Refine && this->Surface == REMESHED)
  {
    refuse("the input lies in a plane, where the boundary can be kept or split, not remeshed");
  }
  if (this->SeparateOverlaps)
  {
    refuse(
      "the input lies in a plane, where SeparateOverlaps does nothing: it separates tetrahedra");
  }
}

void vtkRobustTetrahedralize::CheckBodies(bool isPlanar)
{
  const bool areThere = this->BlocksAreBodies || !this->BodyArrayName.empty();
  const std::string option = this->BlocksAreBodies ? "BlocksAreBodies" : "BodyArrayName";
  if (this->BlocksAreBodies && !this->BodyArrayName.empty())
  {
    throw Error(ErrorCode::InvalidParameter,
      "BlocksAreBodies and BodyArrayName both say what is a body: set one of them");
  }
  if (areThere && this->PartsApart)
  {
    throw Error(ErrorCode::InvalidParameter,
      "PartsApart takes one body, and " + option + " makes several of the input");
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

void vtkRobustTetrahedralize::MeshBlocksAhead(vtkInsideOutMonitor& monitor)
{
  const HullMeshParameters parameters = HullParametersOf(this);
  constexpr std::size_t BlocksPerThread = 8; // so that threads end at about the same time
  const std::size_t most = BlocksPerThread * std::min(this->BlocksAtOnce, MostThreads());
  std::vector<vtkDataObject*> blocks = vtkInsideOutBlocksFromHere(this);
  blocks.resize(std::min(blocks.size(), most));
  std::vector<std::shared_ptr<vtkInsideOutHull>> hulls;
  try
  {
    for (vtkDataObject* block : blocks)
    {
      try
      {
        const auto [input, names, warnings] = ReadInput(this, block);
        const auto key = vtkInsideOutAsTuple(parameters, names);
        if (input && !this->Hulls->Find(block, key) &&
          vtkInsideOutDimensionOf(input, this->Dimension, this->Thicken > 0) == DIMENSION_3)
        {
          hulls.push_back(std::make_shared<vtkInsideOutHull>(input, names));
          this->Hulls->Remember(block, key, hulls.back());
        }
      }
      catch (const Error&)
      {
        // is said when VTK comes to the block, as where that is no surface
      }
    }
    vtkInsideOutMeshAhead(hulls, parameters, !this->SurfaceOnly, this->BlocksAtOnce, monitor);
  }
  catch (...) // no hull is remembered that was not made
  {
    std::for_each(
      blocks.begin(), blocks.end(), [this](vtkDataObject* block) { this->Hulls->Forget(block); });
    throw;
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
      const HullMeshParameters parameters = HullParametersOf(this);
      if (this->BlocksAtOnce > 1 &&
        !this->Hulls->Find(given, vtkInsideOutAsTuple(parameters, names)))
      {
        this->MeshBlocksAhead(monitor);
      }
      const std::shared_ptr<vtkInsideOutHull> kept =
        this->Hulls->Get(given, vtkInsideOutAsTuple(parameters, names),
          [&, &surface = input, &arrays = names]()
          {
            auto hull = std::make_shared<vtkInsideOutHull>(surface, arrays);
            hull->Resolve(parameters, monitor);
            return hull;
          });
      if (this->GetReleaseDataFlag() || kept->Failure)
      {
        this->Hulls->Forget(given);
      }
      if (kept->Failure)
      {
        std::rethrow_exception(kept->Failure);
      }
      const vtkInsideOutSolidOptions options = SolidOptionsOf(this);
      std::optional<vtkInsideOutTetrahedra> made;
      if (this->SurfaceOnly)
      {
        made = vtkInsideOutMakeSurfaceOnly(*kept, !seeds.empty(), tags, options, monitor);
      }
      const bool areTetrahedraMade = !made;
      if (areTetrahedraMade)
      {
        kept->Fill(parameters, monitor);
        kept->MakeGrid();
        made = vtkInsideOutMakeTetrahedra(
          *kept, seeds, vtkPointSet::GetData(inputVector[1]), tags, options, monitor);
      }
      if (this->SurfaceOnly)
      {
        vtkInsideOutAddStatistics({ { "Tetrahedra", areTetrahedraMade } }, made->Grid);
      }
      this->PutOut(made->Grid, made->Boundary, made->Outliers, outputVector);
      vtkInsideOutWarn(this, inputWarnings);
      vtkInsideOutWarn(this, made->Warnings);
    });
}
