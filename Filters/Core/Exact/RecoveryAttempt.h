// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/RawTetrahedra.h"
#include "Exact/ConstrainedMesh.h"
#include "Exact/RecoverSegments.h"

#include <random>
#include <set>
#include <vector>

namespace insideout
{
/** One attempt to make a mesh of points that has all facets, from the beginning to its end. */
class RecoveryAttempt
{
public:
  /**
   * @param[in] facets with area
   * @param[in] workPerElement for each point and facet (WorkBudget)
   * @throws Error Planar, Stopped
   */
  RecoveryAttempt(const std::vector<Point>& points, const std::vector<Triangle>& facets,
    std::int64_t workPerElement, Monitor& monitor);

  RecoveryAttempt(const RecoveryAttempt&) = delete;
  void operator=(const RecoveryAttempt&) = delete;

  /**
   * Recover all facets that can be. Facets that have to be given up, for Steiner points on them
   * find no place in doubles, get another chance when the others are done.
   * @param[in] from the end of segments at which Steiner points begin
   * @return whether all Steiner points have places; if not, the mesh is good for nothing
   */
  bool Run(SegmentRecovery::From from);

  /** The facets that were given up where Run gave false. */
  const std::set<Id>& FacetsGivenUp() const { return this->GivenUp; }

  /** The cells, and the faces with facets. */
  RawTetrahedra Result() const;

  /** The work done (WorkBudget). */
  std::int64_t WorkSpent() const { return this->Work.Spent(); }

private:
  const std::vector<Point>& Points;
  Monitor& Progress;
  WorkBudget Work;
  ConstrainedMesh Constrained;
  std::mt19937 Random;
  std::set<Id> GivenUp;
};
} // namespace insideout
