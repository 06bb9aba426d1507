// SPDX-License-Identifier: GPL-3.0-or-later
#include "Ranks/FailTogether.h"

#include "Data/Label.h"
#include "Ranks/Gather.h"
#include "Ranks/Together.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkDataObject.h>
#include <vtkDataObjectTypes.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationRequestKey.h>
#include <vtkMultiProcessController.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <string>

namespace vtkInsideOut
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
/** As vtkExecutive::ForwardUpstream does. */
bool Forward(vtkAlgorithm* algorithm, vtkInformation* request)
{
  bool isDone = true;
  const int from = request->Get(vtkExecutive::FROM_OUTPUT_PORT());
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkExecutive* producer = algorithm->GetInputExecutive(port, i);
      request->Set(
        vtkExecutive::FROM_OUTPUT_PORT(), algorithm->GetInputConnection(port, i)->GetIndex());
      isDone = producer->ProcessRequest(
                 request, producer->GetInputInformation(), producer->GetOutputInformation()) &&
        isDone;
    }
  }
  request->Set(vtkExecutive::FROM_OUTPUT_PORT(), from);
  return isDone;
}

/** VTK stops without data of a type that the algorithm accepts. */
void GiveDataObjects(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    const char* type =
      algorithm->GetInputPortInformation(port)->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), 0);
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkInformation* input = algorithm->GetExecutive()->GetInputInformation(port, i);
      if (!input->Has(vtkDataObject::DATA_OBJECT()))
      {
        const auto empty = vtk::TakeSmartPointer(vtkDataObjectTypes::NewDataObject(
          std::string(type) == "vtkDataSet" ? "vtkPolyData" : type));
        input->Set(vtkDataObject::DATA_OBJECT(), empty);
      }
    }
  }
}

/** VTK stops without an extent if the data may be structured. */
void GiveExtents(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkInformation* input = algorithm->GetExecutive()->GetInputInformation(port, i);
      if (!input->Has(Pipeline::WHOLE_EXTENT()))
      {
        input->Set(Pipeline::WHOLE_EXTENT(), 0, -1, 0, -1, 0, -1);
      }
    }
  }
}
} // namespace

bool FailTogether::AskForDataObjects(vtkAlgorithm* algorithm, vtkInformation* request)
{
  this->HasDataObjects = Forward(algorithm, request);
  if (!this->HasDataObjects)
  {
    GiveDataObjects(algorithm);
  }
  return this->HasDataObjects;
}

bool FailTogether::AskForInformation(vtkAlgorithm* algorithm, vtkInformation* request)
{
  this->HasInformation = Forward(algorithm, request);
  if (!this->HasInformation || !this->HasDataObjects)
  {
    GiveExtents(algorithm);
  }
  return this->HasInformation;
}

bool FailTogether::AskForData(
  vtkAlgorithm* algorithm, vtkMultiProcessController* controller, vtkInformation* request)
{
  const bool hasData = this->HasDataObjects && this->HasInformation && Forward(algorithm, request);
  if (!AllRanksWork(controller, algorithm->GetOutputInformation(0)))
  {
    return hasData;
  }
  const std::string failed = RanksThat(!hasData, controller);
  if (failed.empty())
  {
    return true;
  }
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    algorithm->GetOutputDataObject(port)->Initialize();
  }
  vtkErrorWithObjectMacro(algorithm, << Label(algorithm) << "the input of process " << failed
                                     << " fails, so that there is no output in any process");
  return false;
}

int FailTogether::ModifyRequest(
  vtkAlgorithm* algorithm, vtkMultiProcessController* controller, vtkInformation* request, int when)
{
  const bool isBefore = when == vtkExecutive::BeforeForward;
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return 1;
  }
  if (isBefore && request->Has(Pipeline::REQUEST_DATA()))
  {
    return this->AskForData(algorithm, controller, request);
  }
  if (isBefore)
  {
    const bool isDone = request->Has(Pipeline::REQUEST_DATA_OBJECT())
      ? this->AskForDataObjects(algorithm, request)
      : !request->Has(Pipeline::REQUEST_INFORMATION()) ||
        this->AskForInformation(algorithm, request);
    if (!isDone)
    {
      this->Held = request->GetRequest();
      request->Remove(this->Held); // VTK would request again, and give up
    }
  }
  else if (this->Held)
  {
    request->Set(this->Held);
    this->Held = nullptr;
  }
  return 1;
}
} // namespace vtkInsideOut
