// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Makes boundary layers in a grid of triangles in a plane. */
#pragma once

#include "Out/MakeLayers.h"

namespace vtkInsideOut
{
/** MakeLayers of triangles, all of whose parameters but heights are checked. */
Layering MakeLayersInPlane(vtkUnstructuredGrid* grid, vtkPolyData* boundary,
  const std::vector<std::string>& tags, const insideout::LayerParameters& parameters,
  insideout::Monitor& monitor);
} // namespace vtkInsideOut
