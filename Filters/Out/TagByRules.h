// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Tags of a boundary by geometry.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "Output/TagRules.h"

#include <string>
#include <vector>

namespace vtkInsideOut
{
/**
 * Give triangles the names of the rules that they satisfy, in the arrays of AddTags; the others
 * keep their tags. A name that is there already is the same tag; names without a triangle go.
 *
 * @param[in,out] boundary with vtkOriginalCellIds
 * @return a warning for each rule without a triangle
 * @throws insideout::Error where the boundary lacks an array that a rule names
 */
std::vector<std::string> TagByRules(
  const std::vector<insideout::TagRule>& rules, vtkPolyData* boundary);
} // namespace vtkInsideOut
