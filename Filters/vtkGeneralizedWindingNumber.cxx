// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkGeneralizedWindingNumber.h"

#include "Common/Stages.h"
#include "Private/vtkInsideOutMakeOutputs.h"
#include "Private/vtkInsideOutMonitor.h"
#include "Private/vtkInsideOutOptions.h"
#include "Private/vtkInsideOutReadCurve.h"
#include "Private/vtkInsideOutRun.h"
#include "Private/vtkInsideOutWholeInput.h"

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

int vtkGeneralizedWindingNumber::FillInputPortInformation(
  int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkGeneralizedWindingNumber::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInsideOutRequestWhole(inputVector, outputVector);
  return 1;
}

int vtkGeneralizedWindingNumber::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return vtkInsideOutRunOnWhole(this, outputVector,
    [&]()
    {
      const HullMeshParameters parameters = vtkInsideOutHullMeshParameters(this);
      vtkInsideOutRefusePlane(input, this->Thicken > 0);
      vtkInsideOutMonitor monitor(this,
        { Stages::Validating, Stages::FindingIntersections, Stages::Orienting, Stages::Resolving,
          Stages::Tetrahedralizing, Stages::WindingNumbers });
      const vtkInsideOutSurface surface =
        vtkInsideOutReadSurface(input, this->NonParticipatingArrayName);
      const HullMesh hull = MeshHull(surface.Soup, parameters, monitor);
      vtkInsideOutMakeOutputs outputs(surface);
      output->ShallowCopy(outputs.MakeGrid(hull));
      vtkInsideOutAddStatistics(hull.Statistics, output);
      outputs.AddLeftOutCells(hull.Surface, output);
      vtkInsideOutWarn(this, hull.Warnings);
      vtkInsideOutWarn(this, outputs.Warnings);
    });
}
