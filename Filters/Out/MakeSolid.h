// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Makes VTK's data sets of a solver's file.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "Files/SolidFile.h"

#include <vtkSmartPointer.h>

namespace vtkInsideOut
{
/** The tetrahedra of a file with RegionId and RegionNames, or its triangles if there are none. */
vtkSmartPointer<vtkUnstructuredGrid> MakeSolid(const insideout::SolidContent& solid);

/** The triangles besides tetrahedra with BoundaryTag and BoundaryTagNames, and their points; empty
 * if the triangles are the solid. */
vtkSmartPointer<vtkPolyData> MakeSolidBoundary(const insideout::SolidContent& solid);
} // namespace vtkInsideOut
