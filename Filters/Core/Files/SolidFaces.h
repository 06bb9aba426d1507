// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFile.h"

#include <vector>

namespace insideout
{
/**
 * Whether there are cells, whose points exist and have finite coordinates.
 *
 * @throws Error InvalidParameter, PointOutOfRange, PointNotFinite
 */
void CheckCells(const SolidMesh& solid);

/** The corners of a triangle of a pyramid or prism, counter-clockwise seen from outside. */
Triangle TriangleOfLayer(const SolidMesh& solid, const CellFace& face);

/** The faces that only one cell has, in the order of the cells.
 * @throws Error of CheckCells, and InvalidParameter where there are pyramids or prisms */
std::vector<CellFace> OuterFaces(const SolidMesh& solid);

/**
 * The face that each triangle of a surface is, found by where its corners are: the surface has
 * points of its own. Between two cells it is the face of the one that the triangle faces away from.
 * Where points stand in one place several times, faces that one cell alone has come first.
 *
 * @throws Error InvalidParameter that names the first triangle that is no face; PointOutOfRange;
 * what CheckCells throws
 */
std::vector<CellFace> FacesOfTriangles(
  const SolidMesh& solid, const std::vector<Point>& points, const std::vector<Triangle>& triangles);
} // namespace insideout
