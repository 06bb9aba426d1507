// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/PlyHeader.h"

namespace insideout
{
/**
 * Read the body of a PLY file (Turk, The PLY Polygon File Format, 1994). Faces, or strips of
 * triangles if there are no faces, become the polygons of `surface`, which must have none. Each
 * number of the vertices and of the faces that became polygons is appended to its property's
 * Values, so that these are parallel to the vertices and to the polygons; other values, and all
 * lists but those, are read and dropped.
 *
 * In an ascii file with as many lines as elements, each element has its own line: the rest of the
 * line after its numbers is skipped. Warnings report this, content after the last element, and the
 * number of faces with fewer than 3 corners.
 *
 * `monitor` gets Stages::Reading.
 *
 * @throws Error FileMalformed if elements or numbers are missing (found before memory is taken for
 * them), are not of their type, or refer to a point that does not exist; TooLarge; Stopped
 */
void ReadPlyBody(
  const FileContent& file, PlyHeader& header, PolygonSurface& surface, Monitor& monitor);
} // namespace insideout
