// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Refines a grid of tetrahedra and carries its data over, for the filters that do.
 */
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Refine/SizingField.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkUnstructuredGrid;

/** A refined grid, and what is to be said about it. */
struct vtkInsideOutRefinement
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/** What vtkRefineTetrahedra describes: the grid with its data, and with its field data as it is.
 *
 * @throws insideout::Error that names the culprit; Stopped
 */
vtkInsideOutRefinement vtkInsideOutRefine(vtkUnstructuredGrid* grid,
  const insideout::SizingParameters& parameters, bool quadratic, insideout::Monitor& monitor);
