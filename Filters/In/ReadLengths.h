// SPDX-License-Identifier: GPL-3.0-or-later
/** @file The edge lengths given by arrays of data sets. */
#pragma once

#include "Common/Types.h"
#include "Data/VtkClasses.h"

#include <functional>
#include <string>
#include <vector>

namespace vtkInsideOut
{
/**
 * The lengths at the points of a grid, infinite where the array has NaN. Empty without a point
 * array of this name.
 *
 * @throws insideout::Error with the defect of the array
 */
std::vector<double> ReadLengths(vtkDataSet* grid, const std::string& name);

/**
 * The length anywhere in a background, linear between its points; infinite outside and for NaN. Not
 * thread-safe.
 *
 * @throws insideout::Error if the background has no such point array, or a length is not positive
 */
std::function<double(const insideout::Point&)> LengthsWithin(
  vtkDataSet* background, const std::string& name);
} // namespace vtkInsideOut
