// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/Body.h"
#include "Common/Monitor.h"

namespace insideout
{
/**
 * Close narrow gaps between flat faces of bodies, whose points do not face each other. Corners of a
 * facet are moved into the plane of a facet of an earlier body, if all of them lie within the
 * tolerance of that plane. The two facets have to overlap by more than the tolerance, seen along
 * their normals. Points that then coincide up to rounding become one when bodies are resolved
 * together. A point moves by the tolerance at most, and into as many as three planes at once. It
 * stays if it would have to move farther, or if it coincides with a point of an earlier body.
 * Coincident points of a body stay coincident.
 *
 * Gaps of uneven width, as between round faces with different triangulations, stay: FillGaps closes
 * them later, by cells.
 *
 * @param[in,out] bodies points may be NaN, and triangles may refer to missing points: such
 * triangles are skipped
 * @param[in] tolerance above 0
 * @return number of positions that moved
 * @throws Error Stopped; some bodies may have moved
 */
Id CloseGaps(std::vector<Body>& bodies, double tolerance, Monitor& monitor);
} // namespace insideout
