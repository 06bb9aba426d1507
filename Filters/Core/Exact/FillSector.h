// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/FlippableMesh.h"

namespace insideout
{
/** Whether a change of the mesh may insert new points into the volume. */
enum class VolumePoints
{
  None,
  AsNeeded
};

/** A part of space that is to be filled with cells. */
struct Sector
{
  std::vector<Triangle> Walls; ///< its boundary, counter-clockwise seen from inside
  std::vector<Id> Corners;     ///< of the walls; the infinite vertex is none
  bool IsInfinite = false;     ///< it is beyond the hull
};

/**
 * Append the cells of all sectors to `fresh`. The cells of each meet in one point: a corner that
 * sees all its walls, or a new point.
 * @param[in] inside a point that sees all walls, or nearly; new points lie near it
 * @return false, and no new point, if that cannot be done
 */
bool FillSectors(FlippableMesh& mesh, const std::vector<Sector>& sectors, const Point& inside,
  VolumePoints volumePoints, std::vector<Tetrahedron>& fresh);
} // namespace insideout
