// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Labels of cells that stand on their points, as in surfaces of segmented images.
 */
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkAbstractArray;
class vtkPolyData;

namespace vtkInsideOut
{
/**
 * A cell array of what a point array of one value says at the corners of each cell; nullptr where
 * there is no such array.
 *
 * @throws insideout::Error when corners of a cell differ
 */
vtkSmartPointer<vtkAbstractArray> ValuesOfCorners(vtkPolyData* surface, const std::string& name);
} // namespace vtkInsideOut
