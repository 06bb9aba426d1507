// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The time of filters that have several inputs. VTK takes an output's time from the first input
 * alone: where another one moves, nothing downstream would ask for its time steps, and the filter
 * would not run again.
 */
#pragma once

class vtkAlgorithm;

namespace vtkInsideOut
{
/**
 * Give the outputs the time steps, and the range of time, of all inputs together: from
 * RequestInformation. Each execution gives them once more, for VTK takes those of the first input
 * again when it has gone through the blocks of one. The output is marked with the time that was
 * asked for where other inputs than the first move.
 *
 * @return 1, as RequestInformation has to
 */
int FollowTime(vtkAlgorithm* algorithm);
} // namespace vtkInsideOut
