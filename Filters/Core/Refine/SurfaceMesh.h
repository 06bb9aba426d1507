// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"
#include "Refine/SurfacePiece.h"

#include <cstdint>
#include <vector>

namespace insideout
{
/**
 * The pieces of a surface, which may branch, changed by replacing some by others. Which pieces fit
 * together is the caller's concern.
 */
class SurfaceMesh
{
public:
  explicit SurfaceMesh(const std::vector<SurfacePiece>& pieces);

  /** The number of all pieces, including removed ones: a bound of their ids. */
  Id NumberOfPieces() const { return static_cast<Id>(this->Pieces.size()); }
  bool IsRemoved(Id piece) const { return this->Pieces[piece].Corners[0] == None; }

  /** Valid until the next Replace. */
  const SurfacePiece& Piece(Id piece) const { return this->Pieces[piece]; }

  /** The pieces at a point; none for a point in no piece. Valid until the next Replace. */
  const std::vector<Id>& At(Id point) const;

  /** The pieces at an edge. */
  std::vector<Id> AtEdge(Id u, Id v) const;

  /** All pieces that are there, and their edges, each once. */
  std::vector<SurfacePiece> All() const;
  std::vector<Edge> Edges() const;

  void Replace(const std::vector<Id>& gone, const std::vector<SurfacePiece>& fresh);

  /** The number of calls of Replace, and that of the last one that changed pieces at a point. */
  std::int64_t NumberOfChanges() const { return this->Changes; }
  std::int64_t LastChangeAt(Id point) const { return this->ChangeAt[point]; }

private:
  void Add(const SurfacePiece& piece);
  void Remove(Id piece);

  std::vector<SurfacePiece> Pieces;
  std::vector<std::vector<Id>> AtPoints;
  std::vector<std::int64_t> ChangeAt; ///< per point
  std::vector<Id> Removed;            ///< ids to be used again
  std::int64_t Changes = 0;
};
} // namespace insideout
