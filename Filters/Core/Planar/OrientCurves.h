// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Monitor.h"
#include "Orient/OrientFacets.h"
#include "Planar/FindPlane.h"
#include "Planar/PlanarCurve.h"

#include <string>

namespace insideout
{
/** The segments that were turned over. */
struct CurveTurns
{
  std::vector<Id> Segments; ///< of the soup; ascending
  std::vector<std::string> Warnings;
};

/**
 * Decide which segments to turn over, and turn them, as OrientFacets does with facets.
 *
 * Automatic first makes segments agree that meet at a point of exactly two. Segments that then form
 * a closed curve, or a curve with a gap of less than half its length, are a shell. Shells are
 * turned by the law of ChooseTurns, by the areas of the regions between segments. All other
 * segments are sheets, and stay. Outward turns clockwise shells.
 *
 * @param[in] given the curve before it was resolved
 * @param[in,out] curve resolved, from which the mesh was made: Multiplicity and Sources change
 * @throws Error Stopped
 */
CurveTurns OrientCurves(const SegmentComplex& given, Orientation orientation, const Plane& plane,
  const PlanarMesh& mesh, SegmentComplex& curve, Monitor& monitor);
} // namespace insideout
