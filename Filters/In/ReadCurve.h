// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file
 * Reads what lies in a plane of a vtkPolyData: its lines, or the edges of its polygons, as segments
 * for the stages.
 */
#pragma once

#include "Orient/OrientFacets.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace vtkInsideOut
{
/** The segments of a curve, and where they came from. */
struct Curve
{
  vtkSmartPointer<vtkPolyData> Input;
  insideout::Plane Plane;                 ///< for polygons seen from where most face
  insideout::SegmentSoup Soup;            ///< points have the input's ids
  std::vector<vtkIdType> CellOfSegment;   ///< the input cell that each segment is a part of
  std::vector<vtkIdType> TurnedCells;     ///< polygons that face the other way; ascending
  bool ArePolygons = false;               ///< or else lines
  std::vector<std::string> Warnings = {}; ///< what was passed over or turned, one line each
};

/** Whether an input is lines without polygons. */
bool AreLines(vtkPolyData* input);

/** Whether an input is for vtkRobustTriangulate: lines without polygons, or polygons in one plane
 * exactly or but for rounding in double precision. */
bool IsInAPlane(vtkPolyData* input);

///@{
/** For what takes surfaces. @throws insideout::Error that names vtkRobustTriangulate where the
 * input is lines; and, where it takes no polygons in a plane, that they are. */
void RefuseLines(vtkPolyData* input);
void RefusePlane(vtkPolyData* input, bool thickens = false);
///@}

/**
 * The segments of the lines, polylines too, by the cell array FacetMultiplicity as often as it
 * says; or, where there are polygons or strips, of their edges, which all count: those of two
 * polygons side by side cancel, and shape the mesh only. Polygons are turned so that all face one
 * way, unless the orientation says otherwise.
 *
 * @param[in] nonParticipating a cell array of one number per cell, which is not 0 for cells that do
 * not count in w; none where the name is empty
 * @throws insideout::Error that names the cell, point or array at fault, or how far points are from
 * a plane
 */
Curve ReadCurve(
  vtkPolyData* input, insideout::Orientation orientation, const std::string& nonParticipating);
} // namespace vtkInsideOut
