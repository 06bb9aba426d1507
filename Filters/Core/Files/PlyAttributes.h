// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/PlyHeader.h"

namespace insideout
{
/**
 * The points with the vertices' numbers x, y and z as coordinates. These properties, which are
 * required, are removed.
 */
std::vector<Point> TakePlyPoints(PlyElement& vertices);

/**
 * The numbers of vertices or faces as attributes, parallel to their Values. Names that programs
 * agree on (the format prescribes none: Turk, The PLY Polygon File Format, 1994) become `Normals`,
 * `TCoords` and `Colors` as ReadSurface says; every other number keeps its name, with underscores
 * appended if an attribute has it already. All properties are removed, each after its use.
 */
std::vector<Attribute> TakePlyAttributes(PlyElement& element);
} // namespace insideout
