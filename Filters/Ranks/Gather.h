// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Gathers a surface whose MPI pieces several processes (ranks) hold on the first of them.
 *
 * The counts and orientations of facets depend on the whole surface: duplicates cancel, points are
 * merged and shells are turned across borders of pieces.
 */
#pragma once

#include "Data/VtkClasses.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/**
 * Whether each rank is asked for its own piece of an output, so that all make the same calls. A
 * single process that works alone, such as rank 0 of pvbatch in its script, is not.
 */
bool AllRanksWork(vtkMultiProcessController* controller, vtkInformation* output);

/**
 * The concatenated pieces of all ranks, without ghost cells, on the first rank; an empty surface on
 * the others. All ranks have to call it.
 *
 * @param arrays the names of the required cell arrays
 * @param cloudArrays those of a cloud's required point arrays, besides its normals; no other data
 * are gathered
 * @throws insideout::Error on all ranks if memory is short on one
 */
vtkSmartPointer<vtkPolyData> Gather(vtkPolyData* piece, const std::vector<std::string>& arrays,
  const std::vector<std::string>& cloudArrays, vtkMultiProcessController* controller);
} // namespace vtkInsideOut
