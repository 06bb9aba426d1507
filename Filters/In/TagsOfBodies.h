// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Tags of several bodies on one surface: what one body calls a group is no group of another.
 */
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkPolyData;
class vtkStringArray;

namespace vtkInsideOut
{
/** An array of tags that all bodies have now. */
struct SharedTags
{
  std::string Array;
  vtkSmartPointer<vtkStringArray> Names; ///< of integers; null where strings or bare numbers tag
};

/**
 * Number the tags of all bodies as one, each array of tags (FindTagArrays) and BoundaryTag by
 * itself. A tag keeps its name. A name that several bodies use has the body's before it, as in
 * cut/floor, and a body without the array has one tag, its own name. BoundaryTag is what each body
 * says first of all, as ReadTags finds it. Numbers stay where there is nothing to tell apart: of a
 * single body, and of integers without names that no two bodies share.
 *
 * @param[in] names of the bodies
 * @param[in,out] bodies get the arrays: surfaces that nobody else has
 * @param[in,out] warnings gains a line per array that has something else than tags in one body: it
 *   is called BODY/ARRAY there
 */
std::vector<SharedTags> ShareTags(const std::vector<std::string>& names,
  const std::vector<vtkSmartPointer<vtkPolyData>>& bodies, std::vector<std::string>& warnings);

/** Tag the cells of a boundary that lie on no cell of a body (vtkOriginalCellIds -1): they close a
 * hole, and are called hole in all arrays of tags. */
void TagHoles(const std::vector<SharedTags>& shared, vtkPolyData* boundary);
} // namespace vtkInsideOut
