// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Files/PlyHeader.h"

namespace insideout
{
/**
 * The coordinates that the numbers x, y and z of the vertices are, one point each. These
 * properties, which have to be there, are removed.
 */
std::vector<Point> TakePlyPoints(PlyElement& vertices);

/**
 * The numbers of vertices or faces as attributes, parallel to their Values. Names that programs
 * agree on (the format prescribes none: Turk, The PLY Polygon File Format, 1994) become `Normals`,
 * `TCoords` and `Colors` as ReadSurface says; every other number keeps its name, with underscores
 * behind it where an attribute has it. All properties are removed, each as soon as it was used.
 */
std::vector<Attribute> TakePlyAttributes(PlyElement& element);
} // namespace insideout
