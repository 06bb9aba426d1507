// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * @class   FailTogether
 * @brief   makes all processes (ranks) fail where the input of one of them fails
 *
 * VTK runs no filter whose input fails. Where the filters of all ranks talk to each other, the
 * others would wait for that one for ever. So what a filter asks of its inputs is asked here, and
 * ranks tell each other how that went before any of them goes on. While inputs are asked for data
 * objects and information it is not known yet whether all ranks work: that it failed is kept back
 * until they are asked for data. An input without a data object, as of a reader that learns from
 * its file of which type it is, has an empty one until then. (VTK goes on where requests for
 * extents fail.)
 */
#pragma once

class vtkAlgorithm;
class vtkInformation;
class vtkInformationRequestKey;
class vtkMultiProcessController;

namespace vtkInsideOut
{
class FailTogether
{
public:
  /** The work and the result of vtkAlgorithm::ModifyRequest. */
  int ModifyRequest(vtkAlgorithm* algorithm, vtkMultiProcessController* controller,
    vtkInformation* request, int when);

private:
  bool AskForDataObjects(vtkAlgorithm* algorithm, vtkInformation* request);
  bool AskForInformation(vtkAlgorithm* algorithm, vtkInformation* request);
  bool AskForData(
    vtkAlgorithm* algorithm, vtkMultiProcessController* controller, vtkInformation* request);

  vtkInformationRequestKey* Held = nullptr; ///< what VTK is not to ask again
  bool HasDataObjects = true;               ///< whether all inputs had, when they were asked last
  bool HasInformation = true;
};
} // namespace vtkInsideOut
