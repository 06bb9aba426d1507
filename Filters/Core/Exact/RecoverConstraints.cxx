// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverConstraints.h"

#include "Exact/Phases.h"
#include "Exact/PullSegments.h"
#include "Exact/RecoverFacets.h"
#include "Exact/RecoverSegments.h"
#include "Exact/RoundPoints.h"
#include "Exact/SteinerPoints.h"

namespace insideout
{
namespace
{
/**
 * Limit of the work for shaking rounded Steiner points: this divisor of the work of their recovery,
 * plus some ms.
 */
constexpr std::int64_t WorkPerShake = 10;
constexpr std::int64_t WorkOnShaking = 1000000;

/** Rings of cells, around points that cannot be rounded, in which facets are given up. */
constexpr int RingsGivenUp = 5;

/**
 * Remove Steiner points that the cells around them kept from being removed, by shaking.
 * @param[in] workBefore the work of their recovery
 */
void ShakeOff(ExactState& state, std::int64_t since, std::int64_t workBefore)
{
  const WorkBudget& work = state.Mesh.Work();
  const std::int64_t begin = work.Spent();
  const std::int64_t mostWork = workBefore / WorkPerShake + WorkOnShaking;
  std::vector<Id> left = state.SteinerPoints(since);
  int patience = ShakesWithoutGain;
  while (!left.empty() && patience > 0 && work.Spent() - begin < mostWork && !work.IsUsedUp())
  {
    state.Report(Phases::ShakingPoints,
      static_cast<double>(work.Spent() - begin) / static_cast<double>(mostWork));
    Shake(state, left);
    const std::size_t before = left.size();
    left = state.SteinerPoints(since);
    patience = left.size() < before ? ShakesWithoutGain : patience - 1;
  }
}
} // namespace

bool RecoverConstraints(ExactState& state, const std::vector<Id>& facets, SplitFrom from,
  std::int64_t since, std::set<Id>& givenUp)
{
  const std::int64_t begin = state.Mesh.Work().Spent();
  std::vector<Id> missing = MarkWholeFacets(state, facets);
  const std::vector<Id> toFlip =
    RecoverSegmentsByPulls(state, FindMissingSegments(state, state.SegmentsOf(missing)));
  missing = MarkWholeFacets(state, missing);
  RecoverSegmentsBySplits(state, RecoverSegmentsByFlips(state, toFlip), from);
  missing = MarkWholeFacets(state, missing);
  RecoverFacetsBySplits(state, RecoverFacetsByFlips(state, missing));
  Tidy(state, state.Mesh.Infinite() + 1, since);
  ShakeOff(state, since, state.Mesh.Work().Spent() - begin);

  std::vector<Id> left = RoundPoints(state, since);
  for (int rings = 0; !left.empty() && rings < RingsGivenUp; ++rings)
  {
    const std::set<Id> around = state.FacetsAround(left, rings);
    givenUp.insert(around.begin(), around.end());
    state.LetGo(around);
    left = RoundPoints(state, since);
  }
  return left.empty();
}
} // namespace insideout
