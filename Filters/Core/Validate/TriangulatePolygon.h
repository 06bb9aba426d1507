// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/**
 * A polygon as triangles between its own corners. Their boundary is its outline, edges that it runs
 * along in both directions left out: a closed surface of polygons becomes a closed one of
 * triangles, and no polygon is too broken.
 *
 * A polygon means what its outline encloses, each part as often as the winding number there says
 * (negative ones turned over), seen along an axis. So holes may be cut out of it by bridges along
 * which the outline runs twice, and it may touch itself. Where it is not flat, the triangles are
 * those of least area among the candidates (README.md).
 *
 * The same polygon gives the same triangles in another place of the list, begun elsewhere, or with
 * other ids of the same coordinates; run through the other way it gives them turned over. A
 * triangle may be degenerate where the outline touches itself within an edge or has no area; there
 * is always at least one triangle.
 *
 * @param[in] points finite, of any size
 * @param[in] corners three or more, as the outline runs
 * @param[in,out] triangles those of the polygon are added; where several corners have the same
 *   coordinates, any of their ids may stand for all
 * @return false where the outline crosses itself, so that without new points there are no triangles
 *   of only what it encloses: they overlap then, with as little area as was found
 */
bool TriangulatePolygon(const std::vector<Point>& points, const std::vector<Id>& corners,
  std::vector<Triangle>& triangles);
} // namespace insideout
