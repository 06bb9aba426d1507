// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/WholeInput.h"

#include "Common/Error.h"
#include "In/Blocks.h"

#include <vtkAlgorithm.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationExecutivePortKey.h>
#include <vtkInformationIntegerKey.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>

namespace vtkInsideOut
{
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
vtkInformationIntegerKey* PartsAreWhole()
{
  static auto* const key = vtkInformationIntegerKey::MakeKey("PARTS_ARE_WHOLE", "vtkInsideOut");
  return key;
}

/** The data of an algorithm's input, or null. */
vtkInformation* FirstInput(vtkExecutive* executive)
{
  vtkAlgorithm* algorithm = executive ? executive->GetAlgorithm() : nullptr;
  return algorithm && algorithm->GetNumberOfInputPorts() > 0 &&
      algorithm->GetNumberOfInputConnections(0) > 0
    ? executive->GetInputInformation(0, 0)
    : nullptr;
}

/** Whether an input consists of parts that were distributed upstream. */
bool AreSpreadParts(vtkInformation* input)
{
  bool areWhole = false;
  for (vtkInformation* each = input; each && !areWhole;
       each = FirstInput(vtkExecutive::PRODUCER()->GetExecutive(each)))
  {
    areWhole = each->Has(PartsAreWhole()) != 0;
  }
  return areWhole && HasBlocks(input);
}
} // namespace

void SayWhetherPartsAreWhole(vtkInformation* output, bool areWhole)
{
  if (areWhole)
  {
    output->Set(PartsAreWhole(), 1);
  }
  else
  {
    output->Remove(PartsAreWhole());
  }
}

bool IsFurtherPiece(vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector ? outputVector->GetInformationObject(0) : nullptr;
  return output && output->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0;
}

bool IsIdle(vtkAlgorithm* algorithm, vtkInformationVector* outputVector)
{
  vtkInformation* input = FirstInput(algorithm->GetExecutive());
  return (IsFurtherPiece(outputVector) && !(input && AreSpreadParts(input))) ||
    IsFurtherPartition(algorithm);
}

void RefuseSpreadParts(vtkAlgorithm* algorithm)
{
  for (int i = 0; i < algorithm->GetNumberOfInputConnections(0); ++i)
  {
    vtkInformation* input = algorithm->GetExecutive()->GetInputInformation(0, i);
    // A process that works alone has requested everything, and has all parts.
    if (input->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) > 1 && AreSpreadParts(input))
    {
      throw insideout::Error(insideout::ErrorCode::InvalidParameter,
        "vtkDistributeParts has spread the blocks over processes, and they are to be one mesh: "
        "leave it out");
    }
  }
}

void RequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, int numberOfPorts)
{
  bool areParts = false;
  for (int port = 0; port < numberOfPorts; ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* input = inputVector[port]->GetInformationObject(i);
      RememberBlocks(input);
      areParts = areParts || (port == 0 && AreSpreadParts(input));
      if (areParts && port == 0)
      {
        continue; // each process requests its own
      }
      const bool isIdle = IsFurtherPiece(outputVector) && !areParts;
      input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), isIdle ? 0 : 1);
      input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
}
} // namespace vtkInsideOut
