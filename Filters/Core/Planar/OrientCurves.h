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
 * Which segments to turn over, and turn them: as OrientFacets does it with facets.
 *
 * Automatic first makes segments agree that meet at a point where no other does. Segments that then
 * form a closed curve, or one that a gap of less than half its length leaves open, are a shell; of
 * these it turns what the law of ChooseTurns says, by areas: those of the regions between segments.
 * All others are sheets, and stay. Outward turns shells that run clockwise.
 *
 * @param[in] given the curve before it was resolved
 * @param[in,out] curve resolved, which the mesh was made of: Multiplicity and Sources change
 * @throws Error Stopped
 */
CurveTurns OrientCurves(const SegmentComplex& given, Orientation orientation, const Plane& plane,
  const PlanarMesh& mesh, SegmentComplex& curve, Monitor& monitor);
} // namespace insideout
