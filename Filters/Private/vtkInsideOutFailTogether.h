// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutFailTogether
 * @brief   makes all processes (ranks) fail where the input of one of them fails
 *
 * VTK runs no filter whose input fails. Where the filters of all ranks talk to each other, the
 * others would wait for that one for ever. So what a filter asks of its inputs is asked here, and
 * ranks tell each other how that went before any of them goes on. While inputs are asked for
 * information it is not known yet whether all ranks work: that it failed is kept back until they
 * are asked for data. (Of extents VTK goes on where they fail.)
 *
 * What has no data object at all, as a reader that learns from its file of which type it is, is
 * beyond help: VTK comes to no filter that follows it.
 */
#pragma once

class vtkAlgorithm;
class vtkInformation;
class vtkMultiProcessController;

class vtkInsideOutFailTogether
{
public:
  /** What vtkAlgorithm::ModifyRequest is to do and to return. */
  int ModifyRequest(vtkAlgorithm* algorithm, vtkMultiProcessController* controller,
    vtkInformation* request, int when);

private:
  void AskForInformation(vtkAlgorithm* algorithm, vtkInformation* request);
  bool AskForData(
    vtkAlgorithm* algorithm, vtkMultiProcessController* controller, vtkInformation* request);

  bool HasInformation = true; ///< of the inputs, when it was asked for last
  bool IsAsking = false;      ///< for information
};
