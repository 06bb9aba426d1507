// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GraphCut/SegmentMesh.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

namespace insideout
{
/** The edges between two triangles, each once, with their lengths, for the cut's smoothness term.
 */
std::vector<InteriorFace> InteriorEdges(
  const std::vector<PlanarPoint>& points, const PlanarMesh& mesh, const PlanarMetric& metric);

/**
 * The edges of triangles that lie on segments, in the order of their cells.
 *
 * @param[in] chosen one value per segment, 0 for those that need not be kept; empty for all
 */
std::vector<FacetPiece> PiecesOfSegments(
  const PlanarMesh& mesh, const std::vector<unsigned char>& chosen = {});

/**
 * Stage cut on triangles; for statistics see SegmentMesh, its counterpart for tetrahedra.
 *
 * @param[in] curve from which the mesh was made
 * @param[in] w one finite value per cell
 * @param[in] seeds in space: they are projected onto the plane
 * @throws Error InvalidParameter, PointNotFinite, TooLarge, Stopped
 */
MeshSegmentation SegmentTriangles(const SegmentComplex& curve, const PlanarMesh& mesh,
  const Plane& plane, const std::vector<double>& w, const std::vector<FacetPiece>& pieces,
  const std::vector<Seed>& seeds, const SegmentMeshParameters& parameters, Monitor& monitor);
} // namespace insideout
