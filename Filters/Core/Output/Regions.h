// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/CellRegions.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * The parts of the solid, numbered by their first cell. Cells are connected through faces, not
 * through edges or points. Facets between inside cells separate nothing.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @throws Error InvalidParameter if there is not one label per cell; Stopped
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
