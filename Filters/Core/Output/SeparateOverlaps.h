// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/PartedSolid.h"

#include <string>

namespace insideout
{
struct OverlapCounts
{
  Id Overlaps = 0;    ///< regions where w is near 2 or more
  Id Separated = 0;   ///< number of separated ones
  Id CopiedCells = 0; ///< one copy for each cell of those
  /** A corner of the first overlap that stays glued, if there is one. */
  Point Left = { { 0, 0, 0 } };
};

/**
 * Where two layers of the solid overlap (w is near 2), give each layer its own cells (thesis, 8.7
 * and figure 8.17): the overlap's cells are copied, and each copy is glued to the continuation of
 * its layer.
 *
 * At each face of the overlap's boundary one layer ends, and the other continues into a cell with w
 * near 1. The faces' edges determine which faces bound the same layer. Around an edge of two such
 * faces w is either near 1 throughout: one sheet bends there, and both faces bound the same layer.
 * Or w is near 1, 0 and 1 again: two sheets cross, and the faces bound different layers. An overlap
 * is separated if this assigns all its faces to at most two layers without contradiction. It stays
 * glued in these cases: w is near 3 or more in it; a part of it is outside the solid; a face of its
 * boundary is not a facet, or w steps by more than 1 there; sheets meet at an edge in other ways;
 * faces are not connected through edges, so that their layers are undefined.
 *
 * Points of separated overlaps are separated, too (PartPoints), so that layers share only points
 * that connect them elsewhere. Copies of cells come after all cells, in their order.
 *
 * @param[in] surface from which the hull was made
 * @param[in] w one per cell of the hull
 * @param[in,out] solid UnpartedSolid of the hull
 * @throws Error InvalidParameter if there is not one w per cell; Stopped
 */
OverlapCounts SeparateOverlaps(const FacetComplex& surface, const std::vector<double>& w,
  PartedSolid& solid, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
