// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/RecoverConstraints.h"

#include "Exact/EngineLimits.h"
#include "Exact/Phases.h"
#include "Exact/RecoverFacets.h"
#include "Exact/RoundPoints.h"

namespace insideout
{
void ConstraintRecovery::Recover(
  std::vector<Id> missing, SegmentRecovery::From from, std::int64_t since)
{
  const std::int64_t begin = this->Constrained.Mesh.Work().Spent();
  FlippableMesh& mesh = this->Constrained.Mesh;
  SegmentTable& segments = this->Constrained.Segments;
  FacetRecovery facets(mesh, segments, this->Constrained.Facets, this->Progress);
  SegmentRecovery edges(mesh, segments, this->Progress);
  SteinerPoints steiner(mesh, segments, this->Progress);
  missing = facets.MarkWholeFacets(missing);
  const std::vector<Id> toFlip =
    edges.RecoverByPulls(edges.FindMissing(this->Constrained.SegmentsOf(missing)));
  missing = facets.MarkWholeFacets(missing);
  const std::vector<Id> toCut = edges.RecoverByFlips(toFlip);
  edges.RecoverBySplits(toCut, from, steiner);
  missing = facets.MarkWholeFacets(missing);
  facets.RecoverBySplits(facets.RecoverByFlips(missing), steiner);
  steiner.Tidy(mesh.Infinite() + 1, since);
  this->ShakeOff(steiner, since, mesh.Work().Spent() - begin);
}

/**
 * Do without some of the Steiner points that cells at hand could not do without.
 * @param[in] workBefore what their recovery took
 */
void ConstraintRecovery::ShakeOff(
  SteinerPoints& steiner, std::int64_t since, std::int64_t workBefore)
{
  const WorkBudget& work = this->Constrained.Mesh.Work();
  const std::int64_t begin = work.Spent();
  const std::int64_t mostWork =
    workBefore / EngineLimits::WorkPerShake + EngineLimits::WorkOnShaking;
  std::vector<Id> left = this->Constrained.SteinerPoints(since);
  int patience = EngineLimits::ShakesWithoutGain;
  while (!left.empty() && patience > 0 && work.Spent() - begin < mostWork && !work.IsUsedUp())
  {
    this->Progress.Check(Phases::ShakingPoints,
      static_cast<double>(work.Spent() - begin) / static_cast<double>(mostWork));
    steiner.Shake(left, this->Random);
    const std::size_t before = left.size();
    left = this->Constrained.SteinerPoints(since);
    patience = left.size() < before ? EngineLimits::ShakesWithoutGain : patience - 1;
  }
}

bool ConstraintRecovery::RecoverAndRound(const std::vector<Id>& facets, SegmentRecovery::From from,
  bool maySplitBeside, std::int64_t since, std::set<Id>& givenUp)
{
  this->Recover(facets, from, since);
  PointRounder rounder(this->Constrained.Mesh, this->Constrained.Segments, this->Progress);
  std::vector<Id> left = rounder.RoundAll(maySplitBeside, since, this->Random);
  for (int rings = 0; !left.empty() && rings < EngineLimits::RingsGivenUp; ++rings)
  {
    const std::set<Id> around = this->Constrained.FacetsAround(left, rings);
    givenUp.insert(around.begin(), around.end());
    this->Constrained.LetGo(around);
    left = rounder.RoundAll(maySplitBeside, since, this->Random);
  }
  return left.empty();
}
} // namespace insideout
