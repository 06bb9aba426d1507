// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Reads a vtkUnstructuredGrid: tetrahedra unchanged; for the graph cut with their neighbors,
 * or cells of any type by their parts.
 */
#pragma once

#include "Common/LayerCells.h"
#include "Common/TetrahedralMesh.h"
#include "Data/VtkClasses.h"
#include "GraphCut/CellParts.h"

#include <vtkType.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** The first cell that is not a tetrahedron, -1 if all are. */
vtkIdType FindOtherCell(vtkUnstructuredGrid* grid);

/** VTK's name of a cell type, for example vtkHexahedron. */
std::string CellName(int type);

/** The tetrahedra of a grid, and pyramids and prisms of layers. */
struct GridTetrahedra : insideout::LayerCells
{
  std::vector<insideout::Point> Points; ///< all of the grid
  std::vector<insideout::Tetrahedron> Cells;

  /** The mid-edge nodes of each cell, None for a cell of first order. */
  std::vector<std::array<insideout::Id, 6>> Midpoints;

  std::vector<vtkIdType> CellIds; ///< of the grid: of tetrahedra, then of pyramids, of prisms
};

/**
 * The points of tetrahedra of first and second order (vtkTetra, vtkQuadraticTetra), in their order.
 * Cells of lower dimension, such as the triangles of a boundary, are skipped.
 *
 * @throws insideout::Error that names another cell of three dimensions, one without four different
 *         points, or a point that is not finite; TooLarge
 */
GridTetrahedra ReadTetrahedraOfAnyOrder(vtkUnstructuredGrid* grid);

/** The same with linear pyramids and prisms (vtkPyramid, vtkWedge). */
GridTetrahedra ReadTetrahedraAndLayers(vtkUnstructuredGrid* grid);

/** @throws insideout::Error without a cell array w of one value per cell */
std::vector<double> ReadWindingNumbers(vtkUnstructuredGrid* grid);

/** Whether a cell array FacetIds marks the faces on facets. */
bool HasFacetIds(vtkUnstructuredGrid* grid);

/**
 * Tetrahedra with their neighbors. A face is on a facet if FacetIds is not negative; without the
 * array, none is.
 *
 * @throws insideout::Error TooLarge, or if the grid is not conforming
 */
insideout::TetrahedralMesh ReadTetrahedra(vtkUnstructuredGrid* grid);

/**
 * The faces of volumes, or the edges of polygons.
 *
 * @throws insideout::Error that names a cell that is curved or of another dimension
 */
insideout::CellParts ReadSides(vtkUnstructuredGrid* grid);

/** The sizes of cells, by the tetrahedra or triangles that VTK cuts them into. */
std::vector<double> ReadSizes(vtkUnstructuredGrid* grid);

/** Whether an array has integers for each cell. */
bool HasIntegers(vtkDataArray* array, vtkUnstructuredGrid* grid);

/** Numbers from 0 in the order of values, which are not NaN. */
std::vector<insideout::Id> NumberedAnew(const std::vector<double>& values);
} // namespace vtkInsideOut
