// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Reads planar curves from a vtkPolyData: its lines, or the edges of its polygons, as
 * segments for the stages.
 */
#pragma once

#include "Data/VtkClasses.h"
#include "Orient/OrientFacets.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

namespace vtkInsideOut
{
/** The segments of a curve, and their input cells. */
struct Curve
{
  vtkSmartPointer<vtkPolyData> Input;
  insideout::Plane Plane;                 ///< seen from the side that most polygons face
  insideout::SegmentSoup Soup;            ///< points have the input's ids
  std::vector<vtkIdType> CellOfSegment;   ///< the input cell that each segment is a part of
  std::vector<vtkIdType> TurnedCells;     ///< polygons that face the other way; ascending
  bool ArePolygons = false;               ///< otherwise they are lines
  std::vector<std::string> Warnings = {}; ///< warnings of skipped or reversed cells, one line each
};

/** Whether an input is lines without polygons. */
bool AreLines(vtkPolyData* input);

/** Whether an input is for vtkRobustTriangulate: lines without polygons, or coplanar polygons,
 * exactly or up to rounding in double precision. */
bool IsInAPlane(vtkPolyData* input);

///@{
/** Checks for filters of surfaces. @throws insideout::Error that names vtkRobustTriangulate if the
 * input is lines, or coplanar polygons that the filter does not accept
 */
void RefuseLines(vtkPolyData* input);
void RefusePlane(vtkPolyData* input, bool thickens = false);
///@}

/**
 * The segments of lines and polylines, with counts from the cell array FacetMultiplicity. If there
 * are polygons or strips, their edges instead, all counted: those of two adjacent polygons cancel,
 * and only shape the mesh. Polygons are turned to face one way, unless the orientation says
 * otherwise.
 *
 * @param[in] nonParticipating a cell array of one number per cell, not 0 for cells that do not
 * count in w; none if the name is empty
 * @throws insideout::Error that names the invalid cell, point or array, or the distance of points
 * from a plane
 */
Curve ReadCurve(
  vtkPolyData* input, insideout::Orientation orientation, const std::string& nonParticipating);
} // namespace vtkInsideOut
