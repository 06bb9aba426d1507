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

/** Faces of a pyramid or prism. */
constexpr int FacesOfLayerCell = 5;

/** The corners of a face of a pyramid or prism, counter-clockwise seen from outside; the last is
 * None of a triangle. */
std::array<Id, 4> FaceOfLayer(const SolidMesh& solid, const CellFace& face);

/** Whether a face is one of the quads of pyramids and prisms. */
bool IsQuad(const SolidMesh& solid, const CellFace& face);

/** The faces of exactly one cell, in the order of the cells.
 * @throws Error of CheckCells, and InvalidParameter if there are pyramids or prisms
 */
std::vector<CellFace> OuterFaces(const SolidMesh& solid);

/**
 * Find the face that coincides with each triangle of a surface, by the places of its corners: the
 * surface has points of its own. Between two cells it is the face of the one from which the
 * triangle faces away. If there are several points at one place, faces of exactly one cell come
 * first. Half of a quad finds that quad.
 *
 * @throws Error InvalidParameter that names the first triangle that is not a face; PointOutOfRange;
 * as CheckCells
 */
std::vector<CellFace> FacesOfTriangles(
  const SolidMesh& solid, const std::vector<Point>& points, const std::vector<Triangle>& triangles);
} // namespace insideout
