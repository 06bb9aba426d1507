// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The boundary of a refined grid, with the data of the original boundary. */
#pragma once

#include "Data/VtkClasses.h"
#include "Refine/RefineTetrahedra.h"

#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace vtkInsideOut
{
/** The weights of a triangle's corners at a place in it or near it, and 0: all at least 0. */
std::array<double, 4> WeightsIn(
  const std::array<insideout::Point, 3>& triangle, const insideout::Point& place);

/**
 * The tags of the faces of cells that are on the boundary, or between regions.
 *
 * @param[in] regions one per cell; empty if there is one
 * @param[in] boundary a triangle for each of these faces, in the order of FindRegionBoundaries, and
 *   its tag in the cell array BoundaryTag
 */
std::vector<std::array<insideout::Id, 4>> LabelsOf(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Id>& regions, vtkPolyData* boundary);

/** The tag of each triangle; none without BoundaryTag. */
std::vector<insideout::Id> TagsOf(vtkPolyData* boundary);

/** The tag of triangles that close holes: those with no triangle of the input in
 * vtkOriginalCellIds. None if there are none. */
insideout::Id LabelOfHoles(vtkPolyData* boundary);

/** As LabelsOf, for all cell data but vtkOriginalCellIds: the same number where these are the same.
 */
std::vector<std::array<insideout::Id, 4>> AttributesOf(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Id>& regions, vtkPolyData* boundary);

/**
 * The boundary of a refined mesh. Each triangle has the cell data of the original triangle that
 * contains it, or is nearest to it; point data are interpolated in the nearest triangle.
 *
 * @param[in] mesh, regions before
 * @param[in] before its boundary, as above
 */
vtkSmartPointer<vtkPolyData> RefineBoundary(const insideout::TetrahedralMesh& mesh,
  const std::vector<insideout::Id>& regions, const insideout::RefinedMesh& refined,
  vtkPolyData* before, std::vector<std::string>& warnings);
} // namespace vtkInsideOut
