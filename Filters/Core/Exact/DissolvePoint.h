// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"
#include "Exact/FillSector.h"

namespace insideout
{
/**
 * Remove a Steiner point. The facets (and faces of the hull) at the point divide the cells around
 * it into sectors. The facets are triangulated without the point. Each sector is filled with cells
 * that meet in one of its corners, if one sees its whole boundary. Otherwise they meet in a new
 * point within, where that is allowed: a point that splits a segment goes into the volume on each
 * side (George, Borouchaki and Saltel 2003).
 * @return whether the point is removed
 */
bool DissolvePoint(ExactState& state, Id point, VolumePoints volumePoints);
} // namespace insideout
