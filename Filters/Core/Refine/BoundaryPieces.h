// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/LooseOctree.h"
#include "Common/SortedTriangle.h"
#include "Refine/SurfacePiece.h"

#include <unordered_map>
#include <vector>

namespace insideout
{
/**
 * The pieces of the boundary; tells whether some can be replaced without crossing the rest. Cells
 * keep pieces apart that have cells between them. Outside there are no cells, so that a surface
 * that moves, if only by rounding, might cross another part of the boundary.
 */
class BoundaryPieces
{
public:
  explicit BoundaryPieces(const std::vector<SurfacePiece>& pieces);

  /** Whether no fresh piece meets another, or one that stays, beyond shared corners and edges;
   * exact, by coordinates. No fresh piece may be degenerate. */
  bool StayApart(
    const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh) const;

  /** Replace the gone pieces by the fresh ones. */
  void Replace(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

private:
  void Add(const SurfacePiece& piece);

  std::vector<SurfacePiece> Pieces;
  std::vector<Id> Unused; ///< positions of pieces in the list
  std::unordered_map<Triangle, Id, HashOfTriangle> Ids;
  LooseOctree Octree;
};
} // namespace insideout
