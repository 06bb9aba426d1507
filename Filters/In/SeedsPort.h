// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The second input of the filters that segment: seeds, which are optional. Those of all blocks of a
 * composite data set are one set.
 */
#pragma once

#include "GraphCut/Seeds.h"

#include <vtkSmartPointer.h>

class vtkInformation;
class vtkInformationVector;
class vtkPointSet;

namespace vtkInsideOut
{
/** FillInputPortInformation of such a filter, whose first input is of this type. */
int FillPort(int port, vtkInformation* info, const char* firstType);

/** The points of the second input; null where there are none. */
vtkSmartPointer<vtkPointSet> FindSeeds(vtkInformationVector** inputVector);

/**
 * Such points as seeds, by their array Inside: 0 is outside, everything else inside. None where
 * there are no points.
 *
 * @throws insideout::Error when there are points, but no such array
 */
std::vector<insideout::Seed> ReadSeeds(vtkPointSet* points);
} // namespace vtkInsideOut
