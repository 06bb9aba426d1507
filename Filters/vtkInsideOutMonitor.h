// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutMonitor
 * @brief   Shows the progress of InsideOut's stages as a VTK algorithm's, and passes on its abort
 * flag.
 */
#ifndef vtkInsideOutMonitor_h
#define vtkInsideOutMonitor_h

#include "Common/Monitor.h"

#include <chrono>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkInformationVector;

class vtkInsideOutMonitor : public insideout::Monitor
{
public:
  /**
   * @param stages the names of the stages that the algorithm runs, in order. Each takes an equal
   * share of the progress, so that an observer can tell the stage's own progress from it. Observers
   * hear of it at least five times a second as long as the stage asks that often, also where there
   * is none: they may want to stop it.
   */
  vtkInsideOutMonitor(vtkAlgorithm* algorithm, std::vector<std::string> stages);

  /** The algorithm does nothing any more: the name of its last stage is not to stand at the next
   * run's beginning. */
  ~vtkInsideOutMonitor() override;

  bool Continue(const char* stage, double fraction) override;

private:
  vtkAlgorithm* Algorithm;
  std::vector<std::string> Stages;
  std::size_t Stage = 0;
  double Shown = -1;
  std::chrono::steady_clock::time_point LastShown;
};

/**
 * Do a filter's work. What it throws becomes the algorithm's error event, with its one line; a stop
 * is no error. Either way the outputs are then empty, but complete, so that every writer copes.
 *
 * @param outputs RequestData's, or nullptr for a writer, which has none
 * @return what RequestData has to: 1 when the work was done or stopped, 0 when it failed
 */
int vtkInsideOutRun(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work);

/** The same for a filter that needs all of its input: further pieces of its output are empty. */
int vtkInsideOutRunOnWhole(
  vtkAlgorithm* algorithm, vtkInformationVector* outputs, const std::function<void()>& work);

/** A warning event of the algorithm for each line. */
void vtkInsideOutWarn(vtkAlgorithm* algorithm, const std::vector<std::string>& warnings);

#endif
