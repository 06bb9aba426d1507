// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkRefineTetrahedra.h"

#include "Common/Stages.h"
#include "Data/StatisticsArrays.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/ReadLengths.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Out/RefineGrid.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkAlgorithmOutput.h>
#include <vtkDataSet.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>

using namespace insideout;

vtkStandardNewMacro(vtkRefineTetrahedra);

vtkRefineTetrahedra::vtkRefineTetrahedra()
{
  this->SetNumberOfInputPorts(2);
  const RefinementParameters defaults;
  this->EdgeLength = defaults.Sizes.EdgeLength;
  this->Grading = defaults.Sizes.Grading;
  this->MaximumVolume = defaults.Sizes.MaximumVolume;
  this->MaximumCells = static_cast<int>(defaults.MaximumCells);
  this->SurfaceTreatment = vtkRefineTetrahedra::AUTOMATIC;
  this->SurfaceTolerance = defaults.SurfaceTolerance;
  this->FeatureAngle = defaults.FeatureAngle;
}

void vtkRefineTetrahedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
  os << indent << "Grading: " << this->Grading << "\n";
  os << indent << "MaximumVolume: " << this->MaximumVolume << "\n";
  os << indent << "MaximumCells: " << this->MaximumCells << "\n";
  os << indent << "SizingArrayName: " << this->SizingArrayName << "\n";
  os << indent << "SizeRules: " << this->SizeRules << "\n";
  os << indent << "SurfaceTreatment: " << this->SurfaceTreatment << "\n";
  os << indent << "SurfaceTolerance: " << this->SurfaceTolerance << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "QuadraticCells: " << this->QuadraticCells << "\n";
}

RefinementParameters vtkInsideOut::RefinementParametersOf(vtkRefineTetrahedra* filter)
{
  static_assert(vtkRefineTetrahedra::KEPT == static_cast<int>(SurfaceTreatment::Kept));
  static_assert(vtkRefineTetrahedra::SPLIT == static_cast<int>(SurfaceTreatment::Split));
  static_assert(vtkRefineTetrahedra::REMESHED == static_cast<int>(SurfaceTreatment::Remeshed));
  RefinementParameters parameters;
  parameters.Sizes.EdgeLength = filter->GetEdgeLength();
  parameters.Sizes.Grading = filter->GetGrading();
  parameters.Sizes.MaximumVolume = filter->GetMaximumVolume();
  parameters.Sizes.Rules = ReadSizeRules(filter->GetSizeRules());
  parameters.MaximumCells = filter->GetMaximumCells();
  if (filter->GetSurfaceTreatment() != vtkRefineTetrahedra::AUTOMATIC)
  {
    parameters.Surface = static_cast<SurfaceTreatment>(filter->GetSurfaceTreatment());
  }
  else if (vtkInsideOut::FollowsLengths(filter))
  {
    parameters.Surface = SurfaceTreatment::Remeshed;
  }
  parameters.TreatsNeedles = filter->GetSurfaceTreatment() == vtkRefineTetrahedra::AUTOMATIC &&
    parameters.Surface == SurfaceTreatment::Kept;
  parameters.SurfaceTolerance = filter->GetSurfaceTolerance();
  parameters.FeatureAngle = filter->GetFeatureAngle();
  return parameters;
}

bool vtkInsideOut::FollowsLengths(vtkRefineTetrahedra* filter)
{
  return filter->GetSurfaceTreatment() == vtkRefineTetrahedra::AUTOMATIC &&
    (filter->GetEdgeLength() > 0 || !ReadSizeRules(filter->GetSizeRules()).empty() ||
      filter->GetNumberOfInputConnections(1) > 0);
}

int vtkRefineTetrahedra::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkDataSet");
  if (port != 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

void vtkRefineTetrahedra::SetBackgroundData(vtkDataObject* background)
{
  this->SetInputData(1, background);
}

void vtkRefineTetrahedra::SetBackgroundConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

int vtkRefineTetrahedra::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

namespace
{
/** Add the lengths given by arrays of an input, which may be null, and of a background. */
void AddLengths(vtkUnstructuredGrid* input, vtkDataSet* background, const std::string& name,
  SizingParameters& sizes)
{
  if (name.empty())
  {
    if (background)
    {
      throw Error(ErrorCode::InvalidParameter,
        "SizingArrayName has to say which point array of the background has edge lengths");
    }
    return;
  }
  sizes.Lengths = input ? vtkInsideOut::ReadLengths(input, name) : std::vector<double>();
  if (background)
  {
    sizes.LengthAt = vtkInsideOut::LengthsWithin(background, name);
  }
  else if (sizes.Lengths.empty())
  {
    throw Error(
      ErrorCode::InvalidParameter, "the grid has no point array " + name + " of edge lengths");
  }
}
} // namespace

void vtkInsideOut::AddBackground(vtkRefineTetrahedra* filter, SizingParameters& sizes)
{
  if (filter->GetNumberOfInputConnections(1) > 0)
  {
    filter->GetInputAlgorithm(1, 0)->Update(filter->GetInputConnection(1, 0)->GetIndex());
    const std::string name = filter->GetSizingArrayName();
    AddLengths(nullptr, JoinDataSets(filter->GetInputDataObject(1, 0), name), name, sizes);
  }
}

int vtkRefineTetrahedra::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

int vtkRefineTetrahedra::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* given = vtkDataObject::GetData(inputVector[1]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputGrid(this);
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Refining });
      RefinementParameters parameters = vtkInsideOut::RefinementParametersOf(this);
      const vtkSmartPointer<vtkDataSet> background =
        vtkInsideOut::JoinDataSets(given, this->SizingArrayName);
      AddLengths(input, background, this->SizingArrayName, parameters.Sizes);
      const std::vector<double>& lengths = parameters.Sizes.Lengths;
      const bool isWished = parameters.Sizes.LengthAt ||
        std::any_of(
          lengths.begin(), lengths.end(), [](double length) { return std::isfinite(length); });
      if (this->SurfaceTreatment == AUTOMATIC && isWished)
      {
        parameters.Surface = SurfaceTreatment::Remeshed;
        parameters.TreatsNeedles = false;
      }
      const vtkInsideOut::Refinement refinement =
        vtkInsideOut::RefineGrid(input, nullptr, parameters, this->QuadraticCells, monitor);
      output->ShallowCopy(refinement.Grid);
      vtkInsideOut::AddStatistics(refinement.Statistics, output);
      vtkInsideOut::Warn(this, refinement.Warnings);
    });
}
