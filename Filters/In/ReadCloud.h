// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Reads the points of a vtkPolyData without polygons, with their normals, as a point cloud.
 */
#pragma once

#include "Clouds/PointCloud.h"
#include "Data/VtkClasses.h"

#include <string>

namespace vtkInsideOut
{
/** Whether an input has points but no polygons and lines; vertices are ignored. */
bool IsCloud(vtkPolyData* input);

/** The points' normals, or an array of three components named Normals; nullptr if there is none. */
vtkDataArray* FindNormals(vtkPolyData* input);

/**
 * All points of a cloud, unchanged, including those in no vertex.
 *
 * @param[in] areas the name of a point array of one number; without such an array there are no
 * areas
 * @throws insideout::Error that names the missing array
 */
insideout::PointCloud ReadCloud(vtkPolyData* input, const std::string& areas);
} // namespace vtkInsideOut
