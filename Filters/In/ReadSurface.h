// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads the polygons and strips of a vtkPolyData: as triangles for the stages, or as they are for a
 * file.
 */
#pragma once

#include "Common/FacetComplex.h"
#include "Files/SurfaceFile.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace vtkInsideOut
{
/** The triangles of a surface, and where they came from. */
struct Surface
{
  vtkSmartPointer<vtkPolyData> Input;
  insideout::TriangleSoup Soup;           ///< points have the input's ids
  std::vector<vtkIdType> CellOfTriangle;  ///< the input cell that each triangle is a part of
  std::vector<std::string> Warnings = {}; ///< what was passed over or looks wrong, one line each

  /** The input cell of a facet: of several the lowest, of those along `side` (+1 or -1) if there is
   * one. */
  vtkIdType CellOfFacet(
    const insideout::FacetComplex& surface, insideout::Id facet, int side) const;
};

/**
 * The triangles of polygons and strips. Polygons mean what their outlines enclose
 * (TriangulatePolygon), in triangles that stand in the order of the cells. A cell array
 * FacetMultiplicity (short, as vtkResolveSelfIntersections makes it) says how often a cell counts.
 *
 * @param nonParticipating a cell array of one number per cell, which is not 0 for cells that do not
 * count in w; none where the name is empty
 * @throws insideout::Error that names the cell, point or array at fault
 */
Surface ReadSurface(vtkPolyData* input, const std::string& nonParticipating = std::string());

/** Check polygons and strips as ReadSurface does. @param[in] label what messages begin with
 * @throws insideout::Error that names the cell or point at fault */
void CheckPolygons(vtkPolyData* input, const std::string& label);

/** A cell array of one number per cell; nullptr where there is none of this name. */
vtkDataArray* FindCellArray(vtkPolyData* input, const char* name);

/**
 * For each facet 1 where it is a piece of an input cell whose value in a cell array is not 0, else
 * 0; empty where the array's name is.
 *
 * @throws insideout::Error when the input has no such array
 */
std::vector<unsigned char> ReadChosenFacets(
  const Surface& surface, const std::string& name, const insideout::FacetComplex& facets);

/**
 * The polygons and strips for a file: strips become triangles, lines and vertices stay behind. For
 * attributes and their names see ReadAttributes and ReadNames.
 *
 * @throws insideout::Error that names the cell whose point is out of range
 */
insideout::PolygonSurface ReadPolygons(vtkPolyData* input);
} // namespace vtkInsideOut
