// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/FollowTime.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkInformationIntegerKey.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <set>
#include <vector>

namespace vtkInsideOut
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
std::vector<vtkInformation*> InputsOf(vtkAlgorithm* algorithm)
{
  std::vector<vtkInformation*> inputs;
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      inputs.push_back(algorithm->GetExecutive()->GetInputInformation(port, i));
    }
  }
  return inputs;
}

std::vector<double> ValuesOf(vtkInformation* information, vtkInformationDoubleVectorKey* key)
{
  const double* values = information->Get(key);
  return values ? std::vector<double>(values, values + information->Length(key))
                : std::vector<double>();
}

void Set(vtkInformation* information, vtkInformationDoubleVectorKey* key,
  const std::vector<double>& values)
{
  if (values.empty())
  {
    information->Remove(key);
  }
  else
  {
    information->Set(key, values.data(), static_cast<int>(values.size()));
  }
}

void UniteTimes(vtkAlgorithm* algorithm)
{
  std::set<double> steps;
  std::set<double> ends;
  bool changeInTime = false; // the information itself
  for (vtkInformation* input : InputsOf(algorithm))
  {
    const std::vector<double> stepsOfInput = ValuesOf(input, Pipeline::TIME_STEPS());
    const std::vector<double> range = ValuesOf(input, Pipeline::TIME_RANGE());
    steps.insert(stepsOfInput.begin(), stepsOfInput.end());
    ends.insert(stepsOfInput.begin(), stepsOfInput.end());
    ends.insert(range.begin(), range.end());
    changeInTime = changeInTime || input->Has(Pipeline::TIME_DEPENDENT_INFORMATION());
  }
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkInformation* output = algorithm->GetOutputInformation(port);
    Set(output, Pipeline::TIME_STEPS(), { steps.begin(), steps.end() });
    Set(output, Pipeline::TIME_RANGE(),
      ends.empty() ? std::vector<double>() : std::vector<double>{ *ends.begin(), *ends.rbegin() });
    if (changeInTime)
    {
      output->Set(Pipeline::TIME_DEPENDENT_INFORMATION(), 1);
    }
  }
}

/** VTK marks outputs with the time of the first input's data, which differs from the requested one
 * if another input is time-dependent. The executive has passed the requested time on to all inputs.
 */
void MarkWithTime(vtkAlgorithm* algorithm)
{
  const std::vector<vtkInformation*> inputs = InputsOf(algorithm);
  const bool othersMove = !inputs.empty() &&
    std::any_of(inputs.begin() + 1, inputs.end(),
      [](vtkInformation* input) { return input->Has(Pipeline::TIME_RANGE()) != 0; });
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = algorithm->GetOutputDataObject(port);
    if (output && othersMove && inputs.front()->Has(Pipeline::UPDATE_TIME_STEP()))
    {
      output->GetInformation()->Set(
        vtkDataObject::DATA_TIME_STEP(), inputs.front()->Get(Pipeline::UPDATE_TIME_STEP()));
    }
  }
}

/** Called before the executive reads the time of the outputs. */
class AfterExecution : public vtkCommand
{
public:
  static AfterExecution* New() { return new AfterExecution; }
  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(caller))
    {
      UniteTimes(algorithm);
      MarkWithTime(algorithm);
    }
  }
};
} // namespace

int FollowTime(vtkAlgorithm* algorithm)
{
  static vtkNew<AfterExecution> afterExecution;
  if (!algorithm->HasObserver(vtkCommand::EndEvent, afterExecution))
  {
    algorithm->AddObserver(vtkCommand::EndEvent, afterExecution);
  }
  UniteTimes(algorithm);
  return 1;
}
} // namespace vtkInsideOut
