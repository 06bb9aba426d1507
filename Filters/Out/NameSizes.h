// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Finds the tags and regions that rules of sizes name. */
#pragma once

#include "Data/VtkClasses.h"

#include "Refine/RefineTetrahedra.h"

namespace vtkInsideOut
{
/** Whether a rule of sizes names a tag. */
bool SizesNameTags(const std::vector<insideout::SizeRule>& rules);

/**
 * Set the labels of rules that name tags, and the lengths within cells of those that name regions.
 *
 * @param[in] boundary with BoundaryTagNames; null: there are no tags
 * @throws insideout::Error that names the rule and, where it names none of these, all of them
 */
void NameSizes(
  vtkUnstructuredGrid* grid, vtkPolyData* boundary, insideout::SizingParameters& sizes);
} // namespace vtkInsideOut
