// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/PlyHeader.h"

namespace insideout
{
/**
 * Read what follows the header of a PLY file (Turk, The PLY Polygon File Format, 1994). Faces, or
 * where there are none strips of triangles, become the polygons of `surface`, which has to have
 * none. Each number of the vertices and of the faces that became polygons is appended to its
 * property's Values, so that these are parallel to the vertices and to the polygons; other values,
 * and all lists but those, are read and dropped.
 *
 * In an ascii file, each element has its own line if there are as many lines as elements: what
 * stands behind its numbers is then passed over. Warnings name this, what follows the last element,
 * and how many faces had fewer than 3 corners.
 *
 * `monitor` is told of Stages::Reading.
 *
 * @throws Error FileMalformed where elements or numbers are missing (found before memory is taken
 * for them), are not of their type, or refer to a point that does not exist; TooLarge; Stopped
 */
void ReadPlyBody(
  const FileContent& file, PlyHeader& header, PolygonSurface& surface, Monitor& monitor);
} // namespace insideout
