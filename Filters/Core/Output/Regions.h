// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/CellRegions.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * The parts of the solid, numbered by their first cell. Faces connect: cells that share no more
 * than an edge or a point belong to one region only if faces of cells inside connect them. Facets
 * between cells inside part nothing.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @throws Error InvalidParameter when there is not one label per cell; Stopped
 */
SolidRegions FindRegions(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/**
 * Find regions that facets with multiplicity 0 separate, too: membranes, facets that do not
 * participate, and copies that cancel. A facet separates nothing if cells connect around its rim.
 */
SolidRegions FindSeparatedRegions(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
