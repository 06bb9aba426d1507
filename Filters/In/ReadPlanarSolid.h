// SPDX-License-Identifier: GPL-3.0-or-later
/** @file Reads triangles in a plane and the lines of their boundary. */
#pragma once

#include "Data/VtkClasses.h"
#include "In/Tags.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

#include <vtkType.h>

#include <vector>

namespace vtkInsideOut
{
/** Triangles in a plane. */
struct PlanarSolid
{
  insideout::Plane Plane; ///< seen from the side from which the triangles run counter-clockwise
  std::vector<insideout::Point> Points;
  std::vector<insideout::PlanarPoint> Places; ///< of the points in the plane

  /** Segments are labels: the boundary's tags, its number of tags within the solid and where there
   * is no line. */
  insideout::PlanarMesh Mesh;

  vtkInsideOut::Tags Tags;
  std::vector<vtkIdType> LineOfEdge; ///< per 3 * cell + edge; -1 for none
};

/**
 * Read the triangles, and find the edges that constrain them: those of one cell, those between
 * cells of different RegionId, and those with FacetIds of at least 0, where there are such arrays.
 *
 * @param[in] boundary lines with the solid on their left; null: all edges of one cell have one tag
 * @throws insideout::Error that names the point that is not finite, the cell that is no positive
 * triangle, the edge of three cells, the line that is no edge of one cell; InvalidParameter if they
 * lie in no plane
 */
PlanarSolid ReadPlanarSolid(vtkUnstructuredGrid* grid, vtkPolyData* boundary);
} // namespace vtkInsideOut
