// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ExactPoint.h"

#include <vector>

namespace insideout
{
struct ExactSegment
{
  ExactPoint First;
  ExactPoint Last; ///< equal to First for a single point
};

/** A triangle that a piece is part of, and whether the piece runs the other way. */
struct PieceSource
{
  Id Facet;
  bool Reversed;
};

/** A triangle of a subdivision. Its corners run as those of its first source do. */
struct Piece
{
  Triangle Corners;
  std::vector<PieceSource> Sources; ///< by ascending Facet
};

struct PlanarSubdivision
{
  std::vector<Point> Points; ///< the exact corners, rounded to the nearest doubles
  std::vector<Piece> Pieces; ///< corners index Points
};

/**
 * The triangles of one plane cut along each other's edges and along segments: a constrained
 * Delaunay triangulation, in which every edge and segment is a union of edges and which is exact
 * until its points are rounded at the end. Sources index `triangles`.
 *
 * @param[in] triangles non-degenerate, exactly in one plane; they may overlap
 * @param[in] segments each in one of the triangles, boundary included
 */
PlanarSubdivision SubdividePlane(
  const std::vector<std::array<Point, 3>>& triangles, const std::vector<ExactSegment>& segments);
} // namespace insideout
