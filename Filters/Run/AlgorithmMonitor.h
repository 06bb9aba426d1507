// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   AlgorithmMonitor
 * @brief   shows the progress of the stages as a VTK algorithm's, and passes on its abort flag
 */
#pragma once

#include "Common/Monitor.h"

#include <chrono>
#include <string>
#include <vector>

class vtkAlgorithm;

namespace vtkInsideOut
{
class AlgorithmMonitor : public insideout::Monitor
{
public:
  /**
   * @param stages the names of the stages (Common/Stages.h) that the algorithm runs, in order. Each
   * takes an equal share of the progress, so that an observer can tell the stage's own progress
   * from it. Observers hear of it at least five times a second as long as the stage asks that
   * often, also where there is none: they may want to stop it. A stage that reports and is not
   * among them gives a warning event, which tests listen to; the work goes on.
   */
  AlgorithmMonitor(vtkAlgorithm* algorithm, std::vector<std::string> stages);

  /** Clears the progress text, lest the last stage's name stand at the beginning of the next run.
   */
  ~AlgorithmMonitor() override;

  bool Continue(const char* stage, double fraction) override;

  /** Whether somebody wants the algorithm to stop. */
  static bool ShouldAbort(vtkAlgorithm* algorithm);

private:
  void WarnOnce(const char* unknownStage);

  vtkAlgorithm* Algorithm;
  std::vector<std::string> Stages;
  std::size_t Stage = 0;
  bool Warned = false;
  double Shown = -1;
  std::chrono::steady_clock::time_point LastShown;
};
} // namespace vtkInsideOut
