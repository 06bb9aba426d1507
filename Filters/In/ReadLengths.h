// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The edge lengths that arrays of data sets ask for.
 */
#pragma once

#include "Common/Types.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataSet;

namespace vtkInsideOut
{
/**
 * The lengths at the points of a grid, infinite where the array has NaN. Empty where it has no
 * point array of this name.
 *
 * @throws insideout::Error that names what is wrong with the array
 */
std::vector<double> ReadLengths(vtkDataSet* grid, const std::string& name);

/**
 * The length anywhere in a background, linear between its points; infinite outside and where it is
 * NaN. For one thread.
 *
 * @throws insideout::Error where the background has no such point array, or a length is not
 *   positive
 */
std::function<double(const insideout::Point&)> LengthsWithin(
  vtkDataSet* background, const std::string& name);
} // namespace vtkInsideOut
