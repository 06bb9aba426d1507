// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/EngineLimits.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace insideout
{
/**
 * Recover constraints by flips that leave less in the way each time, and a few of what is left by
 * deeper ones. What these leave, cuts recover in less time.
 * @param[in] missing the constraints, in the order in which they are tried
 * @param[in] elements points and constraints of the mesh, that the work may be in proportion with
 * @param[in] recover called with a constraint and a FlipEffort; says whether the mesh has it then
 * @return the ones that are still missing, in the same order
 */
template <typename Recover>
std::vector<Id> RecoverInRounds(std::vector<Id> missing, const FlippableMesh& mesh,
  std::int64_t elements, Monitor& monitor, const ProgressRange& phase, Recover&& recover)
{
  /** How often the monitor is asked. */
  constexpr std::size_t ConstraintsPerCheck = 4;

  // Nobody knows how many rounds there will be: each takes half of what is left of the phase.
  double left = 1;
  const auto round = [&](FlipEffort effort, std::int64_t mostWork)
  {
    effort.EndOfWork = mesh.Work().Spent() + mostWork;
    std::vector<Id> still;
    for (std::size_t k = 0; k < missing.size(); ++k)
    {
      if (k % ConstraintsPerCheck == 0)
      {
        monitor.Check(phase, 1 - left + left / 2 * static_cast<double>(k) / missing.size());
      }
      if (!recover(missing[k], effort))
      {
        still.push_back(missing[k]);
      }
    }
    missing = std::move(still);
    left /= 2;
  };

  // While a round gets many, another gets more.
  std::size_t before = 2 * missing.size() + 2;
  while (!missing.empty() && missing.size() < before - before / 10)
  {
    before = missing.size();
    round(EngineLimits::PlainFlips, EngineLimits::WorkPerElement * elements);
  }
  for (const FlipEffort& effort : EngineLimits::DeepFlips)
  {
    if (!mesh.Work().IsUsedUp())
    {
      round(effort,
        std::min(EngineLimits::MostWorkOnDeepFlips, EngineLimits::DeepWorkPerElement * elements));
    }
  }
  return missing;
}
} // namespace insideout
