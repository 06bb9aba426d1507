// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Carries the boundary of a solid over to the solid with layers.
 */
#pragma once

#include "Common/TetrahedralMesh.h"
#include "Data/VtkClasses.h"
#include "Layers/BoundaryLayers.h"

#include <vtkSmartPointer.h>

#include <vector>

namespace vtkInsideOut
{
/** A solid before and after. */
struct LayeredSolid
{
  const insideout::TetrahedralMesh& Before;
  const std::vector<insideout::Id>& Faces; ///< per triangle of the boundary, 4 * cell + face
  const std::vector<char>& IsLayered;      ///< per triangle
  const insideout::LayeredMesh& After;
};

/**
 * The triangles of a boundary where they are now: those with layers as they were, others behind the
 * layers, and in between the sides of layers, quads as two triangles. These have the data of a
 * triangle of their facet; new points those of the point of the wall that they are behind.
 */
vtkSmartPointer<vtkPolyData> BoundaryWithLayers(vtkPolyData* boundary, const LayeredSolid& solid);
} // namespace vtkInsideOut
