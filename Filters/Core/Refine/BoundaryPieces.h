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
 * The pieces of the boundary, to be asked whether others may take the place of some without
 * crossing the rest. Cells keep those apart that have cells between them; beyond the boundary are
 * none, so that a surface that moves, if only by rounding, might come through a part next to it.
 */
class BoundaryPieces
{
public:
  explicit BoundaryPieces(const std::vector<SurfacePiece>& pieces);

  /** Whether no fresh piece meets another, or one that stays, in more than the corners and the edge
   * that they share: exactly, by places. No fresh piece may be degenerate. */
  bool StayApart(
    const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh) const;

  /** Put fresh pieces in place of those that are gone. */
  void Replace(const std::vector<SurfacePiece>& gone, const std::vector<SurfacePiece>& fresh);

private:
  void Add(const SurfacePiece& piece);

  std::vector<SurfacePiece> Pieces;
  std::vector<Id> Unused; ///< of the pieces: their places in the list
  std::unordered_map<Triangle, Id, HashOfTriangle> Ids;
  LooseOctree Octree;
};
} // namespace insideout
