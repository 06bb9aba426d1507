// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Corners in VTK's order: the first triangle is counter-clockwise seen from outside. */
using Prism = std::array<Id, 6>;

/** Corners in VTK's order: the base is counter-clockwise seen from the last one. */
using Pyramid = std::array<Id, 5>;

/** Cells of boundary layers that are no tetrahedra. */
struct LayerCells
{
  std::vector<Pyramid> Pyramids;
  std::vector<Prism> Prisms;

  bool HasLayers() const { return !this->Pyramids.empty() || !this->Prisms.empty(); }
};

/** The sign of a prism at its edge k, exactly: of the volumes at both ends of the edge the smaller.
 */
int OrientPrism(const std::array<Point, 3>& first, const std::array<Point, 3>& second, int k);

/** The sign of a cell, exactly: the smallest of the volumes of its corners with three edges. */
int Orient(const std::vector<Point>& points, const Prism& prism);
int Orient(const std::vector<Point>& points, const Pyramid& pyramid);

/** The corners of CalculiX's element C3D6: its first triangle is seen from within, and a pyramid is
 * one whose two triangles share a corner. */
Prism NodesOfC3D6(const Prism& prism);
Prism NodesOfC3D6(const Pyramid& pyramid);

/** A tetrahedron that a cell is cut into. */
struct CellPart
{
  Tetrahedron Corners;

  /** Which faces (TetrahedronFaces) are halves of a quad. */
  std::array<bool, 4> IsHalf;
};

/** Append the three or two parts of a cell: each quad is cut at its corner of the lowest id, so
 * that the parts of both of its cells meet (Dompierre et al. 1999). */
void AppendParts(const Prism& prism, std::vector<CellPart>& parts);
void AppendParts(const Pyramid& pyramid, std::vector<CellPart>& parts);
} // namespace insideout
