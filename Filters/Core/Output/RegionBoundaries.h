// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Output/InsideBoundary.h"
#include "Output/Regions.h"

namespace insideout
{
/** The faces between regions, and between regions and the outside. */
struct RegionBoundaries
{
  /** First the faces to the outside, the boundary of all regions together (BoundaryFaces); then the
   * interfaces, each face once, as a face of the cell of the lower region; in the order of their
   * cells. */
  std::vector<BoundaryFace> Faces;

  /** For each face the region of its cell, and the region beyond: None for outside. */
  std::vector<std::array<Id, 2>> Regions;
};

/** @throws Error InvalidParameter if there is not one region per cell; Stopped */
RegionBoundaries FindRegionBoundaries(const TetrahedralMesh& mesh, const SolidRegions& regions,
  Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
