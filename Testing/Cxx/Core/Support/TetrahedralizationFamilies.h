// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Support/SurfaceFamilies.h"

/** Surfaces that are hard to tetrahedralize. */
namespace testmeshes
{
/**
 * A prism whose top is turned against its bottom: for turn < 0 with the sides bent inward
 * (Schoenhardt 1928), for turn > 0 convex.
 */
TriangleSoup TwistedPrism(int sides, double turn);

/**
 * Chazelle's polyhedron: a box into which notches are cut from below and from above, down to a
 * hyperbolic paraboloid from its two sides. Only the notches' ridges and their sides are here.
 */
TriangleSoup Chazelle(int notches);

/** Sheets one above the other, one unit in the last place apart, each triangulated another way. */
TriangleSoup NearSheets(unsigned seed, int sheets, int size);

/** A sphere's points in rings on which many lie on one circle, joined to facets at random. */
TriangleSoup RingedSphere(unsigned seed, int rings);

/** Triangles a million times as long as wide, in all directions through a cube. */
TriangleSoup Needles(unsigned seed, int count);

/** Boxes with corners on a small grid: nested, touching and interpenetrating. */
TriangleSoup GridBoxes(unsigned seed, int count);

/** One member of each family, of 50 to 2,000 facets once resolved (most of fewer than 500). */
std::vector<SurfaceFamily> TetrahedralizationFamilies(unsigned seed);
} // namespace testmeshes
