// SPDX-License-Identifier: GPL-3.0-or-later
#include "In/PieceOfInput.h"

#include "Common/Error.h"

#include <vtkAlgorithm.h>
#include <vtkAlgorithmOutput.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <string>

namespace vtkInsideOut
{
using insideout::Error;
using insideout::ErrorCode;
using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace
{
/** Whether a request for a piece makes its sources give a piece: a data set that is already there
 * would be given whole each time. */
bool MakesPieces(vtkAlgorithmOutput* output)
{
  vtkAlgorithm* maker = output->GetProducer();
  bool doAll = true;
  bool isSource = true;
  for (int port = 0; port < maker->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < maker->GetNumberOfInputConnections(port); ++i)
    {
      isSource = false;
      doAll = doAll && MakesPieces(maker->GetInputConnection(port, i));
    }
  }
  return isSource ? !maker->IsA("vtkTrivialProducer") &&
      maker->GetOutputInformation(output->GetIndex())->Has(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST())
                  : doAll;
}
} // namespace

vtkDataObject* PieceOfInput(vtkAlgorithm* algorithm, int port, int piece, int pieces)
{
  vtkAlgorithmOutput* input = algorithm->GetInputConnection(port, 0);
  vtkAlgorithm* maker = input->GetProducer();
  if (!MakesPieces(input))
  {
    throw Error(ErrorCode::InvalidParameter,
      "the surface is to be read in " + std::to_string(pieces) +
        " pieces, and its source makes none");
  }
  if (piece > 0)
  {
    vtkNew<vtkInformationVector> requests; // one per output of the maker
    requests->SetNumberOfInformationObjects(input->GetIndex() + 1);
    vtkInformation* request = requests->GetInformationObject(input->GetIndex());
    request->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
    request->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
    request->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (!maker->Update(input->GetIndex(), requests))
    {
      throw Error(ErrorCode::InvalidParameter,
        "piece " + std::to_string(piece) + " of the surface cannot be made");
    }
  }
  return maker->GetOutputDataObject(input->GetIndex());
}
} // namespace vtkInsideOut
