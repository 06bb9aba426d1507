// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Exact/EdgeRemoval.h"

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace insideout
{
/** How hard flips try to take an edge away. */
struct FlipEffort
{
  FlipOperator::Limits Limits;
  int Depth;  ///< levels of edges that may go before it, to make its ring smaller
  int Budget; ///< how many of these are tried

  /** The mesh's work (ExactVertices::Work) beyond which none is tried any more. */
  std::int64_t EndOfWork = std::numeric_limits<std::int64_t>::max();
};

/** Only flips that leave less in the way than before. */
constexpr FlipEffort PlainFlips = { { -1, 10 }, 0, 0 };

/**
 * Recover constraints by flips that leave less in the way each time, and a few of what is left by
 * deeper ones. What these leave, cuts recover in less time.
 * @param[in] missing the constraints, in the order in which they are tried
 * @param[in] elements points and constraints of the mesh, that the work may be in proportion with
 * @param[in] stage the name under which progress is reported
 * @param[in] recover called with a constraint and a FlipEffort; says whether the mesh has it then
 * @return the ones that are still missing, in the same order
 */
template <typename Recover>
std::vector<Id> RecoverInRounds(std::vector<Id> missing, const FlippableMesh& mesh,
  std::int64_t elements, Monitor& monitor, const char* stage, Recover&& recover)
{
  /** Some 0.02 ms. Surfaces of which flips recover nearly all take a tenth. */
  constexpr std::int64_t WorkPerElement = 1000;

  /** Some ms, for the surfaces on which these flips do without any cut. */
  constexpr std::int64_t WorkOnDeepFlips = 300000;
  constexpr std::array<FlipEffort, 3> DeepFlips = { { { { -1, 10 }, 1, 40 }, { { 0, 12 }, 2, 150 },
    { { 1, 12 }, 3, 500 } } };

  /** How often the monitor is asked. */
  constexpr std::size_t ConstraintsPerCheck = 4;

  const auto round = [&](FlipEffort effort, std::int64_t mostWork)
  {
    effort.EndOfWork = mesh.Vertices.Work() + mostWork;
    std::vector<Id> still;
    for (std::size_t k = 0; k < missing.size(); ++k)
    {
      if (k % ConstraintsPerCheck == 0)
      {
        monitor.Check(stage, static_cast<double>(k) / missing.size());
      }
      if (!recover(missing[k], effort))
      {
        still.push_back(missing[k]);
      }
    }
    missing = std::move(still);
  };

  // While a round gets many, another gets more.
  std::size_t before = 2 * missing.size() + 2;
  while (!missing.empty() && missing.size() < before - before / 10)
  {
    before = missing.size();
    round(PlainFlips, WorkPerElement * elements);
  }
  for (const FlipEffort& effort : DeepFlips)
  {
    if (!mesh.Vertices.IsWorkDone())
    {
      round(effort, WorkOnDeepFlips);
    }
  }
  return missing;
}
} // namespace insideout
