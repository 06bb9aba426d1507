// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Interpolation of points within the input's cells. */
#pragma once

#include "Common/PlanarPoint.h"
#include "Common/TetrahedralMesh.h"
#include "Data/Attributes.h"

#include <vector>

namespace vtkInsideOut
{
/**
 * The origin of each point: the corners of a cell that contains it, or is near it, with nonnegative
 * barycentric weights.
 *
 * @param[in] originals the point of the mesh that each is, then its only origin; None for a new one
 * @param[in] cells of the mesh that hold them
 */
std::vector<Attributes::Mixture> MixInCells(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Point>& points, const std::vector<insideout::Id>& originals,
  const std::vector<insideout::Id>& cells);

/** The origin of a new point in a triangle of a plane, or near it. */
Attributes::Mixture MixInTriangle(const std::vector<insideout::PlanarPoint>& points,
  const insideout::Triangle& cell, const insideout::PlanarPoint& place);
} // namespace vtkInsideOut
