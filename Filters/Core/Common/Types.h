// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

/**
 * The algorithms of InsideOut, without VTK, on plain structs. Each file is a stage or a part of
 * one; see README.md.
 */
namespace insideout
{
/** Index of a point, facet or cell. TetGen's indices are int, so 32 bits lose nothing. */
using Id = std::int32_t;

/** The id for none: no facet on a face, no cell outside the hull. */
constexpr Id None = -1;

using Point = std::array<double, 3>;
using Triangle = std::array<Id, 3>;
using Tetrahedron = std::array<Id, 4>;

/**
 * Corners of the faces of a tetrahedron, as vtkTetra numbers them: seen from outside a positively
 * oriented tetrahedron they run counter-clockwise.
 */
constexpr std::array<std::array<int, 3>, 4> TetrahedronFaces = { { { { 0, 1, 3 } }, { { 1, 2, 3 } },
  { { 2, 0, 3 } }, { { 0, 2, 1 } } } };

/** Corners of the edges of a tetrahedron, as vtkTetra numbers them; the order of
 * vtkQuadraticTetra's mid-edge nodes. */
constexpr std::array<std::array<int, 2>, 6> TetrahedronEdges = { { { { 0, 1 } }, { { 1, 2 } },
  { { 2, 0 } }, { { 0, 3 } }, { { 1, 3 } }, { { 2, 3 } } } };

/** The corner that is not on face k (TetrahedronFaces). */
constexpr std::array<int, 4> CornerAcrossFrom = { { 2, 0, 1, 3 } };

/** Face k of a cell. */
constexpr Triangle FaceOf(const Tetrahedron& cell, int k)
{
  return { { cell[TetrahedronFaces[k][0]], cell[TetrahedronFaces[k][1]],
    cell[TetrahedronFaces[k][2]] } };
}
} // namespace insideout
