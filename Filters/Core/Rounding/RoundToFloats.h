// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Files/SurfaceFile.h"

namespace insideout
{
/** The defects of a surface in floats that it has not in doubles. */
struct FloatRounding
{
  Id NearPoints = 0;        ///< that are nearer to another one than a millionth of the size
  Id IntersectingPairs = 0; ///< of triangles that did not meet in doubles
};

/**
 * Round the points of a surface of triangles to floats, for a file that holds no doubles. Points
 * that become one are one; triangles that lose their area are taken out, so that what was closed
 * stays closed. Edges shorter than a millionth of the size are contracted, and points take another
 * float near by, where no more triangles meet then. Triangles that meet already in doubles stay as
 * they are.
 *
 * Attributes of points are lost; a part of a triangle has the attributes of the whole. Triangles
 * keep their order; new ones come last. Nothing changes where not all polygons are triangles, or
 * floats do not hold a point.
 *
 * @throws Error (Stopped)
 */
FloatRounding RoundToFloats(PolygonSurface& surface, Monitor& monitor);

/** What stays, in words for a user; empty where nothing does. */
std::string WordsOf(const FloatRounding& rounding);
} // namespace insideout
