// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Planar/PlanarHull.h"

#include <string>

/** Curves to test with, and what each stage of the room Planar promises, from the definitions and
 * in rational numbers: slow, and shares no code with the stages. */
namespace testplanar
{
using namespace insideout;

/** Points of the plane z = 0 and a closed or open polyline through each run of ids. */
SegmentSoup Lines(
  const std::vector<PlanarPoint>& points, const std::vector<std::vector<Id>>& lines);

/** Segments between random places of the unit square. */
SegmentSoup RandomSegments(unsigned seed, int count);

/** A closed walk over random points of a grid, so that everything degenerate happens. */
SegmentSoup RandomWalk(unsigned seed, int size, int steps, bool closed);

PlanarHull MeshHullOf(const SegmentSoup& soup, Orientation orientation = Orientation::AsGiven);

/** The sum of the angles under which the soup's segments, duplicates counted once per direction,
 * are seen from a place of the plane z = 0, over 2 pi; in quadruple precision. */
double WindingNumberInQuads(const SegmentSoup& soup, const std::array<__float128, 2>& place);

/** The broken laws of stage pre, empty for none. Input points keep their bits, and constraints meet
 * in shared points only. Pieces of an input segment lead from one end to the other, near it, and
 * have their segments' counts. */
std::string BrokenByResolving(const SegmentSoup& soup, const PlanarHull& hull);

/** The broken laws of stage CDT: triangles positive, edge to edge, covering the convex hull, with
 * every constraint and locally Delaunay elsewhere. */
std::string BrokenByTriangles(const PlanarHull& hull);

/** The broken laws of stage w: the jump at each edge if the curve is closed, and the sum of angles
 * at each barycenter. */
std::string BrokenByWindingNumbers(const SegmentSoup& soup, const PlanarHull& hull);

/** All of these. */
std::string BrokenLaws(const SegmentSoup& soup, const PlanarHull& hull);
} // namespace testplanar
