// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * The hull of an input, and what decides about it: vtkRobustTetrahedralize keeps it for as long as
 * only later stages change.
 */
#pragma once

#include "HullMesh.h"
#include "In/Bodies.h"
#include "Out/MakeOutputs.h"

#include <vtkType.h>

#include <exception>
#include <string>
#include <tuple>
#include <vector>

namespace vtkInsideOut
{
/** What of an input decides about the hull: the names of arrays; of blocks that are bodies their
 * names; and when the last block or partition was modified, which a composite data set does not
 * tell. */
struct HullArrays
{
  std::string NonParticipating;
  std::string Bodies;
  std::vector<std::string> BlockNames;
  vtkMTimeType BlocksTime = 0;
};

/** What decides about the hull, to be compared. Does not compile once a parameter is added: it may
 * not be missing here. */
inline auto AsTuple(const insideout::HullMeshParameters& parameters, const HullArrays& names)
{
  const auto& [chain, orientation, thicken, budgets, quadratureOrder, partsApart, touchTolerance] =
    parameters;
  const auto& [mergeTolerance, countDuplicates] = chain;
  const auto& [width, all] = thicken;
  const auto& [seconds, mebibytes, engine] = budgets;
  const auto& [nonParticipating, bodies, blockNames, blocksTime] = names;
  return std::make_tuple(mergeTolerance, countDuplicates, orientation, width, all, seconds,
    mebibytes, engine, quadratureOrder, partsApart, touchTolerance, nonParticipating, bodies,
    blockNames, blocksTime);
}

/** Stages validate to w of a surface. */
struct KeptHull
{
  /** Reads the surface. @throws insideout::Error */
  KeptHull(vtkPolyData* input, const HullArrays& names);

  /** Stages validate and pre, without touching anything of VTK's. @throws insideout::Error */
  void Resolve(const insideout::HullMeshParameters& parameters, insideout::Monitor& monitor);

  /** The other stages, unless they are done, without touching anything of VTK's.
   * @throws insideout::Error; all is then as it was before */
  void Fill(const insideout::HullMeshParameters& parameters, insideout::Monitor& monitor);

  /** Makes Grid of what is filled, unless it is there. */
  void MakeGrid();

  vtkInsideOut::Surface Surface;
  vtkInsideOut::Bodies Bodies;
  MakeOutputs Outputs; ///< to be copied: each run has warnings of its own
  insideout::HullMesh Hull;
  bool IsFilled = false;
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< null until made
  std::exception_ptr Failure;                ///< what went wrong where it was meshed ahead
};
} // namespace vtkInsideOut
