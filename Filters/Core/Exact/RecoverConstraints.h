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
   * @param[in,out] givenUp gains the facets that were given up
   * @return whether all Steiner points have places; if not, the mesh is good for nothing
   */
  bool RecoverAndRound(const std::vector<Id>& facets, SegmentRecovery::From from,
    bool maySplitBeside, std::set<Id>& givenUp);

private:
  void Recover(std::vector<Id> missing, SegmentRecovery::From from);
  void ShakeOff(SteinerPoints& steiner);

  ConstrainedMesh& Constrained;
  std::mt19937& Random;
  Monitor& Progress;
};
} // namespace insideout
