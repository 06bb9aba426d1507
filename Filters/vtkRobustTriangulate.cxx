// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRobustTriangulate.h"

#include "Common/Stages.h"
#include "In/Blocks.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/SeedsPort.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeTriangles.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/Cache.h"
#include "Run/RunFilter.h"
#include "vtkGraphCutSegmentation.h"
#include "vtkRefineTetrahedra.h"

#include <vtkGarbageCollector.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>

using namespace insideout;

vtkStandardNewMacro(vtkRobustTriangulate);

class vtkRobustTriangulate::Cache
  : public vtkInsideOut::Cache<decltype(vtkInsideOut::AsTuple(
                                 PlanarHullParameters(), std::string())),
      vtkInsideOut::KeptPlanarHull>
{
};

vtkRobustTriangulate::vtkRobustTriangulate()
  : Segmentation(vtkSmartPointer<vtkGraphCutSegmentation>::New())
  , Refinement(vtkSmartPointer<vtkRefineTetrahedra>::New())
  , Hulls(new Cache)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(5);
}

vtkRobustTriangulate::~vtkRobustTriangulate() = default;

void vtkRobustTriangulate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GenerateHull: " << this->GenerateHull << "\n";
  os << indent << "Refine: " << this->Refine << "\n";
  os << indent << "ConstrainedFacetsArrayName: " << this->ConstrainedFacetsArrayName << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "TagArrayName: " << this->TagArrayName << "\n";
  os << indent << "Segmentation:\n";
  this->Segmentation->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Refinement:\n";
  this->Refinement->PrintSelf(os, indent.GetNextIndent());
}

bool vtkRobustTriangulate::IsInAPlane(vtkPolyData* input)
{
  return input && vtkInsideOut::IsInAPlane(input);
}

vtkMTimeType vtkRobustTriangulate::GetMTime()
{
  return std::max(
    { this->Superclass::GetMTime(), this->Segmentation->GetMTime(), this->Refinement->GetMTime() });
}

void vtkRobustTriangulate::ReportReferences(vtkGarbageCollector* collector)
{
  this->Superclass::ReportReferences(collector);
  vtkGarbageCollectorReport(collector, this->Segmentation, "Segmentation");
  vtkGarbageCollectorReport(collector, this->Refinement, "Refinement");
}

void vtkRobustTriangulate::SetSegmentation(vtkGraphCutSegmentation* segmentation)
{
  vtkInsideOut::SetStage(this, segmentation, this->Segmentation);
}

vtkGraphCutSegmentation* vtkRobustTriangulate::GetSegmentation()
{
  return this->Segmentation;
}

void vtkRobustTriangulate::SetRefinement(vtkRefineTetrahedra* refinement)
{
  vtkInsideOut::SetStage(this, refinement, this->Refinement);
}

vtkRefineTetrahedra* vtkRobustTriangulate::GetRefinement()
{
  return this->Refinement;
}

// clang-format off
void vtkRobustTriangulate::SetGamma(double gamma) { this->Segmentation->SetGamma(gamma); }
double vtkRobustTriangulate::GetGamma() { return this->Segmentation->GetGamma(); }
void vtkRobustTriangulate::SetConstrainFacets(bool on) { this->Segmentation->SetConstrainFacets(on); }
bool vtkRobustTriangulate::GetConstrainFacets() { return this->Segmentation->GetConstrainFacets(); }
void vtkRobustTriangulate::SetNonManifold(int kind) { this->Segmentation->SetNonManifold(kind); }
int vtkRobustTriangulate::GetNonManifold() { return this->Segmentation->GetNonManifold(); }
void vtkRobustTriangulate::SetEdgeLength(double length) { this->Refinement->SetEdgeLength(length); }
double vtkRobustTriangulate::GetEdgeLength() { return this->Refinement->GetEdgeLength(); }
// clang-format on

void vtkRobustTriangulate::SetSeedsData(vtkDataObject* seeds)
{
  this->SetInputData(1, seeds);
}

void vtkRobustTriangulate::SetSeedsConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

int vtkRobustTriangulate::FillInputPortInformation(int port, vtkInformation* info)
{
  return vtkInsideOut::FillPort(port, info, "vtkPolyData");
}

