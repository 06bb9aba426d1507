// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * Replace cells that are flat in doubles, where others fill the same space: by removing an edge or
 * a face (Reconnection), or by moving a Steiner point that lies on no facet. All other points, and
 * the faces on facets and on the hull, stay. Only cells near flat ones are looked at.
 *
 * @throws Error Stopped
 */
void MendFlatCells(TetrahedralMesh& mesh, Monitor& monitor);
} // namespace insideout
