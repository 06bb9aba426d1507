// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file The parts of an assembly, of which each of several processes (ranks) holds MPI pieces, and
 * their collection. All functions with a controller have to be called by all ranks.
 */
#pragma once

#include "Data/VtkClasses.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** This rank's piece of each part: blocks, or partitioned data sets, in order. */
struct Assembly
{
  explicit Assembly(vtkDataObjectTree* assembly);

  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>>
    Pieces; ///< without ghost cells and empty ones
  vtkSmartPointer<vtkDataObjectTree> Structure;
  vtkIdType Others = 0; ///< number of blocks other than vtkPolyData
};

/**
 * Give the output all ranks' structure, and ranks without parts as many as others.
 *
 * @return a description of ranks' disagreement, equal on all ranks; empty if there is none
 */
std::string Agree(
  Assembly& parts, vtkDataObjectTree* output, vtkMultiProcessController* controller);

/** For each part, summed over all ranks. */
std::vector<vtkIdType> CountCells(const Assembly& parts, vtkMultiProcessController* controller);

/**
 * Send each part to the rank that owns it.
 *
 * @param[in,out] warnings gains a line per array that some MPI pieces of a part lack
 * @return the parts of this rank, from all ranks' pieces, in their order; null if it is another
 * rank's or empty
 */
std::vector<vtkSmartPointer<vtkPolyData>> MoveParts(const Assembly& parts,
  const std::vector<int>& owners, vtkMultiProcessController* controller,
  std::vector<std::string>& warnings);

/** Put parts into their positions. */
void SetParts(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, vtkDataObjectTree* assembly);
} // namespace vtkInsideOut
