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
  bool PartsApart = false; ///< a hull for each part (TetrahedralizeApart.h); not of several bodies
  double TouchTolerance = BodyParameters().TouchTolerance; ///< of several bodies
};

/** The convex hull of bodies in tetrahedra, or those of a body's parts, and the winding numbers in
 * each. */
struct HullMesh : ResolvedBodies
{
  TetrahedralMesh Mesh;  ///< as long as there are no cells, of the surface's points
  std::vector<double> W; ///< one per cell: the sum over the bodies
  std::vector<std::vector<double>> WOfBodies; ///< of each body; a single one has W
  SurfaceCounts Counts;                       ///< sums over the bodies
  insideout::Statistics Statistics;

  const std::vector<double>& WOfBody(Id body) const
  {
    return this->WOfBodies.empty() ? this->W : this->WOfBodies[body];
  }
};

/**
 * Stages validate and pre: count the facets of each body, turn them the way that is meant, thicken
 * sheets, and resolve the intersections of all (ResolveBodies). There are no cells yet.
 *
 * @throws Error whatever the stages throw
 */
HullMesh ResolveHull(
  std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor);

/**
 * Stages CDT and w, of what is resolved: tetrahedralize the convex hull, and find the winding
 * numbers.
 *
 * @throws Error whatever the stages throw
 */
void MeshResolvedHull(const HullMeshParameters& parameters, HullMesh& hull, Monitor& monitor);

/** Both: stages validate to w in a row. */
HullMesh MeshHull(std::vector<Body> bodies, const HullMeshParameters& parameters, Monitor& monitor);

/** The same of a surface given alone. */
inline HullMesh MeshHull(TriangleSoup soup, const HullMeshParameters& parameters, Monitor& monitor)
{
  return MeshHull(OneBody(std::move(soup)), parameters, monitor);
}
} // namespace insideout
