// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Monitor.h"
#include "Types.h"

#include <vector>

namespace insideout
{
/** Whether TetGen may put points on facets and their edges. */
enum class SurfaceSteinerPoints
{
  Avoid, ///< only where TetGen cannot move them into the volume
  Allow
};

/** What TetGen made, ids in range and coordinates as they came; nothing else is checked. */
struct TetgenAnswer
{
  std::vector<Point> Points; ///< as many as were sent and then Steiner points
  std::vector<Tetrahedron> Cells;
  std::vector<Triangle> Faces;  ///< faces of cells that lie on facets
  std::vector<Id> FacetOfFaces; ///< one per face
};

/**
 * Run TetGen on points and facets in a process of its own, the program insideout-tetgen: the one
 * that the environment variable INSIDEOUT_TETGEN names, else libexec/insideout-tetgen in the folder
 * of the library or program that holds this code, or in one of the five folders above it. Nothing
 * that TetGen does harms the caller, and no process, descriptor or signal handler is left behind.
 * May be called from several threads at once.
 *
 * @param[in] points at least 4, finite
 * @param[in] facets ids in range
 * @throws Error TetrahedralizerDied, TetrahedralizerFailed, TooLarge, Stopped
 */
TetgenAnswer RunTetgen(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  SurfaceSteinerPoints steiner, Monitor& monitor);
} // namespace insideout
