// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Cell labels given as a point array, as in surfaces of segmented images. */
#pragma once

#include "Data/VtkClasses.h"

#include <vtkSmartPointer.h>

#include <string>

namespace vtkInsideOut
{
/**
 * Convert a point array with one component to a cell array: each cell has the value of its corners.
 *
 * @return nullptr without such an array
 * @throws insideout::Error that names a cell whose corners have different values or do not exist
 */
vtkSmartPointer<vtkAbstractArray> ValuesOfCorners(vtkPolyData* surface, const std::string& name);
} // namespace vtkInsideOut
