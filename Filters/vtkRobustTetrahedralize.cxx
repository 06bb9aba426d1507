// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTetrahedralize.h"

#include "Common/Stages.h"
#include "Common/Team.h"
#include "Data/StatisticsArrays.h"
#include "In/Blocks.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/ReadCurve.h"
#include "In/SeedsPort.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/KeptHull.h"
#include "Out/MakeTetrahedra.h"
#include "Out/MeshAhead.h"
#include "Out/NameSizes.h"
#include "Out/Summarize.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/Cache.h"
#include "Run/RunFilter.h"
#include "vtkGeneralizedWindingNumber.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkRefineTetrahedra.h"

#include <vtkFieldData.h>
#include <vtkGarbageCollector.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <optional>

using namespace insideout;

using Filter = vtkRobustTetrahedralize;
static_assert(Filter::OUTLIER_BY_ENERGY == static_cast<int>(OutlierReason::Energy));
static_assert(Filter::OUTLIER_LOST == static_cast<int>(OutlierReason::Lost));
static_assert(Filter::OUTLIER_LEFT_OUT == static_cast<int>(OutlierReason::LeftOut));
static_assert(Filter::OUTLIER_DEGENERATE == static_cast<int>(OutlierReason::Degenerate));

vtkStandardNewMacro(vtkRobustTetrahedralize);

class vtkRobustTetrahedralize::Cache
  : public vtkInsideOut::Cache<decltype(vtkInsideOut::AsTuple(
                                 HullMeshParameters(), vtkInsideOut::HullArrays())),
      vtkInsideOut::KeptHull>
{
};

vtkRobustTetrahedralize::vtkRobustTetrahedralize()
  : WindingNumber(vtkSmartPointer<vtkGeneralizedWindingNumber>::New())
  , Segmentation(vtkSmartPointer<vtkGraphCutSegmentation>::New())
  , Refinement(vtkSmartPointer<vtkRefineTetrahedra>::New())
  , PartsApart(HullMeshParameters().PartsApart)
  , Hulls(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

vtkRobustTetrahedralize::~vtkRobustTetrahedralize() = default;

void vtkRobustTetrahedralize::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ConstrainedFacetsArrayName: " << this->ConstrainedFacetsArrayName << "\n";
  os << indent << "SeparateOverlaps: " << this->SeparateOverlaps << "\n";
  os << indent << "GenerateHull: " << this->GenerateHull << "\n";
  os << indent << "MergeCoplanarPieces: " << this->MergeCoplanarPieces << "\n";
  os << indent << "SplitSeams: " << this->SplitSeams << "\n";
  os << indent << "SurfaceOnly: " << this->SurfaceOnly << "\n";
  os << indent << "TagArrayName: " << this->TagArrayName << "\n";
  os << indent << "TagRules: " << this->TagRules << "\n";
  os << indent << "BodyArrayName: " << this->BodyArrayName << "\n";
  os << indent << "BlocksAreBodies: " << this->BlocksAreBodies << "\n";
  os << indent << "BlocksAtOnce: " << this->BlocksAtOnce << "\n";
  os << indent << "PartsApart: " << this->PartsApart << "\n";
  os << indent << "TouchTolerance: " << this->TouchTolerance << "\n";
  os << indent << "RegionRule: " << this->RegionRule << "\n";
  os << indent << "Priority: " << this->Priority << "\n";
  os << indent << "MembranesSeparateRegions: " << this->MembranesSeparateRegions << "\n";
  os << indent << "Refine: " << this->Refine << "\n";
  os << indent << "WindingNumber:\n";
  this->WindingNumber->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Segmentation:\n";
  this->Segmentation->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Refinement:\n";
  this->Refinement->PrintSelf(os, indent.GetNextIndent());
}

vtkMTimeType vtkRobustTetrahedralize::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->WindingNumber->GetMTime(),
    this->Segmentation->GetMTime(), this->Refinement->GetMTime() });
}

void vtkRobustTetrahedralize::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  vtkGarbageCollectorReport(collector, this->WindingNumber, "WindingNumber");
  vtkGarbageCollectorReport(collector, this->Segmentation, "Segmentation");
  vtkGarbageCollectorReport(collector, this->Refinement, "Refinement");
}

