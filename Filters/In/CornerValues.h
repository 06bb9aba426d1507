// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Labels of cells in a point array, as in surfaces of segmented images.
 */
#pragma once

#include <vtkSmartPointer.h>

#include <string>

class vtkAbstractArray;
class vtkPolyData;

namespace vtkInsideOut
{
/**
 * Make a cell array of a point array with one component: each cell has the value of its corners.
 *
 * @return nullptr without such an array
 * @throws insideout::Error that names a cell whose corners have different values, or one that is
 * not there
 */
vtkSmartPointer<vtkAbstractArray> ValuesOfCorners(vtkPolyData* surface, const std::string& name);
} // namespace vtkInsideOut
