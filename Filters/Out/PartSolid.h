// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Copies points of a solid where it touches itself, and cells where it overlaps itself.
 */
#pragma once

#include "Common/Statistics.h"
#include "HullMesh.h"
#include "Output/ManifoldBoundary.h"
#include "Output/PartedSolid.h"

#include <vtkSmartPointer.h>

class vtkUnstructuredGrid;

namespace vtkInsideOut
{
/** A solid that has been parted, and what is to be told of that. */
struct Parting
{
  insideout::PartedSolid Solid;
  insideout::Statistics Statistics; ///< SplitPoints, or Overlaps, SeparatedOverlaps, CopiedCells
  std::vector<std::string> Warnings;
};

/** Give layers that overlap cells of their own. @throws insideout::Error Stopped */
void SeparateOverlaps(const insideout::HullMesh& hull, Parting& parting,
  insideout::Monitor& monitor, const insideout::ProgressRange& progress);

/** Copy points in which the solid touches itself. @throws insideout::Error Stopped */
void SplitPoints(
  Parting& parting, insideout::Monitor& monitor, const insideout::ProgressRange& progress);

/**
 * Count and warn of what a boundary has several times, and cells once.
 *
 * @param[in,out] statistics gains SharedPoints and NonManifoldEdges
 */
void TellOfSharedPoints(const insideout::ManifoldSurface& boundary,
  insideout::Statistics& statistics, std::vector<std::string>& warnings);

/** The grid that the solid was made of with the solid's points and cells: copies have the data of
 * what they are copies of, and its vtkOriginalPointIds. */
vtkSmartPointer<vtkUnstructuredGrid> MakePartedGrid(
  vtkUnstructuredGrid* grid, const Parting& parting);
} // namespace vtkInsideOut
