// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file From the hull of a surface to data sets: the three-dimensional part of
 * vtkRobustTetrahedralize.
 */
#pragma once

#include "Out/MakeSolidSurfaces.h"
#include "Out/SegmentHull.h"
#include "Refine/RefineTetrahedra.h"

#include <optional>

namespace vtkInsideOut
{
/** The options of stages after the hull. */
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
  int QuadratureOrder = 1; ///< of w in refined cells, see WindingNumberOfCells
};

/** Outputs, with warnings and statistics. */
struct Tetrahedra
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid; ///< with all statistics
  vtkSmartPointer<vtkPolyData> Boundary;
  vtkSmartPointer<vtkPolyData> Outliers;
  vtkSmartPointer<vtkUnstructuredGrid> Hull; ///< all cells, with the same statistics; or null
  std::vector<std::string> Warnings;
};

/**
 * The boundary of a closed surface without tetrahedra, if no requested output needs them. The grid
 * then has no cells. Returns nothing otherwise, and if nothing is inside, because finding the cause
 * needs tetrahedra.
 *
 * @param[in] hasSeeds whether there are seeds
 * @throws insideout::Error Stopped
 */
std::optional<Tetrahedra> MakeSurfaceOnly(const KeptHull& kept, bool hasSeeds, const Tags& tags,
  const SolidOptions& options, insideout::Monitor& monitor);

/**
 * The stages after w on a filled hull.
 *
 * @param[in] points from which the seeds were read, or null
 * @throws insideout::Error that names the culprit; Stopped
 */
Tetrahedra MakeTetrahedra(const KeptHull& kept, const std::vector<insideout::Seed>& seeds,
  vtkPointSet* points, const Tags& tags, const SolidOptions& options, insideout::Monitor& monitor);
} // namespace vtkInsideOut
