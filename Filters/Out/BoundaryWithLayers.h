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
 * The triangles of the new boundary: those with layers unchanged, others moved behind the layers,
 * and between them the sides of layers, quads as two triangles. Sides have the data of a triangle
 * of their facet; new points the data of the wall's point in front of them.
 */
vtkSmartPointer<vtkPolyData> BoundaryWithLayers(vtkPolyData* boundary, const LayeredSolid& solid);
} // namespace vtkInsideOut
