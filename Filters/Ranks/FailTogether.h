// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * @class   FailTogether
 * @brief makes all processes (ranks) fail if the input of one of them fails
 *
 * VTK does not run a filter whose input fails. If the filters of all ranks communicate, the others
 * would wait for it for ever. So a filter's requests to its inputs are made here, and ranks
 * exchange the results before any of them continues. During requests for data objects and
 * information it is not known yet whether all ranks work: a failure is held back until data are
 * requested. An input without a data object, such as a reader that learns its type from the file,
 * has an empty one until then. (VTK continues if requests for extents fail.)
 */
#pragma once

#include "Data/VtkClasses.h"

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

  vtkInformationRequestKey* Held = nullptr; ///< VTK must not repeat the request
  bool HasDataObjects = true;               ///< whether all inputs had data at the last request
  bool HasInformation = true;
};
} // namespace vtkInsideOut
