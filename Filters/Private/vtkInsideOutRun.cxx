// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutRun.h"

#include "vtkInsideOutMonitor.h"
#include "vtkInsideOutWholeInput.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <exception>

namespace
{
using FieldData = std::vector<vtkSmartPointer<vtkFieldData>>;

/** VTK has put the input's field data on each output by now; whatever the work does keeps them. */
FieldData FieldDataOf(vtkInformationVector* outputs)
{
  FieldData fields;
  for (int port = 0; outputs && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    fields.push_back(vtkSmartPointer<vtkFieldData>::New());
    fields.back()->ShallowCopy(vtkDataObject::GetData(outputs, port)->GetFieldData());
  }
  return fields;
}

void AddFieldData(const FieldData& fields, vtkInformationVector* outputs)
{
  for (std::size_t port = 0; port < fields.size(); ++port)
  {
    vtkFieldData* output = vtkDataObject::GetData(outputs, static_cast<int>(port))->GetFieldData();
    for (int i = 0; i < fields[port]->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = fields[port]->GetAbstractArray(i);
      if (!array->GetName() || !output->HasArray(array->GetName()))
      {
        output->AddArray(array);
      }
    }
  }
}

/** VTK's XML writers crash on a grid that has no cell array at all. */
void MakeEmpty(vtkInformationVector* outputs)
{
  for (int port = 0; outputs && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    output->Initialize();
    if (auto* points = vtkPointSet::SafeDownCast(output))
    {
      points->SetPoints(vtkNew<vtkPoints>());
    }
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(output))
    {
      grid->SetCells(VTK_TETRA, vtkNew<vtkCellArray>());
    }
  }
}
} // namespace

int vtkInsideOutRun(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work)
{
  const FieldData fields = FieldDataOf(outputs);
  try
  {
    MakeEmpty(outputs);
    if (vtkInsideOutMonitor::ShouldAbort(algorithm))
    {
      return 1;
    }
    work();
    AddFieldData(fields, outputs);
    return 1;
  }
  catch (const insideout::Error& error)
  {
    MakeEmpty(outputs);
    if (error.Code == insideout::ErrorCode::Stopped)
    {
      return 1;
    }
    vtkErrorWithObjectMacro(algorithm, << error.what());
  }
  catch (const std::bad_alloc&)
  {
    MakeEmpty(outputs);
    vtkErrorWithObjectMacro(algorithm, << "out of memory");
  }
  catch (const std::exception& error)
  {
    MakeEmpty(outputs);
    vtkErrorWithObjectMacro(algorithm, << "internal error: " << error.what());
  }
  return 0;
}

int vtkInsideOutRunOnWhole(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work)
{
  const bool isFurtherPiece = vtkInsideOutIsFurtherPiece(outputs);
  return vtkInsideOutRun(algorithm, outputs, isFurtherPiece ? std::function<void()>([] {}) : work);
}

void vtkInsideOutWarn(vtkAlgorithm* algorithm, const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    vtkWarningWithObjectMacro(algorithm, << warning);
  }
}
