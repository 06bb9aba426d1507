// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * From the hull of a surface to data sets: what vtkRobustTetrahedralize does in three dimensions.
 */
#pragma once

#include "Out/MakeSolidSurfaces.h"
#include "Out/SegmentHull.h"
#include "Refine/RefineTetrahedra.h"

#include <optional>

namespace vtkInsideOut
{
/** The options that matter after the hull. */
struct SolidOptions
{
  SegmentOptions Segment;
  BoundaryOptions Boundary;
  bool GenerateHull = false; ///< Tetrahedra::Hull, too
  bool SeparateOverlaps = false;
  bool SplitPoints = false; ///< where the solid touches itself
  bool Refine = false;
  insideout::RefinementParameters Refinement;
  bool QuadraticCells = false;
};

/** Outputs, and what is to be told of them. */
struct Tetrahedra
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
std::optional<Tetrahedra> MakeSurfaceOnly(const KeptHull& kept, bool hasSeeds, const Tags& tags,
  const SolidOptions& options, insideout::Monitor& monitor);

/**
 * The stages after w, of a hull that is filled.
 *
 * @param[in] points that the seeds were read from, or null
 * @throws insideout::Error that names the culprit; Stopped
 */
Tetrahedra MakeTetrahedra(const KeptHull& kept, const std::vector<insideout::Seed>& seeds,
  vtkPointSet* points, const Tags& tags, const SolidOptions& options, insideout::Monitor& monitor);
} // namespace vtkInsideOut
