// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/SolidFile.h"

#include <vector>

namespace insideout
{
/**
 * Check that there are cells, and that their points exist and have finite coordinates.
 *
 * @throws Error InvalidParameter, PointOutOfRange, PointNotFinite
 */
void CheckCells(const SolidMesh& solid);

/** The corners of a triangle of a pyramid or prism, counter-clockwise seen from outside. */
Triangle TriangleOfLayer(const SolidMesh& solid, const CellFace& face);

/** The faces of exactly one cell, in the order of the cells.
 * @throws Error of CheckCells, and InvalidParameter if there are pyramids or prisms
 */
std::vector<CellFace> OuterFaces(const SolidMesh& solid);

/**
 * Find the face that coincides with each triangle of a surface, by the places of its corners: the
 * surface has points of its own. Between two cells it is the face of the one from which the
 * triangle faces away. If there are several points at one place, faces of exactly one cell come
 * first.
 *
 * @throws Error InvalidParameter that names the first triangle that is not a face; PointOutOfRange;
 * as CheckCells
 */
std::vector<CellFace> FacesOfTriangles(
  const SolidMesh& solid, const std::vector<Point>& points, const std::vector<Triangle>& triangles);
} // namespace insideout
