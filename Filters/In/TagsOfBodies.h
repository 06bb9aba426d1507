// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Tags of several bodies on one surface: groups of different bodies are different tags. */
#pragma once

#include "Data/VtkClasses.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** An array of tags of all bodies. */
struct SharedTags
{
  std::string Array;
  vtkSmartPointer<vtkStringArray> Names; ///< of integers; null if strings or unnamed numbers tag
};

/**
 * Number the tags of all bodies together, separately for each array of tags (FindTagArrays) and
 * BoundaryTag. A tag keeps its name, but a name of several bodies is prefixed with the body's, as
 * in cut/floor. A body without the array has one tag, its own name. BoundaryTag is each body's
 * preferred array, as found by ReadTags. Numbers stay for a single body, and for unnamed integers
 * that no two bodies share.
 *
 * @param[in] names of the bodies
 * @param[in,out] bodies unshared surfaces that get the arrays
 * @param[in,out] warnings gains a line per array that does not tag in one body: it is renamed
 * BODY/ARRAY there
 */
std::vector<SharedTags> ShareTags(const std::vector<std::string>& names,
  const std::vector<vtkSmartPointer<vtkPolyData>>& bodies, std::vector<std::string>& warnings);

/** Tag the boundary's triangles on no cell of a body (vtkOriginalCellIds -1): they close a hole,
 * and are tagged hole in all arrays. */
void TagHoles(const std::vector<SharedTags>& shared, vtkPolyData* boundary);
} // namespace vtkInsideOut
