// SPDX-License-Identifier: GPL-3.0-or-later
#include "Run/AlgorithmMonitor.h"

#include "Data/Label.h"
#include "vtkInsideOutVersions.h"

#include <vtkAlgorithm.h>

#include <algorithm>

namespace vtkInsideOut
{
AlgorithmMonitor::AlgorithmMonitor(vtkAlgorithm* algorithm, std::vector<std::string> stages)
  : Algorithm(algorithm)
  , Stages(std::move(stages))
{
}

AlgorithmMonitor::~AlgorithmMonitor()
{
  this->Algorithm->SetProgressText(nullptr);
}

bool AlgorithmMonitor::ShouldAbort(vtkAlgorithm* algorithm)
{
  return IsAborted(algorithm, 0);
}

bool AlgorithmMonitor::Continue(const char* stage, double fraction)
{
  const std::size_t found =
    std::find(this->Stages.begin(), this->Stages.end(), stage) - this->Stages.begin();
  if (found == this->Stages.size())
  {
    this->WarnOnce(stage);
  }
  else if (found > this->Stage)
  {
    this->Stage = found;
    this->Shown = -1;
  }
  const double progress = std::max(
    this->Shown, (this->Stage + std::min(std::max(fraction, 0.0), 1.0)) / this->Stages.size());
  constexpr double SmallestStepShown = 0.002;
  constexpr std::chrono::milliseconds LongestSilence(200);
  const auto now = std::chrono::steady_clock::now();
  if (this->Shown < 0 || progress - this->Shown >= SmallestStepShown ||
    now - this->LastShown >= LongestSilence)
  {
    this->Shown = progress;
    this->LastShown = now;
    this->Algorithm->SetProgressText(this->Stages[this->Stage].c_str());
    this->Algorithm->UpdateProgress(progress);
  }
  return !ShouldAbort(this->Algorithm);
}

void AlgorithmMonitor::WarnOnce(const char* unknownStage)
{
  if (!this->Warned)
  {
    this->Warned = true;
    vtkWarningWithObjectMacro(this->Algorithm,
      << Label(this->Algorithm)
      << "the progress shown is wrong, because its list lacks the stage \"" << unknownStage
      << "\": a bug worth reporting, which the outputs do not suffer from");
  }
}
} // namespace vtkInsideOut
