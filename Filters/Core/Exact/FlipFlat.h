// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"
#include "Exact/FillSector.h"

namespace insideout
{
/**
 * Flips in a plane: where two faces in one plane are a strictly convex quadrilateral, its other
 * diagonal replaces their common edge, regardless of the cells above and below. The cells around
 * the edge are two sectors, one on each side of the plane (FillSectors); a sector that no corner
 * sees all of gets a new point in the volume.
 */

/** Flip one edge. @return whether that was possible; p and q are then the ends of the new one */
bool FlipFlat(ExactState& state, Id u, Id v, VolumePoints volumePoints, Id& p, Id& q);

/**
 * Make a and b see each other along the plane that they span with the edges that the segment
 * between them crosses: flip these, the ones that then cross it no more first (Sloan 1993).
 * @return whether the edge is there; else some flips may have been made
 */
bool MakeEdge(ExactState& state, Id a, Id b);

/**
 * Put a new point in the place of an edge: near its middle, connected with all that is around.
 * @return whether that was possible
 */
bool StarEdge(ExactState& state, Id u, Id v);
} // namespace insideout
