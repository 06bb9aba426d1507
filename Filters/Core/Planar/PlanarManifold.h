// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "GraphCut/ManifoldConstraint.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
/**
 * The boundary of the inside triangles has to be a 1-manifold (thesis, section 8.5.2, for d = 2):
 * at each of its points two of its edges end. If all triangles at a point are inside, no edge ends
 * there, or two do on the hull, so filling always succeeds.
 */
class PlanarManifold : public LabelConstraint
{
public:
  /** @param[in] mesh must live on */
  PlanarManifold(std::size_t points, const PlanarMesh& mesh);

  /**
   * March over the points. Around one that is not manifold, label triangles inside in descending
   * order of w (ties: lowest first) until it is; release those, the last first, that it does not
   * need; and improve greedily. ManifoldConstraint does the same, and explains why it ends.
   *
   * @throws Error Stopped; progress is reported from `begin` to `end`
   */
  ManifoldConstraint::Outcome Satisfy(
    GreedyLabels& labels, Monitor& monitor, double begin, double end);

  bool Allows(const GreedyLabels& labels, Id cell) override;
  void Changed(Id cell) override;

private:
  int BoundaryEdges(const GreedyLabels& labels, Id point, Id flipped = None) const;
  bool IsManifold(const GreedyLabels& labels, Id point) const
  {
    return this->BoundaryEdges(labels, point) <= 2;
  }
  bool Fill(GreedyLabels& labels, Id point) const;
  void TakeBack(GreedyLabels& labels, std::vector<Id>& forced, Id point) const;

  const PlanarMesh& Mesh;
  const Buckets<Id> CellsOfPoints;
  std::vector<Id> Waiting; ///< queue of points, first at its end
  std::vector<char> IsWaiting;
};
} // namespace insideout
