// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The parts of an assembly, of which each of several processes (ranks) holds pieces, and how they
 * come together. All functions that take a controller have to be called by all ranks.
 */
#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataObjectTree;
class vtkMultiProcessController;
class vtkPolyData;

namespace vtkInsideOut
{
/** What this rank holds of each part: blocks, or partitioned data sets, in order. */
struct Assembly
{
  explicit Assembly(vtkDataObjectTree* assembly);

  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>>
    Pieces; ///< without ghost cells and empty ones
  vtkSmartPointer<vtkDataObjectTree> Structure;
  vtkIdType Others = 0; ///< how many blocks are no vtkPolyData
};

/**
 * Gives the output all ranks' structure, and ranks that have no parts at all as many as others.
 *
 * @return what ranks disagree on; nothing, or the same on all of them
 */
std::string Agree(
  Assembly& parts, vtkDataObjectTree* output, vtkMultiProcessController* controller);

/** For each part, on all ranks together. */
std::vector<vtkIdType> CountCells(const Assembly& parts, vtkMultiProcessController* controller);

/**
 * Sends each part to the rank that owns it.
 *
 * @param[in,out] warnings gains a line per array that not all pieces of a part have
 * @return the parts of this rank, of the pieces of all, in their order; none where it is another's
 * or empty
 */
std::vector<vtkSmartPointer<vtkPolyData>> MoveParts(const Assembly& parts,
  const std::vector<int>& owners, vtkMultiProcessController* controller,
  std::vector<std::string>& warnings);

/** Puts parts in their places. */
void SetParts(const std::vector<vtkSmartPointer<vtkPolyData>>& parts, vtkDataObjectTree* assembly);
} // namespace vtkInsideOut
