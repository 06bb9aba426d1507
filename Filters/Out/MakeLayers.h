// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Makes boundary layers in a grid of tetrahedra or triangles and transfers its data. */
#pragma once

#include "Common/Monitor.h"
#include "Common/Statistics.h"
#include "Data/VtkClasses.h"
#include "Layers/LayerParameters.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** A grid with layers, and its warnings and statistics. */
struct Layering
{
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  vtkSmartPointer<vtkPolyData> Boundary; ///< without a boundary none
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Make the output that vtkBoundaryLayers describes.
 *
 * @param[in] boundary null: the faces of one cell, without tags; in a plane the edges
 * @param[in] tags of the wall; empty: all of the boundary is
 * @throws insideout::Error that names the culprit; Stopped
 */
Layering MakeLayers(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const std::vector<std::string>& tags, const insideout::LayerParameters& parameters,
  insideout::Monitor& monitor);
} // namespace vtkInsideOut
