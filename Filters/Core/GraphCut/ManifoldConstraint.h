// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "GraphCut/GreedyLabels.h"

#include <deque>
#include <utility>

namespace insideout
{
/**
 * The boundary of the inside cells has to be a 2-manifold (thesis, section 8.5.2): each of its
 * edges in exactly two of its faces, the faces at each of its points one closed fan.
 *
 * All is decided in the link of a point: each boundary face at the point gives the edge from its
 * second to its third corner. These edges balance at every point of the link, since the boundary of
 * cells is oriented. The point is manifold if they are one circle or none. The edge to a point of
 * the link is manifold if only one edge of the link begins there.
 *
 * When all cells at a point are inside, its boundary faces are those on the hull. A convex hull is
 * a manifold, so filling always succeeds in the end; no labels beyond the hull are needed.
 */
class ManifoldConstraint : public LabelConstraint
{
public:
  /**
   * @param[in] cells and neighbors as in TetrahedralMesh, must live on
   * @throws Error InvalidParameter if two cells lie on the same side of their shared face: the
   * boundary of some labels is then not oriented
   */
  ManifoldConstraint(std::size_t points, const std::vector<Tetrahedron>& cells,
    const std::vector<std::array<Id, 4>>& neighbors);

  struct Outcome
  {
    Id Edges = 0;  ///< edges that were not manifold when their turn came
    Id Points = 0; ///< points, likewise
    /// points that stay non-manifold, because demands, or a hull that is not manifold, forbid a
    /// repair
    Id LeftPoints = 0;
  };

  /**
   * March over the edges, then the points. If one is not manifold, label cells around it inside in
   * descending order of w (ties: lowest first) until it is; release those, the last first, that it
   * does not need; and improve greedily. The first remaining cell of each step is kept inside, so
   * that this ends. Edges and points broken by a step are visited again, edges first. Finally the
   * kept cells are released and the energy is improved once more, which removes those no longer
   * needed.
   *
   * @throws Error Stopped; progress is reported from `begin` to `end`
   */
  Outcome Satisfy(GreedyLabels& labels, Monitor& monitor, double begin, double end);

  bool Allows(const GreedyLabels& labels, Id cell) override;
  void Changed(Id cell) override;

private:
  using LinkEdge = std::pair<Id, Id>;

  /** A queue of points, each in it at most once. */
  class Queue
  {
  public:
    explicit Queue(std::size_t points);
    void Push(Id point);
    Id Pop();
    bool IsEmpty() const { return this->Points.empty(); }

  private:
    std::deque<Id> Points;
    std::vector<char> IsWaiting;
  };

  void CheckThatCellsAreApart() const;
  std::vector<LinkEdge> LinkOf(const GreedyLabels& labels, Id point, Id flipped = None) const;
  bool Keeps(const GreedyLabels& labels, Id cell, Id point) const;
  bool IsManifold(const GreedyLabels& labels, Id point, Id other) const;
  void TakeBack(GreedyLabels& labels, std::vector<Id>& forced, Id point, Id other) const;
  bool Fill(GreedyLabels& labels, Id point, Id other) const;
  void VisitEdges(GreedyLabels& labels, Id point, Outcome& outcome);
  void VisitPoint(GreedyLabels& labels, Id point, Outcome& outcome);

  const std::vector<Tetrahedron>& Cells;
  const std::vector<std::array<Id, 4>>& Neighbors;
  const Buckets<Id> CellsOfPoints;
  Queue WithEdges; ///< points whose edges are to be checked
  Queue Alone;     ///< points that are to be checked themselves
  std::vector<Id> Failed;
};
} // namespace insideout
