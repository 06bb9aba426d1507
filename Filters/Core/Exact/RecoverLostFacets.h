// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/RecoverConstraints.h"

namespace insideout
{
/**
 * Recovers facets that were lost, by ruin and recreate (Schrimpf et al. 2000): facets around a lost
 * one are taken out, and all of them are recovered in another order. Where more are lost
 * afterwards, the mesh is put back as it was. This goes on as long as there is work to spare.
 * Facets that cross others stay lost.
 */
class LostFacetRecovery
{
public:
  LostFacetRecovery(ConstrainedMesh& mesh, std::mt19937& random, Monitor& monitor)
    : Constrained(mesh)
    , Recovery(mesh, random, monitor)
    , Random(random)
    , Progress(monitor)
  {
  }

  /**
   * @param[in] points of the mesh, as they were given
   * @param[in] from the end of segments at which Steiner points began; now it is the other in turn
   */
  void Recover(const std::vector<Point>& points, SegmentRecovery::From from);

private:
  std::vector<Id> ChooseRuins(const std::vector<Id>& lost);
  void AddFacetsBesideSteinerPoints(std::set<Id>& facets) const;
  bool Recreate(const std::vector<Id>& ruins, SegmentRecovery::From from, bool maySplitBeside);
  void ShakeCorners(const std::vector<Id>& facets);

  ConstrainedMesh& Constrained;
  ConstraintRecovery Recovery;
  std::mt19937& Random;
  Monitor& Progress;
};
} // namespace insideout
