// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Buckets.h"
#include "Common/TetrahedralMesh.h"
#include "GraphCut/GreedyLabels.h"

namespace insideout
{
/** A face of the mesh that lies on a facet: satisfied if one of its cells is inside. */
struct FacetPiece
{
  Id First;
  Id Second; ///< None beyond the hull
  Id Facet;  ///< in the caller's numbering
};

/**
 * The pieces of facets in the order of their cells.
 *
 * @param[in] chosen one value per facet, 0 for those that need not be kept; empty for all
 */
std::vector<FacetPiece> PiecesOfFacets(
  const TetrahedralMesh& mesh, const std::vector<unsigned char>& chosen = {});

/** Every piece has to be a face of an inside cell (thesis, section 8.5.2). */
class FacetConstraint : public LabelConstraint
{
public:
  /** @param[in] pieces must live on; cells in range */
  FacetConstraint(const std::vector<FacetPiece>& pieces, Id cells);

  struct Outcome
  {
    Id Forced = 0; ///< pieces that were not satisfied when their turn came, and are now
    std::vector<Id> Unsatisfied; ///< pieces that demands keep outside, ascending
  };

  /**
   * March over the pieces; if one is not satisfied, label its cell with the larger w inside, the
   * lower one on ties, and improve greedily. Pieces that are satisfied stay so.
   *
   * @throws Error Stopped; progress is reported from `begin` to `end`
   */
  Outcome Satisfy(GreedyLabels& labels, Monitor& monitor, double begin, double end);

  bool Allows(const GreedyLabels& labels, Id cell) override;
  void Changed(Id) override {}

private:
  const std::vector<FacetPiece>& Pieces;
  const Buckets<Id> PiecesOfCells;
};
} // namespace insideout
