// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Reads the polygons and strips of a vtkPolyData: as triangles for the stages, or unchanged
 * for a file.
 */
#pragma once

#include "Common/FacetComplex.h"
#include "Data/VtkClasses.h"
#include "Files/SurfaceFile.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** The triangles of a surface, and their input cells. */
struct Surface
{
  vtkSmartPointer<vtkPolyData> Input;
  insideout::TriangleSoup Soup;          ///< points have the input's ids
  std::vector<vtkIdType> CellOfTriangle; ///< the input cell that each triangle is a part of
  /// warnings of skipped or suspicious cells, one line each
  std::vector<std::string> Warnings = {};

  /** The input cell of a facet: the lowest, preferring those along `side` (+1 or -1). */
  vtkIdType CellOfFacet(
    const insideout::FacetComplex& surface, insideout::Id facet, int side) const;
};

/**
 * The triangles of polygons and strips. Polygons are the regions enclosed by their outlines
 * (TriangulatePolygon); triangles are in the order of the cells. A cell array FacetMultiplicity
 * (short, from vtkResolveSelfIntersections) is the count of each cell.
 *
 * @param nonParticipating a cell array of one number per cell, not 0 for cells that do not count in
 * w; none if the name is empty
 * @throws insideout::Error that names the invalid cell, point or array
 */
Surface ReadSurface(vtkPolyData* input, const std::string& nonParticipating = std::string());

/** Check polygons and strips as ReadSurface does. @param[in] label prefix of messages
 * @throws insideout::Error that names the invalid cell or point
 */
void CheckPolygons(vtkPolyData* input, const std::string& label);

/** A cell array of one number per cell; nullptr without one of this name. */
vtkDataArray* FindCellArray(vtkPolyData* input, const char* name);

/**
 * For each facet 1 if it is a piece of an input cell with a nonzero value in a cell array, else 0;
 * empty if the array's name is.
 *
 * @throws insideout::Error if the input has no such array
 */
std::vector<unsigned char> ReadChosenFacets(
  const Surface& surface, const std::string& name, const insideout::FacetComplex& facets);

/**
 * The polygons and strips for a file: strips become triangles, lines and vertices are dropped. For
 * attributes and their names see ReadAttributes and ReadNames.
 *
 * @throws insideout::Error that names the cell whose point is out of range
 */
insideout::PolygonSurface ReadPolygons(vtkPolyData* input);
} // namespace vtkInsideOut
