// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads a vtkUnstructuredGrid: tetrahedra, or for the graph cut cells of any type by their parts.
 */
#pragma once

#include "Common/TetrahedralMesh.h"
#include "GraphCut/CellParts.h"

#include <vtkType.h>

class vtkUnstructuredGrid;

/** The first cell that is no tetrahedron, -1 if all are. */
vtkIdType vtkInsideOutFindOtherCell(vtkUnstructuredGrid* grid);

/** @throws insideout::Error when there is no cell array w of one value per cell */
std::vector<double> vtkInsideOutReadWindingNumbers(vtkUnstructuredGrid* grid);

/** Whether a cell array FacetIds tells which faces are on facets. */
bool vtkInsideOutHasFacetIds(vtkUnstructuredGrid* grid);

/**
 * Tetrahedra with their neighbours. A face is on a facet where FacetIds is not negative; without
 * the array, none is.
 *
 * @throws insideout::Error TooLarge, and when the grid does not conform
 */
insideout::TetrahedralMesh vtkInsideOutReadTetrahedra(vtkUnstructuredGrid* grid);

/**
 * The faces of volumes, or the edges of polygons.
 *
 * @throws insideout::Error that names a cell that is curved or of another dimension
 */
insideout::CellParts vtkInsideOutReadSides(vtkUnstructuredGrid* grid);

/** The sizes of cells, by the tetrahedra or triangles that VTK cuts them into. */
std::vector<double> vtkInsideOutReadSizes(vtkUnstructuredGrid* grid);