void vtkRobustTetrahedralize::SetWindingNumber(vtkGeneralizedWindingNumber* windingNumber)
{
  vtkInsideOut::SetStage(this, windingNumber, this->WindingNumber);
}

vtkGeneralizedWindingNumber* vtkRobustTetrahedralize::GetWindingNumber()
{
  return this->WindingNumber;
}

void vtkRobustTetrahedralize::SetSegmentation(vtkGraphCutSegmentation* segmentation)
{
  vtkInsideOut::SetStage(this, segmentation, this->Segmentation);
}

vtkGraphCutSegmentation* vtkRobustTetrahedralize::GetSegmentation()
{
  return this->Segmentation;
}

void vtkRobustTetrahedralize::SetRefinement(vtkRefineTetrahedra* refinement)
{
  vtkInsideOut::SetStage(this, refinement, this->Refinement);
}

vtkRefineTetrahedra* vtkRobustTetrahedralize::GetRefinement()
{
  return this->Refinement;
}

// clang-format off
void vtkRobustTetrahedralize::SetOrientation(int way) { this->WindingNumber->SetOrientation(way); }
int vtkRobustTetrahedralize::GetOrientation() { return this->WindingNumber->GetOrientation(); }
void vtkRobustTetrahedralize::SetThicken(double width) { this->WindingNumber->SetThicken(width); }
double vtkRobustTetrahedralize::GetThicken() { return this->WindingNumber->GetThicken(); }
void vtkRobustTetrahedralize::SetNonParticipatingArrayName(const char* name) { this->WindingNumber->SetNonParticipatingArrayName(name); }
const char* vtkRobustTetrahedralize::GetNonParticipatingArrayName() { return this->WindingNumber->GetNonParticipatingArrayName(); }
void vtkRobustTetrahedralize::SetMergeTolerance(double most) { this->WindingNumber->SetMergeTolerance(most); }
double vtkRobustTetrahedralize::GetMergeTolerance() { return this->WindingNumber->GetMergeTolerance(); }
void vtkRobustTetrahedralize::SetGamma(double gamma) { this->Segmentation->SetGamma(gamma); }
double vtkRobustTetrahedralize::GetGamma() { return this->Segmentation->GetGamma(); }
void vtkRobustTetrahedralize::SetConstrainFacets(bool on) { this->Segmentation->SetConstrainFacets(on); }
bool vtkRobustTetrahedralize::GetConstrainFacets() { return this->Segmentation->GetConstrainFacets(); }
void vtkRobustTetrahedralize::SetNonManifold(int kind) { this->Segmentation->SetNonManifold(kind); }
int vtkRobustTetrahedralize::GetNonManifold() { return this->Segmentation->GetNonManifold(); }
void vtkRobustTetrahedralize::SetEdgeLength(double length) { this->Refinement->SetEdgeLength(length); }
double vtkRobustTetrahedralize::GetEdgeLength() { return this->Refinement->GetEdgeLength(); }
// clang-format on

void vtkRobustTetrahedralize::SetExtractInside(bool extract)
{
  if (!extract)
  {
    this->GenerateHullOn();
    vtkInsideOut::Warn(this,
      { "ExtractInside is gone: output 0 has the cells inside, and output 3 those of the whole "
        "hull, with GenerateHull, which is on now" });
  }
}

int vtkRobustTetrahedralize::FillInputPortInformation(int port, vtkInformation* info)
{
  return vtkInsideOut::FillPort(port, info, "vtkPolyData");
}

void vtkRobustTetrahedralize::SetBlocksAreBodies(bool blocksAreBodies)
{
  if (this->BlocksAreBodies == blocksAreBodies)
  {
    return;
  }
  this->BlocksAreBodies = blocksAreBodies;
  // VTK splits a composite data set into blocks unless the filter accepts it.
  vtkInformation* port = this->GetInputPortInformation(0);
  port->Remove(INPUT_REQUIRED_DATA_TYPE());
  port->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (blocksAreBodies)
  {
    port->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  this->Modified();
}

void vtkRobustTetrahedralize::SetSeedsData(vtkDataObject* seeds)
{
  this->SetInputData(1, seeds);
}

void vtkRobustTetrahedralize::SetSeedsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

int vtkRobustTetrahedralize::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool isGrid = port == 0 || port == 3;
  info->Set(vtkDataObject::DATA_TYPE_NAME(), isGrid ? "vtkUnstructuredGrid" : "vtkPolyData");
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

vtkUnstructuredGrid* vtkRobustTetrahedralize::GetHull()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(3));
}

