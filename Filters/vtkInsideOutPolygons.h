// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutPolygons
 * @brief   Makes a vtkPolyData of what is read from a file, and back.
 */
#ifndef vtkInsideOutPolygons_h
#define vtkInsideOutPolygons_h

#include "Files/SurfaceFile.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

/** The polygons of a file, with their attributes. */
vtkSmartPointer<vtkPolyData> vtkInsideOutMakePolyData(const insideout::PolygonSurface& surface);

/**
 * The polygons and strips of a surface, for a file: strips become triangles, lines and vertices
 * stay behind. VTK's normals, texture coordinates and colours (scalars of 3 or 4 unsigned char) are
 * called Normals, TCoords and Colors, whatever their name; other numeric arrays keep theirs.
 * Integers of other types become int, or double where they do not fit.
 *
 * @throws insideout::Error that names the cell whose point is out of range
 */
insideout::PolygonSurface vtkInsideOutReadPolyData(vtkPolyData* input);

#endif
