// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The attributes of surface files as VTK's arrays, and back.
 */
#pragma once

#include "Files/SurfaceFile.h"

#include <vtkType.h>

#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;

namespace vtkInsideOut
{
/** Add an attribute as an array, and as VTK's normals, texture coordinates or colors if it is
 * these. */
void AddAttribute(const insideout::Attribute& attribute, vtkDataSetAttributes* data);

/**
 * The numeric arrays of the points or cells with these ids. VTK's normals, texture coordinates and
 * colors (scalars of 3 or 4 unsigned char) are called Normals, TCoords and Colors, whatever their
 * name; other arrays keep theirs. Integers of other types become int, or double where they do not
 * fit.
 */
std::vector<insideout::Attribute> ReadAttributes(
  vtkDataSetAttributes* data, const std::vector<vtkIdType>& ids);

/** The arrays of strings, one for each number: the names of what attributes number. */
std::vector<insideout::AttributeNames> ReadNames(vtkFieldData* data);
} // namespace vtkInsideOut