std::string vtkRobustTetrahedralize::GetSummary()
{
  return vtkInsideOut::Summarize(this->GetOutputDataObject(0));
}

namespace
{
/** An input as one surface, and its part of the cache key of the hull. */
struct OneSurface
{
  vtkSmartPointer<vtkPolyData> Polygons;
  vtkInsideOut::HullArrays Names;
  std::vector<std::string> Warnings;
};

OneSurface ReadInput(vtkRobustTetrahedralize* filter, vtkDataObject* given)
{
  OneSurface input = { nullptr,
    { filter->GetNonParticipatingArrayName(), filter->GetBodyArrayName(), {},
      vtkPolyData::SafeDownCast(given) ? 0 : vtkInsideOut::LastChange(given) },
    {} };
  if (filter->GetBlocksAreBodies())
  {
    vtkInsideOut::RefuseSpreadParts(filter);
    input.Polygons = vtkInsideOut::JoinBlocks(given, input.Warnings);
    vtkInsideOut::HullArrays& names = input.Names;
    names.Bodies = vtkInsideOut::BodyIds;
    vtkInsideOut::VisitBlocks(
      given, [&](vtkDataObject*, const std::string& name) { names.BlockNames.push_back(name); });
  }
  else
  {
    input.Polygons = vtkInsideOut::SurfaceOfBlock(given);
  }
  return input;
}

std::vector<std::string> StagesWith(bool refine)
{
  std::vector<std::string> stages = { Stages::Validating, Stages::FindingIntersections,
    Stages::Orienting, Stages::Resolving, Stages::Tetrahedralizing, Stages::WindingNumbers,
    Stages::Segmenting, Stages::Extracting };
  if (refine)
  {
    stages.emplace_back(Stages::Refining);
  }
  return stages;
}

HullMeshParameters HullParametersOf(vtkRobustTetrahedralize* filter)
{
  HullMeshParameters parameters = vtkInsideOut::HullParametersOf(filter->GetWindingNumber());
  parameters.PartsApart = filter->GetPartsApart();
  parameters.TouchTolerance = filter->GetTouchTolerance();
  return parameters;
}

vtkInsideOut::SolidOptions SolidOptionsOf(vtkRobustTetrahedralize* filter)
{
  static_assert(vtkRobustTetrahedralize::BY_PRIORITY == static_cast<int>(RegionRule::Priority));
  static_assert(vtkRobustTetrahedralize::ALL == static_cast<int>(RegionRule::All));
  vtkInsideOut::SolidOptions options;
  options.Segment = { vtkInsideOut::SegmentParametersOf(filter->GetSegmentation()),
    filter->GetConstrainedFacetsArrayName(), static_cast<RegionRule>(filter->GetRegionRule()),
    filter->GetPriority(), filter->GetMergeTolerance(), filter->GetMembranesSeparateRegions() };
  options.SplitPoints = filter->GetNonManifold() == vtkGraphCutSegmentation::NONMANIFOLD_SPLIT;
  options.SeparateOverlaps = filter->GetSeparateOverlaps();
  options.Boundary = { filter->GetMergeCoplanarPieces(), filter->GetSplitSeams(),
    options.SplitPoints, !std::string(filter->GetTagArrayName()).empty(),
    ReadTagRules(filter->GetTagRules()) };
  options.GenerateHull = filter->GetGenerateHull();
  options.Refine = filter->GetRefine();
  options.Refinement = vtkInsideOut::RefinementParametersOf(filter->GetRefinement());
  if (options.SplitPoints || options.SeparateOverlaps || filter->GetMergeCoplanarPieces() ||
    filter->GetSplitSeams())
  {
    options.Refinement.Surface = SurfaceTreatment::Kept;
    options.Refinement.CouldBeTreated = false;
    options.Refinement.TreatsNeedles = false;
  }
  options.QuadraticCells = filter->GetRefinement()->GetQuadraticCells();
  options.QuadratureOrder = filter->GetWindingNumber()->GetQuadratureOrder();
  if (options.Refine)
  {
    vtkInsideOut::AddBackground(filter->GetRefinement(), options.Refinement.Sizes);
  }
  return options;
}
} // namespace

