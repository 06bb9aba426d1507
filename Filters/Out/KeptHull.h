// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file The hull of an input, and its cache key: vtkRobustTetrahedralize keeps it while only
 * parameters of later stages change.
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
/** The input's part of the cache key: the names of arrays; the names of blocks that are bodies; and
 * the modification time of the last block or partition, which a composite data set does not
 * provide. */
struct HullArrays
{
  std::string NonParticipating;
  std::string Bodies;
  std::vector<std::string> BlockNames;
  vtkMTimeType BlocksTime = 0;
};

/** The cache key of the hull. Does not compile once a parameter is added, as a reminder to extend
 * it. */
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

/** The results of a surface's stages, from validation to w. */
struct KeptHull
{
  /** Reads the surface. @throws insideout::Error */
  KeptHull(vtkPolyData* input, const HullArrays& names);

  /** Stages validate and pre, without access to VTK objects. @throws insideout::Error */
  void Resolve(const insideout::HullMeshParameters& parameters, insideout::Monitor& monitor);

  /** The other stages, unless done, without access to VTK objects.
   * @throws insideout::Error; nothing is changed then
   */
  void Fill(const insideout::HullMeshParameters& parameters, insideout::Monitor& monitor);

  /** Make Grid, unless it exists. */
  void MakeGrid();

  vtkInsideOut::Surface Surface;
  vtkInsideOut::Bodies Bodies;
  MakeOutputs Outputs; ///< to be copied: each run adds its own warnings
  insideout::HullMesh Hull;
  bool IsFilled = false;
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< null until made
  std::exception_ptr Failure;                ///< the error, if meshed ahead
};
} // namespace vtkInsideOut
