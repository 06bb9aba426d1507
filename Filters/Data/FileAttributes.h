// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The attributes of surface files as VTK's arrays, and back.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "Files/SurfaceFile.h"

#include <vtkType.h>

#include <vector>

namespace vtkInsideOut
{
/** Add an attribute as an array; normals, texture coordinates and colors also as VTK's active ones.
 */
void AddAttribute(const insideout::Attribute& attribute, vtkDataSetAttributes* data);

/**
 * The numeric arrays of the points or cells with these ids. VTK's normals, texture coordinates and
 * colors (scalars of 3 or 4 unsigned char) are named Normals, TCoords and Colors; other arrays keep
 * their names. Integers of other types become int, or double if they do not fit.
 */
std::vector<insideout::Attribute> ReadAttributes(
  vtkDataSetAttributes* data, const std::vector<vtkIdType>& ids);

/** The string arrays with one string per number: the names of an attribute's numbers. */
std::vector<insideout::AttributeNames> ReadNames(vtkFieldData* data);
} // namespace vtkInsideOut