int vtkRobustTetrahedralize::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

int vtkRobustTetrahedralize::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

/** Whether the solid is more than a subset of the hull's cells. */
bool vtkRobustTetrahedralize::PartsSolid()
{
  return this->SeparateOverlaps ||
    this->GetNonManifold() == vtkGraphCutSegmentation::NONMANIFOLD_SPLIT;
}

void vtkRobustTetrahedralize::CheckOptions()
{
  ReadTagRules(this->TagRules); // they throw before the work begins
  const std::vector<SizeRule> sizes = ReadSizeRules(this->Refinement->GetSizeRules());
  const auto refuse = [](const std::string& words)
  { throw Error(ErrorCode::InvalidParameter, words); };
  const std::string parting =
    this->SeparateOverlaps ? "SeparateOverlaps" : "NonManifold of the kind Split";
  const bool changesPieces = this->MergeCoplanarPieces || this->SplitSeams;
  const std::string pieces = this->MergeCoplanarPieces ? "MergeCoplanarPieces" : "SplitSeams";
  if (this->PartsApart &&
    this->Segmentation->GetTopology() != vtkGraphCutSegmentation::TOPOLOGY_ANY)
  {
    refuse("Topology takes one hull, and PartsApart leaves no cells between parts to join them by");
  }
  if (this->PartsSolid() && changesPieces)
  {
    refuse(pieces + " does not go together with " + parting);
  }
  if (this->Refine && (this->PartsSolid() || changesPieces) && vtkInsideOut::SizesNameTags(sizes))
  {
    refuse((changesPieces ? pieces : parting) +
      " does not go together with SizeRules of tags, because cells lose theirs");
  }
  const int treatment = this->Refinement->GetSurfaceTreatment();
  if (this->Refine && treatment != vtkRefineTetrahedra::KEPT &&
    (this->PartsSolid() || changesPieces))
  {
    const std::string words = (changesPieces ? pieces : parting) +
      " takes a surface that is kept where the solid is refined";
    if (treatment != vtkRefineTetrahedra::AUTOMATIC)
    {
      refuse(words);
    }
    if (vtkInsideOut::FollowsLengths(this->Refinement))
    {
      const std::string given =
        this->Refinement->GetEdgeLength() > 0 ? "EdgeLength is" : "SizeRules are";
      vtkInsideOut::Warn(this, { words + ", and so it is though " + given + " given" });
    }
  }
}

void vtkRobustTetrahedralize::CheckBodies()
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
  if (areThere && this->MembranesSeparateRegions)
  {
    throw Error(ErrorCode::InvalidParameter,
      "MembranesSeparateRegions takes one body, and " + option + " makes regions of several");
  }
  if ((areThere || this->MembranesSeparateRegions) &&
    (this->MergeCoplanarPieces || this->SplitSeams || this->PartsSolid()))
  {
    const std::string parting =
      this->SeparateOverlaps ? "SeparateOverlaps" : "NonManifold of the kind Split";
    throw Error(ErrorCode::InvalidParameter,
      (this->MergeCoplanarPieces ? "MergeCoplanarPieces"
          : this->SplitSeams     ? "SplitSeams"
                                 : parting) +
        (areThere ? " takes one body" : " excludes MembranesSeparateRegions") +
        ": it would part interfaces from their cells");
  }
}

