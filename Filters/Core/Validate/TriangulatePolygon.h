// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * Triangulate a polygon without new points. The triangles' boundary is the polygon's outline,
 * except edges that it runs along in both directions. So a closed surface of polygons becomes a
 * closed one of triangles, however broken a polygon is.
 *
 * A polygon is the region enclosed by its outline, seen along an axis, each part repeated by its
 * winding number (reversed if negative). So holes may be cut out by bridges along which the outline
 * runs twice, and the outline may touch itself. If the polygon is not flat, the triangles are those
 * of least area among the candidates (README.md).
 *
 * The triangles do not depend on the polygon's position in the list, on its first corner, or on ids
 * of equal coordinates; the reversed polygon gives reversed triangles. A triangle may be degenerate
 * if the outline touches itself within an edge or has no area; there is always at least one
 * triangle.
 *
 * @param[in] points finite, of any size
 * @param[in] corners three or more, as the outline runs
 * @param[in,out] triangles gains those of the polygon; if several corners coincide, the id of any
 * of them may represent all
 * @return false if the outline crosses itself, so that no triangles without new points cover
 * exactly the enclosed region: they then overlap, with the least area found
 */
bool TriangulatePolygon(const std::vector<Point>& points, const std::vector<Id>& corners,
  std::vector<Triangle>& triangles);
} // namespace insideout
