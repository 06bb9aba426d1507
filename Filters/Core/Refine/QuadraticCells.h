// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Edge.h"

#include <vector>

namespace insideout
{
/** Four corners, and the points amid the edges 01, 12, 20, 03, 13 and 23, as vtkQuadraticTetra. */
using QuadraticTetrahedron = std::array<Id, 10>;

/** Cells of second order, of which neighbors share the points amid their edges. */
struct QuadraticCells
{
  std::vector<QuadraticTetrahedron> Cells;

  /** Per point that is amid an edge, in the order of their ids, which follow the corners': whose.
   * They ascend. */
  std::vector<Edge> Edges;
};

/** @throws Error TooLarge when there would be more points than can be counted */
QuadraticCells MakeQuadraticCells(Id numberOfPoints, const std::vector<Tetrahedron>& cells);
} // namespace insideout
