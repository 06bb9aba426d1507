// SPDX-License-Identifier: GPL-3.0-or-later
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

#include <algorithm>
#include <exception>

namespace
{
// VTK 9.2 and later ask every algorithm upstream too; 9.1 knows only the algorithm's own flag.
template <typename Algorithm>
auto ShouldAbort(Algorithm* algorithm, int) -> decltype(algorithm->CheckAbort(), bool())
{
  return algorithm->CheckAbort();
}

template <typename Algorithm>
bool ShouldAbort(Algorithm* algorithm, long)
{
  return algorithm->GetAbortExecute() != 0;
}
} // namespace

vtkInsideOutMonitor::vtkInsideOutMonitor(vtkAlgorithm* algorithm, std::vector<std::string> stages)
  : Algorithm(algorithm)
  , Stages(std::move(stages))
{
}

vtkInsideOutMonitor::~vtkInsideOutMonitor()
{
  this->Algorithm->SetProgressText(nullptr);
}

bool vtkInsideOutMonitor::Continue(const char* stage, double fraction)
{
  const auto found = std::find(this->Stages.begin() + this->Stage, this->Stages.end(), stage);
  if (found != this->Stages.end() && found != this->Stages.begin() + this->Stage)
  {
    this->Stage = found - this->Stages.begin();
    this->Shown = -1;
  }
  const double progress = std::max(
    this->Shown, (this->Stage + std::min(std::max(fraction, 0.0), 1.0)) / this->Stages.size());
  constexpr double SmallestStepShown = 0.002;
  constexpr std::chrono::milliseconds LongestSilence(200);
  const auto now = std::chrono::steady_clock::now();
  if (this->Shown < 0 || progress - this->Shown >= SmallestStepShown ||
    now - this->LastShown >= LongestSilence)
  {
    this->Shown = progress;
    this->LastShown = now;
    this->Algorithm->SetProgressText(this->Stages[this->Stage].c_str());
    this->Algorithm->UpdateProgress(progress);
  }
  return !ShouldAbort(this->Algorithm, 0);
}

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
    if (ShouldAbort(algorithm, 0))
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
