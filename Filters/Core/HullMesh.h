// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/ResolveBodies.h"
#include "Common/Statistics.h"
#include "Common/TetrahedralMesh.h"
#include "Tetrahedralize/ConstrainedDelaunay.h"

namespace insideout
{
struct HullMeshParameters
{
  CountedChainParameters Chain;
  insideout::Orientation Orientation = insideout::Orientation::Automatic;
  ThickenParameters Thicken;
  ConstrainedDelaunayParameters Budgets;
  int QuadratureOrder = 1; ///< see WindingNumberOfCells
  bool PartsApart = false; ///< one hull per part (TetrahedralizeApart.h); not with several bodies
  double TouchTolerance = BodyParameters().TouchTolerance; ///< for several bodies
};

/** The tetrahedralized convex hull of bodies, or hulls of a body's parts, with the winding numbers
 * in each cell. */
struct HullMesh : ResolvedBodies
{
  TetrahedralMesh Mesh;  ///< before there are cells, origins of the surface's points
  std::vector<double> W; ///< one per cell: the sum over the bodies
  std::vector<std::vector<double>> WOfBodies; ///< winding numbers of each body; a single body has W
  SurfaceCounts Counts;                       ///< sums over the bodies
  insideout::Statistics Statistics;

  const std::vector<double>& WOfBody(Id body) const
  {
    return this->WOfBodies.empty() ? this->W : this->WOfBodies[body];
  }
};

/**
 * Stages validate and pre: count the facets of each body, orient them, thicken sheets, and resolve
 * the intersections of all (ResolveBodies). There are no cells yet.
 *
 * @throws Error of any stage
 */
HullMesh ResolveHull(
  std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor);

/**
 * Stages CDT and w on the resolved surface: tetrahedralize the convex hull, and find the winding
 * numbers.
 *
 * @throws Error of any stage
 */
void MeshResolvedHull(const HullMeshParameters& parameters, HullMesh& hull, Monitor& monitor);

/** Both: stages validate to w in a row. */
HullMesh MeshHull(std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor);

/** The same for a single surface. */
inline HullMesh MeshHull(TriangleSoup soup, const HullMeshParameters& parameters, Monitor& monitor)
{
  return MeshHull(OneBody(std::move(soup)), parameters, monitor);
}
} // namespace insideout
