// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The border between the stages, which throw, and VTK, which has events.
 */
#pragma once

#include <exception>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkInformationVector;
class vtkMultiProcessController;

namespace vtkInsideOut
{
/**
 * Do a filter's work. What it throws becomes the algorithm's error event, with its one line; a stop
 * is no error. Either way the outputs are then empty, but complete, so that every writer copes. An
 * input of a type that the filter does not take, as a block may be, is an error before the work.
 *
 * @param outputs RequestData's, or nullptr for a writer, which has none
 * @param together where several processes do the work together: whether they begin it is decided
 * for all of them
 * @return what RequestData has to: 1 when the work was done or stopped, 0 when it failed
 */
int Run(vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work,
  vtkMultiProcessController* together = nullptr);

/** The same for a filter that needs all of its input: further pieces of its output are empty. */
int RunOnWhole(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work);

/** What went wrong, in one line. */
std::string WordsOf(const std::exception& error);

/** A warning event where more threads are asked for than work. */
void WarnOfThreads(vtkAlgorithm* algorithm);

/** A warning event of the algorithm for each line. */
void Warn(vtkAlgorithm* algorithm, const std::vector<std::string>& warnings);
} // namespace vtkInsideOut
