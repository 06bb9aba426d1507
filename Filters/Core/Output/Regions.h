// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/CellRegions.h"
#include "Common/TetrahedralMesh.h"

namespace insideout
{
/**
 * The parts of the solid, numbered by their first cell. Faces connect: cells that have no more than
 * an edge or a point in common belong to one region only if there is a way from one to the other
 * through faces of cells inside. Facets between cells inside part nothing.
 *
 * @param[in] inside one value per cell, 0 for outside
 * @throws Error InvalidParameter when there is not one label per cell; Stopped
 */
SolidRegions FindRegions(const TetrahedralMesh& mesh, const std::vector<unsigned char>& inside,
  Monitor& monitor, const ProgressRange& progress);

/**
 * The same, but facets that count 0 separate regions: membranes, facets that do not participate and
 * copies that cancel. Only those that part the cells whole do: cells around the rim of a facet are
 * one region.
 */
SolidRegions FindSeparatedRegions(const FacetComplex& surface, const TetrahedralMesh& mesh,
  const std::vector<unsigned char>& inside, Monitor& monitor, const ProgressRange& progress);
} // namespace insideout
