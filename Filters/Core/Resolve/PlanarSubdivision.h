// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/ConstructedPoint.h"

#include <vector>

namespace insideout
{
/** A segment along which a facet is cut. */
struct Cut
{
  ConstructedPoint First;
  ConstructedPoint Last; ///< equal to First for a single point
  Id Facet = None;       ///< facet whose plane contains the segment; None if it joins two corners
};

/** A facet that contains a piece, and whether the piece has the opposite orientation. */
struct PieceSource
{
  Id Facet;
  bool Reversed;
};

/** A triangle of a subdivision. Its corners have the orientation of its first source. */
struct Piece
{
  Triangle Corners;
  std::vector<PieceSource> Sources; ///< by ascending Facet
};

/** A facet that is subdivided. */
struct SubdividedFacet
{
  Id Facet;
  Triangle Corners; ///< points of the surface
  Triangle Places;  ///< the same corners as points of the subdivision
};

struct PlanarSubdivision
{
  std::vector<ConstructedPoint> Points;
  std::vector<SubdividedFacet> Facets; ///< by ascending Facet
  std::vector<Piece> Pieces;           ///< corners index Points
};

/**
 * Facets of one plane cut along each other's edges and along segments: a constrained triangulation
 * in which every edge and segment is a union of edges. Exact; Delaunay up to rounding in doubles.
 *
 * @param[in] facets ascending, exactly in one plane; they may overlap. Without cuts it suffices
 * that no facet is edge-on along the first one's axis, because only the projections count
 * @param[in] cuts each in one of the facets, boundary included
 */
PlanarSubdivision SubdividePlane(
  const FacetList& surface, const std::vector<Id>& facets, const std::vector<Cut>& cuts);

/**
 * The same for facets that are meant to coincide, as seen along an axis to which all are visible.
 * The point where two edges cross lies on the edge of the lower facet.
 */
PlanarSubdivision SubdivideAlong(int axis, const FacetList& surface, const std::vector<Id>& facets);
} // namespace insideout
