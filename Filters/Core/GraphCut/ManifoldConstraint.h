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
 * Everything is read off the link of a point: each boundary face at the point gives the edge from
 * its second to its third corner. These edges balance at every point of the link, since the
 * boundary of cells is oriented. The point is manifold where they are one circle or none; the edge
 * to a point of the link is, where only one edge of the link begins there.
 *
 * When all cells at a point are inside, its boundary faces are those on the hull. A convex hull is
 * a manifold, so that filling always helps in the end; beyond the hull nothing can be labelled, and
 * nothing has to be.
 */
class ManifoldConstraint : public LabelConstraint
{
public:
  /**
   * @param[in] cells and neighbors as in TetrahedralMesh, must live on
   * @throws Error InvalidParameter when two cells are on one side of the face that they share, for
   *   then there are labels whose boundary is not oriented
   */
  ManifoldConstraint(std::size_t points, const std::vector<Tetrahedron>& cells,
    const std::vector<std::array<Id, 4>>& neighbors);

  struct Outcome
  {
    Id Edges = 0;      ///< that were not manifold when their turn came
    Id Points = 0;     ///< likewise
    Id LeftPoints = 0; ///< not manifold in the end, for demands or a hull that is none forbid it
  };

  /**
   * March over the edges, then the points; where one is not manifold label cells around it inside
   * in descending order of w, the lowest of equal ones first, until it is; take back those, the
   * last first, that it can do without; and improve greedily. The first cell that is left of each
   * such step is kept inside, so that this ends. Whatever a step breaks elsewhere is marched over
   * again, edges first. When nothing is left to do the kept cells are released and the energy is
   * improved once more, which takes back what is not needed any more.
   *
   * @throws Error Stopped; progress is reported from `begin` to `end`
   */
  Outcome Satisfy(GreedyLabels& labels, Monitor& monitor, double begin, double end);

  bool Allows(const GreedyLabels& labels, Id cell) override;
  void Changed(Id cell) override;

private:
  using LinkEdge = std::pair<Id, Id>;

  /** Points to be looked at, first come first served, each there once at a time. */
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
  Queue WithEdges; ///< points whose edges are to be looked at
  Queue Alone;     ///< points that are to be looked at themselves
  std::vector<Id> Failed;
};
} // namespace insideout
