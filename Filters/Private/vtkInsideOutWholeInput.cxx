// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkInsideOutWholeInput.h"

#include "vtkInsideOutBlock.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkStreamingDemandDrivenPipeline.h>

using Pipeline = vtkStreamingDemandDrivenPipeline;

bool vtkInsideOutIsFurtherPiece(vtkInformationVector* outputVector)
{
  vtkInformation* output = outputVector ? outputVector->GetInformationObject(0) : nullptr;
  return output && output->Has(Pipeline::UPDATE_PIECE_NUMBER()) &&
    output->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0;
}

void vtkInsideOutRequestWhole(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, int numberOfPorts)
{
  for (int port = 0; port < numberOfPorts; ++port)
  {
    vtkInformation* input = inputVector[port]->GetInformationObject(0);
    if (!input)
    {
      continue;
    }
    vtkInsideOutRememberBlocks(input);
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(
      Pipeline::UPDATE_NUMBER_OF_PIECES(), vtkInsideOutIsFurtherPiece(outputVector) ? 0 : 1);
    input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}
