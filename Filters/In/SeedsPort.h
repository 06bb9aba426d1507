// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The second input of the filters that segment: seeds, which are optional. The blocks of a
 * composite data set are one set of seeds.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "GraphCut/Seeds.h"

#include <vtkSmartPointer.h>

namespace vtkInsideOut
{
/** FillInputPortInformation of such a filter, whose first input is of this type. */
int FillPort(int port, vtkInformation* info, const char* firstType);

/** The points of the second input; null if there is none. */
vtkSmartPointer<vtkPointSet> FindSeeds(vtkInformationVector** inputVector);

/**
 * Read points as seeds, by their array Inside: 0 is outside, all else inside. Without points there
 * are no seeds.
 *
 * @throws insideout::Error if there are points, but no such array
 */
std::vector<insideout::Seed> ReadSeeds(vtkPointSet* points);
} // namespace vtkInsideOut
