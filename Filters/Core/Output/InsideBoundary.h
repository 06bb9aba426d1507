// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Common/ProgressRange.h"
#include "Common/TetrahedralMesh.h"

#include <vector>

namespace insideout
{
/** @throws Error InvalidParameter if there is not one label per cell */
void CheckLabels(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside);

/** A face between an inside cell and the outside. */
struct BoundaryFace
{
  Triangle Corners; ///< points of the mesh, counter-clockwise seen from outside the solid
  Id Cell;          ///< the inside cell
  int Face;         ///< index of the face in the cell (TetrahedronFaces)
  Id Facet;         ///< facet of the complex that the face lies on, None for none
};

/**
 * The boundary of the union of the inside cells: their faces with no inside cell beyond. It is
 * watertight: each edge has the same number of faces in both directions.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @return faces in the order of their cells, then of the faces in the cell
 * @throws Error InvalidParameter if there is not one label per cell; Stopped
 */
std::vector<BoundaryFace> BoundaryFaces(const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
