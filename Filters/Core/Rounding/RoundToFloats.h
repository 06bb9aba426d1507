// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Files/SurfaceFile.h"

namespace insideout
{
/** Defects of a surface in floats that it does not have in doubles. */
struct FloatRounding
{
  Id NearPoints = 0;        ///< points nearer to another one than a millionth of the size
  Id IntersectingPairs = 0; ///< pairs of triangles that did not meet in doubles
};

/**
 * Round the points of a triangulated surface to floats, for a file format without doubles. Points
 * that coincide are merged; triangles that lose their area are removed, so that closed surfaces
 * stay closed. Edges shorter than a millionth of the size are contracted, and points move to
 * another float nearby, if that adds no intersections. Triangles that intersect in doubles already
 * stay as they are.
 *
 * Attributes of points are lost; a piece of a triangle has the attributes of the whole. Triangles
 * keep their order; new ones come last. Nothing changes if not all polygons are triangles, or a
 * point is beyond the range of floats.
 *
 * @throws Error (Stopped)
 */
FloatRounding RoundToFloats(PolygonSurface& surface, Monitor& monitor);

/** A message with the remaining defects; empty if there are none. */
std::string WordsOf(const FloatRounding& rounding);
} // namespace insideout
