// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/PartedSolid.h"

#include <string>

namespace insideout
{
struct OverlapCounts
{
  Id Overlaps = 0;    ///< regions where w is near 2 or more
  Id Separated = 0;   ///< of these
  Id CopiedCells = 0; ///< one for each cell of those
  /** A corner of the first overlap that stays glued, where there is one. */
  Point Left = { { 0, 0, 0 } };
};

/**
 * Where two layers of the solid overlap, and w is near 2, give each layer cells of its own (thesis,
 * 8.7 and figure 8.17): the overlap's cells are copied, and the copy of each layer is glued to what
 * goes on as that layer beyond.
 *
 * A face of the overlap's boundary is where one of both layers ends, and the other goes on into a
 * cell where w is near 1. Which faces bound the same layer is told by their edges. Around an edge
 * of two such faces lies either one stretch of cells where w is near 1: then one sheet bends there,
 * and both bound the same layer. Or w is near 1, 0 and 1 again: there two sheets cross, and each
 * bounds another layer. An overlap is separated where this says of all its faces which of at most
 * two layers they bound, and no face contradicts. It stays as it is, glued, where w is near 3 or
 * more in it, or where part of it is outside the solid; where a face of its boundary is no facet or
 * steps by more than 1; where sheets meet in an edge in other ways than these; and where faces are
 * not connected through edges, so that nothing tells which of two layers they bound.
 *
 * Points of overlaps that are separated are parted (PartPoints), so that the layers have no more in
 * common than what connects them elsewhere. The cells' copies come after all cells, in their order.
 *
 * @param[in] surface that the hull was made of
 * @param[in] w one per cell of the hull
 * @param[in,out] solid UnpartedSolid of the hull
 * @throws Error InvalidParameter when there is not one w per cell; Stopped
 */
OverlapCounts SeparateOverlaps(const FacetComplex& surface, const std::vector<double>& w,
  PartedSolid& solid, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
