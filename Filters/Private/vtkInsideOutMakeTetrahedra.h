// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * From the hull of a surface to data sets: what vtkRobustTetrahedralize does in three dimensions.
 */
#pragma once

#include "Refine/RefineTetrahedra.h"
#include "vtkInsideOutMakeSolidSurfaces.h"
#include "vtkInsideOutSegmentHull.h"

#include <optional>

/** The options that matter after the hull. */
struct vtkInsideOutSolidOptions
{
  vtkInsideOutSegmentOptions Segment;
  vtkInsideOutBoundaryOptions Boundary;
  bool GenerateHull = false; ///< vtkInsideOutTetrahedra::Hull, too
  bool SeparateOverlaps = false;
  bool SplitPoints = false; ///< where the solid touches itself
  bool Refine = false;
  insideout::RefinementParameters Refinement;
  bool QuadraticCells = false;
};

/** Outputs, and what is to be told of them. */
struct vtkInsideOutTetrahedra
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< with all statistics
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Outliers;
  vtkSmartPointer<vtkUnstructuredGrid> Hull; ///< all cells, with the same statistics; or null
  std::vector<std::string> Warnings;
};

/**
 * Where a surface is closed and nothing that is asked for takes tetrahedra: its boundary without
 * them. The grid has no cells. Else nothing, and where nothing is inside, for the tetrahedra tell
 * why.
 *
 * @param[in] hasSeeds whether there are seeds
 * @throws insideout::Error Stopped
 */
std::optional<vtkInsideOutTetrahedra> vtkInsideOutMakeSurfaceOnly(const vtkInsideOutHull& kept,
  bool hasSeeds, const vtkInsideOutTags& tags, const vtkInsideOutSolidOptions& options,
  insideout::Monitor& monitor);

/**
 * The stages after w, of a hull that is filled.
 *
 * @param[in] points that the seeds were read from, or null
 * @throws insideout::Error that names the culprit; Stopped
 */
vtkInsideOutTetrahedra vtkInsideOutMakeTetrahedra(const vtkInsideOutHull& kept,
  const std::vector<insideout::Seed>& seeds, vtkPointSet* points, const vtkInsideOutTags& tags,
  const vtkInsideOutSolidOptions& options, insideout::Monitor& monitor);
