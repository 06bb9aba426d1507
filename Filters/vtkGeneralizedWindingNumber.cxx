// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkGeneralizedWindingNumber.h"

#include "Common/Stages.h"
#include "Data/StatisticsArrays.h"
#include "In/Partitions.h"
#include "In/ReadCurve.h"
#include "In/StageParameters.h"
#include "In/WholeInput.h"
#include "Out/MakeOutputs.h"
#include "Run/AlgorithmMonitor.h"
#include "Run/RunFilter.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

using namespace insideout;

vtkStandardNewMacro(vtkGeneralizedWindingNumber);

vtkGeneralizedWindingNumber::vtkGeneralizedWindingNumber()
{
  const HullMeshParameters hull;
  this->Thicken = hull.Thicken.Width;
  this->ThickenAll = hull.Thicken.All;
  this->QuadratureOrder = hull.QuadratureOrder;
  this->Engine = static_cast<int>(hull.Budgets.Engine);
  this->TimeBudget = hull.Budgets.TimeBudget;
  this->MemoryBudget = hull.Budgets.MemoryBudget;
}

void vtkGeneralizedWindingNumber::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "Thicken: " << this->Thicken << "\n";
  os << indent << "ThickenAll: " << this->ThickenAll << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "CountDuplicates: " << this->CountDuplicates << "\n";
  os << indent << "NonParticipatingArrayName: " << this->NonParticipatingArrayName << "\n";
  os << indent << "QuadratureOrder: " << this->QuadratureOrder << "\n";
  os << indent << "Engine: " << this->Engine << "\n";
  os << indent << "TimeBudget: " << this->TimeBudget << "\n";
  os << indent << "MemoryBudget: " << this->MemoryBudget << "\n";
}

HullMeshParameters vtkInsideOut::HullParametersOf(vtkGeneralizedWindingNumber* filter)
{
  HullMeshParameters parameters;
  parameters.Chain = ChainParametersOf(filter);
  parameters.Orientation = OrientationOf(filter);
  parameters.Thicken.Width = filter->GetThicken();
  parameters.Thicken.All = filter->GetThickenAll();
  parameters.Budgets = DelaunayParametersOf(filter);
  parameters.QuadratureOrder = filter->GetQuadratureOrder();
  return parameters;
}

int vtkGeneralizedWindingNumber::FillInputPortInformation(
  int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkGeneralizedWindingNumber::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOut::RequestWhole(inputVector, outputVector);
  return 1;
}

int vtkGeneralizedWindingNumber::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOut::RunOnWhole(this, outputVector,
    [&]()
    {
      const auto input = vtkInsideOut::InputSurface(this);
      const HullMeshParameters parameters = vtkInsideOut::HullParametersOf(this);
      vtkInsideOut::RefusePlane(input, this->Thicken > 0);
      vtkInsideOut::AlgorithmMonitor monitor(this,
        { Stages::Validating, Stages::FindingIntersections, Stages::Orienting, Stages::Resolving,
          Stages::Tetrahedralizing, Stages::WindingNumbers });
      const vtkInsideOut::Surface surface =
        vtkInsideOut::ReadSurface(input, this->NonParticipatingArrayName);
      const HullMesh hull = MeshHull(surface.Soup, parameters, monitor);
      vtkInsideOut::MakeOutputs outputs(surface);
      output->ShallowCopy(outputs.MakeGrid(hull));
      vtkInsideOut::AddStatistics(hull.Statistics, output);
      outputs.AddLeftOutCells(hull.Surface, output);
      vtkInsideOut::Warn(this, hull.Warnings);
      vtkInsideOut::Warn(this, outputs.Warnings);
    });
}
