// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The second input of the filters that segment: seeds, which are optional.
 */
#pragma once

#include "GraphCut/Seeds.h"

class vtkInformation;
class vtkInformationVector;

namespace vtkInsideOut
{
/** FillInputPortInformation of such a filter, whose first input is of this type. */
int FillPort(int port, vtkInformation* info, const char* firstType);

/**
 * The points of the second input as seeds, by their array Inside: 0 is outside, everything else
 * inside. None where nothing is connected.
 *
 * @throws insideout::Error when there are points, but no such array
 */
std::vector<insideout::Seed> ReadSeeds(vtkInformationVector** inputVector);
} // namespace vtkInsideOut
