// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Refine/RefinableSurface.h"
#include "Refine/SizingField.h"
#include "Refine/SurfaceBound.h"

#include <vector>

namespace insideout
{
/** Inserts a point in an edge, splitting all cells and pieces of facets around it. */
class EdgeSplitting : public SurfaceOperator
{
public:
  using SurfaceOperator::SurfaceOperator;

  /**
   * Find the cells around an edge of `cell`.
   * @return false if the edge is locked or a piece at it has a much longer edge; also if rounding
   * leaves no point between its ends, or puts its midpoint beyond another piece
   */
  bool Find(Id u, Id v, Id cell);

  /** Split the edge that was found. @return the point */
  Id Split(SizingField& sizes);

private:
  bool IsBesideLonger() const;
  bool StaysApart();

  EdgeRing Ring;
  Point Middle;
  std::vector<SurfacePiece> Gone;
  std::vector<SurfacePiece> Halves; ///< that replace them
};
} // namespace insideout
