// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/TetrahedralMesh.h"
#include "Layers/LayerWall.h"
#include "Refine/RefinableSurface.h"

#include <vector>

namespace insideout
{
/**
 * Sine of the angle up to which facets count as coplanar: coordinates of seven digits, as files
 * have them, on facets a tenth as long as the model.
 */
constexpr double SineInPlane = 1e-6;

/** The planes of the other facets at a point of a wall, in which it has to stay. */
struct WallRim
{
  bool IsHeld = false;        ///< it may go nowhere
  std::vector<Point> Normals; ///< of length 1, at most two; none within the wall

  /** The component of a vector along all planes. */
  Point Along(const Point& vector) const;
};

/** An edge between a triangle of the wall and another facet, as it runs in the triangle. */
struct RimEdge
{
  Id From;
  Id To;
  Id Face; ///< of the input, 4 * cell + face: the other facet
};

/** Where a wall meets the rest of the boundary. */
struct WallRims
{
  std::vector<WallRim> AtPoints; ///< per point of the mesh
  std::vector<RimEdge> Edges;
  std::vector<Id> PointsInPlanes; ///< within planar parts of the boundary that have a rim
};

/**
 * Find the rims of a wall. Layers continue along planar parts of the boundary, of one label each.
 * Some points are held: where the boundary is not planar, up to single precision; where labels meet
 * in a plane; at faces between regions; and where cells are not connected through faces.
 *
 * @param[in] facets of the mesh (FacetsOf)
 * @param[in] wallFaces the faces of the wall, 4 * cell + face
 */
WallRims FindWallRims(const TetrahedralMesh& mesh, const std::vector<FacetOfInput>& facets,
  const RefinableSurface& surface, const std::vector<Id>& wallFaces, const LayerWall& wall);
} // namespace insideout
