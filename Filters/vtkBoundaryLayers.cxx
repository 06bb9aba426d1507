// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkBoundaryLayers.h"

#include "Common/Stages.h"
#include "Data/StatisticsArrays.h"
#include "In/Bodies.h"
#include "In/FollowTime.h"
#include "In/Partitions.h"
#include "In/WholeInput.h"
#include "Out/MakeLayers.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

using namespace insideout;

vtkStandardNewMacro(vtkBoundaryLayers);

vtkBoundaryLayers::vtkBoundaryLayers()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  const LayerParameters defaults;
  this->Layers = defaults.Layers;
  this->FirstHeight = defaults.FirstHeight;
  this->Growth = defaults.Growth;
}

void vtkBoundaryLayers::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "FirstHeight: " << this->FirstHeight << "\n";
  os << indent << "Growth: " << this->Growth << "\n";
  os << indent << "LayerTags: " << this->LayerTags << "\n";
}

int vtkBoundaryLayers::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkBoundaryLayers::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

vtkPolyData* vtkBoundaryLayers::GetBoundary()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkBoundaryLayers::SetBoundaryConnection(vtkAlgorithmOutput* boundary)
{
  this->SetInputConnection(1, boundary);
}

void vtkBoundaryLayers::SetBoundaryData(vtkPolyData* boundary)
{
  this->SetInputData(1, boundary);
}

int vtkBoundaryLayers::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* vtkNotUsed(outputVector))
{
  return vtkInsideOut::FollowTime(this);
}

int vtkBoundaryLayers::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector, this->GetNumberOfInputPorts());
  return 1;
}

int vtkBoundaryLayers::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* boundary = vtkPolyData::GetData(inputVector[1]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputGrid(this);
      vtkInsideOut::AlgorithmMonitor monitor(this, { Stages::Layering });
      const vtkInsideOut::Layering layering =
        vtkInsideOut::MakeLayers(input, boundary, vtkInsideOut::SplitNames(this->LayerTags),
          { this->Layers, this->FirstHeight, this->Growth }, monitor);
      output->ShallowCopy(layering.Grid);
      vtkPolyData::GetData(outputVector, 1)->ShallowCopy(layering.Boundary);
      vtkInsideOut::AddStatistics(layering.Statistics, output);
      vtkInsideOut::Warn(this, layering.Warnings);
    });
}
