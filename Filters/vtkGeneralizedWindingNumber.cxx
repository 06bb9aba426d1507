// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkGeneralizedWindingNumber.h"

#include "vtkInsideOutConversion.h"
#include "vtkInsideOutMonitor.h"
#include "vtkInsideOutWholeInput.h"

#include <vtkCellData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

using namespace insideout;

vtkStandardNewMacro(vtkGeneralizedWindingNumber);

vtkGeneralizedWindingNumber::vtkGeneralizedWindingNumber() = default;

void vtkGeneralizedWindingNumber::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Orientation: " << this->Orientation << "\n";
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
      vtkInsideOutMonitor monitor(this,
        { "validating", "finding self-intersections", "resolving self-intersections",
          "tetrahedralizing", "winding numbers" });
      vtkInsideOutConversion conversion(input, this->NonParticipatingArrayName);
      const HullMesh hull = MeshHull(conversion.Soup,
        { { this->MergeTolerance, this->CountDuplicates },
          static_cast<insideout::Orientation>(this->Orientation),
          { this->TimeBudget, this->MemoryBudget,
            static_cast<TetrahedralizationEngine>(this->Engine) },
          this->QuadratureOrder },
        monitor);
      output->ShallowCopy(conversion.MakeGrid(hull));
      vtkInsideOutAddStatistics(hull.Statistics, output);
      conversion.AddLeftOutCells(hull.Surface, output);
      vtkInsideOutWarn(this, hull.Warnings);
      vtkInsideOutWarn(this, conversion.Warnings);
    });
}
