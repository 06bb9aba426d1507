// SPDX-License-Identifier: GPL-3.0-or-later
#include "Run/RunFilter.h"

#include "Data/Label.h"
#include "Data/StatisticsArrays.h"
#include "In/Blocks.h"
#include "In/WholeInput.h"
#include "Ranks/Together.h"
#include "Run/AlgorithmMonitor.h"

#include "Common/Team.h"
#include "Common/ThreadLocals.h"

#include <vtkAbstractArray.h>
#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringVectorKey.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <new>

namespace vtkInsideOut
{
namespace
{
/**
 * The smaller limit of vtkSMPTools (Initialize, LocalScope) and VTK_SMP_MAX_THREADS, which VTK's
 * own backends use only without the former; 0 for neither. A sequential backend is no limit: it is
 * the default of many builds. VTK's public functions report the backend only; the internal one is
 * the same from 9.1 to 9.7.
 */
int ThreadLimitOfVtk()
{
  const int told =
    vtk::detail::smp::vtkSMPToolsAPI::GetInstance().GetInternalDesiredNumberOfThread();
  const char* variable = std::getenv("VTK_SMP_MAX_THREADS");
  const int most = variable ? std::atoi(variable) : 0;
  return told > 0 && most > 0 ? std::min(told, most) : std::max({ told, most, 0 });
}

const bool IsLimitFollowed = (insideout::SetHostLimit(ThreadLimitOfVtk), true);

using FieldData = std::vector<vtkSmartPointer<vtkFieldData>>;

/** The existing outputs: of some types VTK makes none for a block of a composite data set. */
std::vector<vtkDataObject*> OutputsOf(vtkInformationVector* outputs)
{
  std::vector<vtkDataObject*> all;
  for (int port = 0; outputs && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      all.push_back(output);
    }
  }
  return all;
}

/** VTK has put the input's field data on each output by now; the work keeps them. */
FieldData FieldDataOf(vtkInformationVector* outputs)
{
  FieldData fields;
  for (vtkDataObject* output : OutputsOf(outputs))
  {
    fields.push_back(vtkSmartPointer<vtkFieldData>::New());
    fields.back()->ShallowCopy(output->GetFieldData());
  }
  return fields;
}

void AddFieldData(const FieldData& fields, vtkInformationVector* outputs)
{
  const std::vector<vtkDataObject*> all = OutputsOf(outputs);
  for (std::size_t port = 0; port < fields.size(); ++port)
  {
    KeepStatistics(fields[port], all[port]);
    vtkFieldData* output = all[port]->GetFieldData();
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

/** VTK's XML writers crash on a grid without cell arrays. */
void MakeEmpty(vtkInformationVector* outputs)
{
  for (vtkDataObject* output : OutputsOf(outputs))
  {
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

/**
 * VTK checks the type of an input, but not of the blocks of a composite data set, which become the
 * input one by one.
 *
 * @throws insideout::Error InvalidParameter
 */
void CheckTypesOfInputs(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    vtkInformation* wanted = algorithm->GetInputPortInformation(port);
    const int types = wanted->Length(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* input = algorithm->GetInputDataObject(port, i);
      bool fits = !input || types == 0;
      std::string words;
      for (int t = 0; t < types && !fits; ++t)
      {
        const char* type = wanted->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), t);
        fits = input->IsA(type) != 0;
        words += (t == 0 ? "" : " or ") + std::string(type);
      }
      if (!fits)
      {
        throw insideout::Error(insideout::ErrorCode::InvalidParameter,
          std::string("the input is a ") + input->GetClassName() + ", not a " + words);
      }
    }
  }
}

/** Checks before the work. @throws insideout::Error Stopped, InvalidParameter */
void Begin(vtkAlgorithm* algorithm, vtkInformationVector* outputs)
{
  MakeEmpty(outputs);
  insideout::AllocateThreadLocals();
  if (AlgorithmMonitor::ShouldAbort(algorithm))
  {
    throw insideout::Error(insideout::ErrorCode::Stopped, "stopped before it began");
  }
  CheckTypesOfInputs(algorithm);
  if (outputs &&
    OutputsOf(outputs).size() < static_cast<std::size_t>(algorithm->GetNumberOfOutputPorts()))
  {
    throw insideout::Error(insideout::ErrorCode::InvalidParameter,
      "VTK makes no output of this type for the blocks of a composite data set");
  }
}
} // namespace

int Run(vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work,
  vtkMultiProcessController* together)
{
  const FieldData fields = FieldDataOf(outputs);
  try
  {
    DoTogether(together, [&] { Begin(algorithm, outputs); });
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
    vtkErrorWithObjectMacro(algorithm, << Label(algorithm) << Block(algorithm) << WordsOf(error));
  }
  catch (const std::exception& error)
  {
    MakeEmpty(outputs);
    vtkErrorWithObjectMacro(algorithm, << Label(algorithm) << Block(algorithm) << WordsOf(error));
  }
  return 0;
}

int RunOnWhole(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work)
{
  const bool isIdle = IsIdle(algorithm, outputs);
  return Run(algorithm, outputs,
    [&]()
    {
      if (!isIdle)
      {
        WarnOfThreads(algorithm);
        work();
      }
    });
}

std::string WordsOf(const std::exception& error)
{
  if (dynamic_cast<const insideout::Error*>(&error))
  {
    return error.what();
  }
  if (dynamic_cast<const std::bad_alloc*>(&error))
  {
    return "not enough memory for this surface";
  }
  return std::string("internal error: ") + error.what();
}

void WarnOfThreads(vtkAlgorithm* algorithm)
{
  const std::string warning = insideout::TooManyThreads();
  if (!warning.empty())
  {
    Warn(algorithm, { warning });
  }
}

void Warn(vtkAlgorithm* algorithm, const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    vtkWarningWithObjectMacro(algorithm, << Label(algorithm) << Block(algorithm) << warning);
  }
}
} // namespace vtkInsideOut
