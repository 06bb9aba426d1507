// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The border between the stages, which throw, and VTK, which has events.
 */
#pragma once

#include "Data/VtkClasses.h"

#include <exception>
#include <functional>
#include <string>
#include <vector>

namespace vtkInsideOut
{
/**
 * Do a filter's work. An exception becomes the algorithm's error event, with its one line; a stop
 * is no error. In both cases the outputs are empty, but complete, so that every writer can write
 * them. An input of a type that the filter does not accept, as a block may be, is an error before
 * the work.
 *
 * @param outputs RequestData's, or nullptr for a writer, which has none
 * @param together for work of several processes together: whether to begin is decided for all of
 * them
 * @return the value for RequestData: 1 if the work was done or stopped, 0 if it failed
 */
int Run(vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work,
  vtkMultiProcessController* together = nullptr);

/** The same for a filter that needs all of its input: other pieces of its output are empty. */
int RunOnWhole(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work);

/** The error in one line. */
std::string WordsOf(const std::exception& error);

/** A warning event if more threads are requested than work. */
void WarnOfThreads(vtkAlgorithm* algorithm);

/** A warning event of the algorithm for each line. */
void Warn(vtkAlgorithm* algorithm, const std::vector<std::string>& warnings);
} // namespace vtkInsideOut
