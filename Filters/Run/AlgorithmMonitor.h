// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   AlgorithmMonitor
 * @brief reports the stages' progress as a VTK algorithm's, and passes on its abort flag
 */
#pragma once

#include "Common/Monitor.h"
#include "Data/VtkClasses.h"

#include <chrono>
#include <string>
#include <vector>

namespace vtkInsideOut
{
class AlgorithmMonitor : public insideout::Monitor
{
public:
  /**
   * @param stages the names of the stages (Common/Stages.h) that the algorithm runs, in order. Each
   * takes an equal share of the progress, so that an observer can derive the stage's own progress.
   * Observers are called at least five times a second if the stage asks as frequently, also without
   * progress: they may want to stop it. A report of an unlisted stage causes a warning event, which
   * tests check; the work continues.
   */
  AlgorithmMonitor(vtkAlgorithm* algorithm, std::vector<std::string> stages);

  /** Clears the progress text, so that the next run does not begin with the last stage's name. */
  ~AlgorithmMonitor() override;

  bool Continue(const char* stage, double fraction) override;

  /** Whether the algorithm was asked to stop. */
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
