// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads the points of a vtkPolyData as those of a surface without polygons, with their normals.
 */
#pragma once

#include "Clouds/PointCloud.h"

#include <string>

class vtkDataArray;
class vtkPolyData;

namespace vtkInsideOut
{
/** Whether an input is points without polygons and lines; vertices do not matter. */
bool IsCloud(vtkPolyData* input);

/** The points' normals, or an array of three components that is called Normals; nullptr where there
 * is none. */
vtkDataArray* FindNormals(vtkPolyData* input);

/**
 * All points of a cloud, in no vertex too, as they are.
 *
 * @param[in] areas the name of a point array of one number; where there is none of this name there
 * are no areas
 * @throws insideout::Error that says what is missing
 */
insideout::PointCloud ReadCloud(vtkPolyData* input, const std::string& areas);
} // namespace vtkInsideOut
