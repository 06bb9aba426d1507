// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * A surface whose pieces several processes (ranks) hold, whole on the first of them.
 *
 * Which facets count, and which way they face, is a matter of the whole surface: duplicates cancel,
 * points are merged and shells are turned across the border of pieces.
 */
#pragma once

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkInformation;
class vtkMultiProcessController;
class vtkPolyData;

namespace vtkInsideOut
{
/**
 * Whether each rank is asked for its own piece of an output, so that all of them come to the same
 * calls. A single process that works on its own, as rank 0 of pvbatch in its script, is not.
 */
bool AllRanksWork(vtkMultiProcessController* controller, vtkInformation* output);

/**
 * The pieces of all ranks, one after the other, without their ghost cells, on the first rank; on
 * the others an empty surface. All ranks have to call it.
 *
 * @param arrays the names of the cell arrays that matter
 * @param cloudArrays those of the point arrays that matter of a cloud, beside its normals; no other
 * data go along
 * @throws insideout::Error where memory is short on a rank, on all of them
 */
vtkSmartPointer<vtkPolyData> Gather(vtkPolyData* piece, const std::vector<std::string>& arrays,
  const std::vector<std::string>& cloudArrays, vtkMultiProcessController* controller);
} // namespace vtkInsideOut
