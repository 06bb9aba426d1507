// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"

#include <vector>

namespace insideout
{
/** Four corners, and the mid-edge nodes of 01, 12, 20, 03, 13 and 23, as in vtkQuadraticTetra. */
using QuadraticTetrahedron = std::array<Id, 10>;

/** Cells of second order; neighbors share their mid-edge nodes. */
struct QuadraticCells
{
  std::vector<QuadraticTetrahedron> Cells;

  /** The edge of each mid-edge node, in the order of their ids, which follow the corners'.
   * Ascending. */
  std::vector<Edge> Edges;
};

/** @throws Error TooLarge if there would be more points than can be counted */
QuadraticCells MakeQuadraticCells(Id numberOfPoints, const std::vector<Tetrahedron>& cells);
} // namespace insideout