int vtkRobustTriangulate::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool isGrid = port == 0 || port == 3;
  info->Set(vtkDataObject::DATA_TYPE_NAME(), isGrid ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

vtkPolyData* vtkRobustTriangulate::GetBoundary()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkRobustTriangulate::GetOutliers()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

vtkUnstructuredGrid* vtkRobustTriangulate::GetHull()
{
  return vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(3));
}

vtkPolyData* vtkRobustTriangulate::GetResolvedLines()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(4));
}

int vtkRobustTriangulate::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

int vtkRobustTriangulate::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

void vtkRobustTriangulate::CheckOptions()
{
  if (this->Refine && this->Refinement->GetQuadraticCells())
  {
    throw Error(ErrorCode::InvalidParameter,
      "QuadraticCells makes tetrahedra only, and the input lies in a plane");
  }
  if (this->Refine && this->Refinement->GetSurfaceTreatment() == vtkRefineTetrahedra::REMESHED)
  {
    throw Error(ErrorCode::InvalidParameter,
      "the input lies in a plane, where the boundary can be kept or split, not remeshed");
  }
  if (this->Refine &&
    (!std::string(this->Refinement->GetSizeRules()).empty() ||
      this->Refinement->GetNumberOfInputConnections(1) > 0))
  {
    throw Error(ErrorCode::InvalidParameter,
      "SizeRules and a background are of surfaces in space, and the input lies in a plane: set "
      "EdgeLength");
  }
}

int vtkRobustTriangulate::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputSurface(this);
      this->CheckOptions();
      std::vector<std::string> stages = { Stages::Validating, Stages::Resolving,
        Stages::Triangulating, Stages::Orienting, Stages::WindingNumbers, Stages::Segmenting,
        Stages::Extracting };
      if (this->Refine)
      {
        stages.emplace_back(Stages::Refining);
      }
      vtkInsideOut::AlgorithmMonitor monitor(this, stages);
      const std::vector<Seed> seeds = vtkInsideOut::ReadSeeds(vtkInsideOut::FindSeeds(inputVector));
      const vtkInsideOut::Tags tags =
        vtkInsideOut::ReadTags(input, this->TagArrayName, vtkInsideOut::FindBlocks(this));
      PlanarHullParameters parameters;
      parameters.Chain = vtkInsideOut::ChainParametersOf(this);
      parameters.Orientation = vtkInsideOut::OrientationOf(this);
      const std::string& ignored = this->NonParticipatingArrayName;
      const std::shared_ptr<vtkInsideOut::KeptPlanarHull> kept =
        this->Hulls->Get(input, vtkInsideOut::AsTuple(parameters, ignored),
          [&]() {
            return std::make_shared<vtkInsideOut::KeptPlanarHull>(
              input, parameters, ignored, monitor);
          });
      if (this->GetReleaseDataFlag())
      {
        this->Hulls->Forget(input);
      }

      vtkInsideOut::PlanarOptions options;
      options.Segment = vtkInsideOut::SegmentParametersOf(this->Segmentation.Get());
      options.ConstrainedArray = this->ConstrainedFacetsArrayName;
      options.SplitPoints = this->GetNonManifold() == vtkGraphCutSegmentation::NONMANIFOLD_SPLIT;
      options.GenerateHull = this->GenerateHull;
      options.Refine = this->Refine;
      options.Refinement = vtkInsideOut::RefinementParametersOf(this->Refinement.Get());
      if (vtkInsideOut::FollowsLengths(this->Refinement.Get()))
      {
        options.Refinement.Surface = SurfaceTreatment::Split; // in a plane there is no remeshing
      }
      const vtkInsideOut::Triangles made =
        vtkInsideOut::MakeTriangles(*kept, seeds, tags, options, monitor);
      vtkUnstructuredGrid::GetData(outputVector, 0)->ShallowCopy(made.Grid);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(made.Boundary);
      vtkPolyData::GetData(outputVector, 2)->ShallowCopy(made.Outliers);
      if (made.Hull)
      {
        vtkUnstructuredGrid::GetData(outputVector, 3)->ShallowCopy(made.Hull);
        vtkPolyData::GetData(outputVector, 4)->ShallowCopy(made.Resolved);
      }
      vtkInsideOut::Warn(this, made.Warnings);
    });
}
