// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Copies points of a solid where it touches itself, and cells where it overlaps itself.
 */
#pragma once

#include "Common/Statistics.h"
#include "Data/VtkClasses.h"
#include "HullMesh.h"
#include "Output/ManifoldBoundary.h"
#include "Output/PartedSolid.h"

#include <vtkSmartPointer.h>

namespace vtkInsideOut
{
/** A separated solid, with warnings and statistics. */
struct Parting
{
  insideout::PartedSolid Solid;
  insideout::Statistics Statistics; ///< SplitPoints, or Overlaps, SeparatedOverlaps, CopiedCells
  std::vector<std::string> Warnings;
};

/** Give overlapping layers their own cells. @throws insideout::Error Stopped */
void SeparateOverlaps(const insideout::HullMesh& hull, Parting& parting,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress);

/** Copy points at which the solid touches itself. @throws insideout::Error Stopped */
void SplitPoints(
  Parting& parting, insideout::Monitor& monitor, const insideout::ProgressRange& progress);

/**
 * Count and warn of repeated points of a boundary that cells have once.
 *
 * @param[in,out] statistics gains SharedPoints and NonManifoldEdges
 */
void TellOfSharedPoints(const insideout::ManifoldSurface& boundary,
  insideout::Statistics& statistics, std::vector<std::string>& warnings);

/** The grid from which the solid was made, with the solid's points and cells: copies have the data
 * of their originals, including vtkOriginalPointIds. */
vtkSmartPointer<vtkUnstructuredGrid> MakePartedGrid(
  vtkUnstructuredGrid* grid, const Parting& parting);
} // namespace vtkInsideOut
