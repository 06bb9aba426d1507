// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ConstrainedMesh.h"
#include "Exact/RecoverSegments.h"

#include <random>
#include <set>
#include <vector>

namespace insideout
{
/**
 * Recovers facets: their segments first, then the facets between them, each by flips and then by
 * Steiner points, which are removed or rounded to doubles. Facets that have points without a place
 * in doubles are given up.
 */
class ConstraintRecovery
{
public:
  /** @param[in,out] random one for all that is done with a mesh, so that no try is like another */
  ConstraintRecovery(ConstrainedMesh& mesh, std::mt19937& random, Monitor& monitor)
    : Constrained(mesh)
    , Random(random)
    , Progress(monitor)
  {
  }

  /**
   * @param[in] facets that are not there, in the order in which they are tried
   * @param[in] from the end of segments at which Steiner points begin
   * @param[in] maySplitBeside as in PointRounder::RoundAll
   * @param[in] since Steiner points around which nothing has changed since stay as they are
   * @param[in,out] givenUp gains the facets that were given up
   * @return whether all Steiner points have places; if not, the mesh is good for nothing
   */
  bool RecoverAndRound(const std::vector<Id>& facets, SegmentRecovery::From from,
    bool maySplitBeside, std::int64_t since, std::set<Id>& givenUp);

private:
  void Recover(std::vector<Id> missing, SegmentRecovery::From from, std::int64_t since);
  void ShakeOff(SteinerPoints& steiner, std::int64_t since, std::int64_t workBefore);

  ConstrainedMesh& Constrained;
  std::mt19937& Random;
  Monitor& Progress;
};
} // namespace insideout
