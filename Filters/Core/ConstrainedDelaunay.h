// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Monitor.h"
#include "TetrahedralMesh.h"

namespace insideout
{
/**
 * Stage CDT: tetrahedra of the convex hull of the complex in which every constraint is a union of
 * faces (thesis, chapter 8). TetGen does the work in a program of its own (TetgenProcess.h), for
 * it exits or crashes on some inputs. What comes back is checked before it is believed
 * (AssembleMesh.h): points in place, exact positive volumes, every face shared by at most two
 * cells, facets present.
 *
 * Every point of the complex is a point of the mesh, whether a constraint uses it or not.
 *
 * @param[in] surface a complex whose constraints do not cross, with no point in the interior of a
 *            constraint or of its edges
 * @throws Error EmptySurface, PointOutOfRange, PointNotFinite, Planar, TetrahedralizerDied,
 *         TetrahedralizerFailed, TooLarge, Inconsistent, Stopped
 */
TetrahedralMesh ConstrainedDelaunay(const FacetComplex& surface, Monitor& monitor);
} // namespace insideout
