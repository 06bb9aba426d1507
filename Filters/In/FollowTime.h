// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file The time of filters that have several inputs. VTK takes an output's time from the first
 * input only: if another input is time-dependent, downstream would not request its time steps, and
 * the filter would not run again.
 */
#pragma once

#include "Data/VtkClasses.h"

namespace vtkInsideOut
{
/**
 * Set the outputs' time steps and time range to those of all inputs together; called from
 * RequestInformation. Each execution repeats this, because VTK resets them to those of the first
 * input after the blocks of a composite one. If other inputs than the first are time-dependent, the
 * output is marked with the requested time.
 *
 * @return 1, for RequestInformation
 */
int FollowTime(vtkAlgorithm* algorithm);
} // namespace vtkInsideOut
