// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/RawTetrahedra.h"
#include "Tetrahedralize/TetrahedralizerBudget.h"

namespace insideout
{
/** How TetGen recovers facets. If one way crashes or gives up, another may succeed. */
enum class SurfaceSteinerPoints
{
  Avoid, ///< on facets only where TetGen cannot move them into the volume
  Leave  ///< where TetGen recovers a facet; it also starts from other tetrahedra: by flips, with
         ///< the points in the given order
};

/**
 * Run TetGen on points and facets in a process of its own, the program insideout-tetgen. The
 * environment variable INSIDEOUT_TETGEN may name it. Otherwise it is libexec/insideout-tetgen in
 * the folder of this code's library or program, or in one of the five folders above it. TetGen
 * cannot harm the caller. No process, file, descriptor or signal handler is left behind: the helper
 * ends even if the caller is killed. Thread-safe.
 *
 * The monitor is called every 50 ms. When it stops, or the budget is used up, the helper is killed
 * and reaped. An answer larger than the memory budget is refused before it is read.
 *
 * @param[in] points at least 4, finite
 * @param[in] facets ids in range
 * @return the points sent, then Steiner points; ids are in range, coordinates and the rest
 * unchecked
 * @throws Error TetrahedralizerDied, TetrahedralizerFailed (TetGen reports it, or the budget is
 * used up), TooLarge, Stopped
 */
RawTetrahedra RunTetgen(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  SurfaceSteinerPoints steiner, const TetrahedralizerBudget& budget, Monitor& monitor);
} // namespace insideout
