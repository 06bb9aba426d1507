// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <ostream>
#include <string>
#include <vector>

/** Surfaces that are hard to resolve, in families: each names what makes it hard. */
namespace testmeshes
{
using namespace insideout;

struct SurfaceFamily
{
  std::string Name;
  std::vector<TriangleSoup> Members;
};

/** For GoogleTest's messages. */
inline void PrintTo(const SurfaceFamily& family, std::ostream* out)
{
  *out << family.Name;
}

/**
 * All families but the random soups of 100 facets (GridSoups). Points may be there several times
 * and triangles too; validation comes first.
 *
 * @param[in] members of each random family; the others have a fixed number
 */
std::vector<SurfaceFamily> SurfaceFamilies(int members);

/**
 * Triangles that have two corners each at few places in the plane x = 0, or up to 63 steps of 2^-56
 * beside it: resolving takes all facets away from some of these.
 */
TriangleSoup CornersNearlyOne(unsigned seed);

/** `members` soups of up to 100 facets on integer grids of side 2 to 8, in turn. */
SurfaceFamily GridSoups(int members);
} // namespace testmeshes
