// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"
#include "Exact/FillSector.h"

namespace insideout
{
/**
 * Take a Steiner point out of the mesh. The facets (and faces of the hull) that have the point cut
 * the cells around it into sectors. The facets are triangulated without the point, and each sector
 * is filled with cells that meet in one of its own corners, if one sees all of its boundary; or
 * else, where that is allowed, in a new point within (the idea of George, Borouchaki and Saltel
 * 2003: a point that splits a segment goes into the volume on each side).
 * @return whether the point is gone
 */
bool DissolvePoint(ExactState& state, Id point, VolumePoints volumePoints);
} // namespace insideout
