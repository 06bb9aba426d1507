// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The points of the input that points in its cells are made of.
 */
#pragma once

#include "Common/TetrahedralMesh.h"
#include "Data/Attributes.h"

#include <vector>

namespace vtkInsideOut
{
/**
 * A mixture per point: the corners of a cell that holds it, or is near it, by barycentric weights,
 * none of which is negative.
 *
 * @param[in] originals the point of the mesh that each is, which it is made of then; None for a new
 *   one
 * @param[in] cells of the mesh that hold them
 */
std::vector<Attributes::Mixture> MixInCells(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Point>& points, const std::vector<insideout::Id>& originals,
  const std::vector<insideout::Id>& cells);
} // namespace vtkInsideOut
