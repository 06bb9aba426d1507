// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Refines a grid of tetrahedra and transfers its data, for filters. */
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Data/VtkClasses.h"
#include "Output/MassProperties.h"
#include "Quality/SolverFitness.h"
#include "Refine/RefineTetrahedra.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** A refined grid, with warnings and statistics. */
struct Refinement
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkPolyData> Boundary;         ///< if one is given
  bool ChangesMasses = false;                    ///< whether the surface may have moved
  std::vector<insideout::MassProperties> Masses; ///< of the regions, if so
  insideout::MassProperties Mass;                ///< of all, if so
  insideout::SolverFitness Fitness;
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Refine as vtkRefineTetrahedra describes: the grid with its data, and with its field data
 * unchanged.
 *
 * @param[in] boundary of the grid, a triangle for each of its faces in their order (not needed if
 * the surface is kept), with their data; edges between different values of its cell array
 * BoundaryTag stay. Null: none.
 * @throws insideout::Error that names the culprit; Stopped
 */
Refinement RefineGrid(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const insideout::RefinementParameters& parameters, bool quadratic, insideout::Monitor& monitor);
} // namespace vtkInsideOut
