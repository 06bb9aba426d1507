// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Orient/OrientFacets.h"
#include "Orient/ThickenFacets.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"
#include "Validate/CountedChain.h"

namespace insideout
{
struct HullMeshParameters
{
  CountedChainParameters Chain;
  insideout::Orientation Orientation = insideout::Orientation::Automatic;
  ThickenParameters Thicken;
  ConstrainedDelaunayParameters Budgets;
  int QuadratureOrder = 1; ///< see WindingNumberOfCells
  bool PartsApart = false; ///< a hull for each part (TetrahedralizeApart.h); not of several bodies
};

/** The convex hull of a surface in tetrahedra, or those of its parts, and the surface's winding
 * number in each. */
struct HullMesh
{
  FacetComplex Surface;  ///< resolved; facets turned over as the orientation asked for
  TetrahedralMesh Mesh;  ///< as long as there are no cells, of the surface's points
  std::vector<double> W; ///< one per cell
  SurfaceCounts Counts;
  std::vector<Id> MergedInto;          ///< as CountedChain's
  std::vector<Id> DegenerateTriangles; ///< as CountedChain's
  std::vector<Id> TurnedTriangles;     ///< of the soup: turned over; ascending
  std::vector<Id> SheetTriangles;      ///< of the soup: of facets that enclose nothing; ascending
  insideout::Statistics Statistics;
  std::vector<std::string> Warnings;
};

/**
 * Stages validate and pre: count the facets, turn them the way that is meant, thicken sheets, and
 * resolve their intersections. There are no cells yet.
 *
 * @throws Error whatever the stages throw
 */
HullMesh ResolveHull(
  const TriangleSoup& soup, const HullMeshParameters& parameters, Monitor& monitor);

/**
 * Stages CDT and w, of what is resolved: tetrahedralize the convex hull, and find the winding
 * numbers.
 *
 * @throws Error whatever the stages throw
 */
void MeshResolvedHull(const HullMeshParameters& parameters, HullMesh& hull, Monitor& monitor);

/** Both: stages validate to w in a row. */
HullMesh MeshHull(const TriangleSoup& soup, const HullMeshParameters& parameters, Monitor& monitor);

/** Take what resolving made of the surface, with the figures about it. */
void TakeResolved(FacetComplex surface, std::size_t intersectingPairs, HullMesh& hull);

/** Tetrahedralize the hull of its resolved surface. */
void FillHull(const ConstrainedDelaunayParameters& budgets, HullMesh& hull, Monitor& monitor);

/** The figures about w. @param[in] isClosed whether w is an integer everywhere */
void AddRangeOfW(bool isClosed, HullMesh& hull);
} // namespace insideout