void vtkRobustTetrahedralize::MeshBlocksAhead(vtkInsideOut::AlgorithmMonitor& monitor)
{
  const HullMeshParameters parameters = HullParametersOf(this);
  constexpr std::size_t BlocksPerThread = 8; // so that threads end at about the same time
  const std::size_t most = BlocksPerThread * std::min(this->BlocksAtOnce, MostThreads());
  std::vector<vtkDataObject*> blocks = vtkInsideOut::BlocksFromHere(this);
  blocks.resize(std::min(blocks.size(), most));
  std::vector<std::shared_ptr<vtkInsideOut::KeptHull>> hulls;
  try
  {
    for (vtkDataObject* block : blocks)
    {
      try
      {
        const auto [input, names, warnings] = ReadInput(this, block);
        const auto key = vtkInsideOut::AsTuple(parameters, names);
        if (!this->Hulls->Find(block, key))
        {
          vtkInsideOut::RefusePlane(input, this->GetThicken() > 0);
          hulls.push_back(std::make_shared<vtkInsideOut::KeptHull>(input, names));
          this->Hulls->Remember(block, key, hulls.back());
        }
      }
      catch (const Error&)
      {
        // reported when VTK runs the block, for example if it is not a surface
      }
    }
    vtkInsideOut::MeshAhead(hulls, parameters, !this->SurfaceOnly, this->BlocksAtOnce, monitor);
  }
  catch (...) // only hulls that were made are cached
  {
    std::for_each(
      blocks.begin(), blocks.end(), [this](vtkDataObject* block) { this->Hulls->Forget(block); });
    throw;
  }
}

int vtkRobustTetrahedralize::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      vtkDataObject* given = vtkInsideOut::CurrentBlock(this);
      const auto [input, names, inputWarnings] = ReadInput(this, given);
      vtkInsideOut::RefusePlane(input, this->GetThicken() > 0);
      this->CheckBodies();
      vtkInsideOut::AlgorithmMonitor monitor(this, StagesWith(this->Refine));
      this->CheckOptions();
      const vtkSmartPointer<vtkPointSet> seedPoints = vtkInsideOut::FindSeeds(inputVector);
      const std::vector<Seed> seeds = vtkInsideOut::ReadSeeds(seedPoints);
      if (!names.Bodies.empty())
      {
        PriorityOf(vtkInsideOut::NamesOfBodies(input, names.Bodies),
          vtkInsideOut::SplitNames(this->Priority)); // exceptions come before the work begins
      }
      const vtkInsideOut::Tags tags =
        vtkInsideOut::ReadTags(input, this->TagArrayName, vtkInsideOut::FindBlocks(this));
      const HullMeshParameters parameters = HullParametersOf(this);
      if (this->BlocksAtOnce > 1 &&
        !this->Hulls->Find(given, vtkInsideOut::AsTuple(parameters, names)))
      {
        this->MeshBlocksAhead(monitor);
      }
      const std::shared_ptr<vtkInsideOut::KeptHull> kept =
        this->Hulls->Get(given, vtkInsideOut::AsTuple(parameters, names),
          [&, &surface = input, &arrays = names]()
          {
            auto hull = std::make_shared<vtkInsideOut::KeptHull>(surface, arrays);
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
      const vtkInsideOut::SolidOptions options = SolidOptionsOf(this);
      std::optional<vtkInsideOut::Tetrahedra> made;
      if (this->SurfaceOnly)
      {
        made = vtkInsideOut::MakeSurfaceOnly(*kept, !seeds.empty(), tags, options, monitor);
      }
      const bool areTetrahedraMade = !made;
      if (areTetrahedraMade)
      {
        kept->Fill(parameters, monitor);
        kept->MakeGrid();
        made = vtkInsideOut::MakeTetrahedra(*kept, seeds, seedPoints, tags, options, monitor);
      }
      if (this->SurfaceOnly)
      {
        for (vtkUnstructuredGrid* grid : { made->Grid.Get(), made->Hull.Get() })
        {
          if (grid)
          {
            vtkInsideOut::AddStatistics({ { "Tetrahedra", areTetrahedraMade } }, grid);
          }
        }
      }
      vtkUnstructuredGrid* solid = vtkUnstructuredGrid::GetData(outputVector, 0);
      if (this->SurfaceOnly)
      {
        solid->GetFieldData()->ShallowCopy(made->Grid->GetFieldData());
      }
      else
      {
        solid->ShallowCopy(made->Grid);
      }
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(made->Boundary);
      vtkPolyData::GetData(outputVector, 2)->ShallowCopy(made->Outliers);
      if (made->Hull)
      {
        vtkUnstructuredGrid::GetData(outputVector, 3)->ShallowCopy(made->Hull);
      }
      vtkInsideOut::Warn(this, inputWarnings);
      vtkInsideOut::Warn(this, made->Warnings);
    });
}
