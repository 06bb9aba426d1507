// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/SurfacePieces.h"

#include <map>

namespace insideout
{
/**
 * Closes the pieces of a surface, so that they can be held one after the other and their winding
 * numbers still add up to the surface's, without rounding errors.
 *
 * With K(P) the caps (HoleCaps.h) of a chain P, which have its boundary, P - K(P) is closed. So
 *
 *   w(surface) = sum of w(P - K(P)) over pieces P  +  w(R - K(R))  +  w(K(R)),
 *   R = sum of K(P) over pieces P.
 *
 * All terms but the last are whole numbers. The last one depends on the surface's boundary alone,
 * not on the numbering of its points: ExactWindingNumber has the same for the whole surface. Only R
 * is held throughout: no more triangles than the pieces have open edges.
 */
class ClosePieces
{
public:
  /**
   * Subtract its caps from a piece.
   *
   * @param[in,out] piece points, facets and counts; no facet is degenerate, no two points are
   * equal. Points of several pieces with equal coordinates are the same.
   */
  void Close(FacetComplex& piece);

  /** R - K(R) and K(R) of all pieces so far, each with its boundary; those without triangles are
   * left out. Their last point is used by none: it makes them as large as the surface. */
  std::vector<CountedPiece> Rest() const;

private:
  Id IdOf(const Point& point);

  double LargestCoordinate = 0; // of all pieces
  std::map<Point, Id> Ids;
  std::vector<Point> Points; // of open edges, in order of first appearance
  std::vector<CountedTriangle> Caps;
  std::vector<CountedEdge> OpenEdges; // of all pieces, from lower to higher points
};

/**
 * The sum of the winding numbers of closed pieces: where this is nearly a multiple of 1/2, as
 * anywhere but on edges of the surface, it is that multiple. Triangles of caps that cancel leave
 * rounding errors on their edges.
 */
double SumOfClosed(double sum);
} // namespace insideout
