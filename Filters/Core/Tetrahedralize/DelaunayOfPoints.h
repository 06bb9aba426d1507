// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/RawTetrahedra.h"

namespace insideout
{
/**
 * The Delaunay tetrahedra of points alone (DelaunayTetrahedra). The first of coincident points is
 * used. Cells are sorted, so that the same points give the same answer.
 *
 * @param[in] points at least four that are not in one plane
 * @param[in] mebibytes limit of the memory for tetrahedra: in unlucky positions their number is
 * quadratic in that of the points
 * @return cells, with no point added and no face marked
 * @throws Error TetrahedralizerFailed beyond the memory, Stopped
 */
RawTetrahedra DelaunayOfPoints(
  const std::vector<Point>& points, double mebibytes, Monitor& monitor);
} // namespace insideout
