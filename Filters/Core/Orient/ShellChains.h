// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/Shells.h"
#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * The largest share of the facets' area that caps may have. On the cap of half a sphere, whose
 * share is 1/2, w is 1/2: a shell that is more open than that and a little has no inside.
 */
constexpr double LargestCaps = 0.6;

enum class ShellKind
{
  Closed,
  Holed, ///< open, but what it encloses is plain once its holes are capped
  Sheet  ///< encloses nothing in particular
};

/** A shell with its holes closed. */
struct ShellChain
{
  ShellKind Kind;
  std::vector<CountedTriangle> Triangles; ///< facets that agree, and caps; without boundary
  std::vector<CountedTriangle> Caps;      ///< those that close the holes
  std::vector<CountedTriangle> Facets;    ///< that agree
  bool IsLoose = false;                   ///< without it the others fit (LoosePatches.h)
  double Area = 0;                        ///< of the facets
  double Volume = 0; ///< enclosed by the chain; negative where the shell faces inward
};

/**
 * Every shell as a chain without boundary, facets turned to agree with their shell. Holes are
 * closed by fans (HoleCaps.h). Where these have more than `LargestCaps` of the facets' area it is a
 * sheet.
 *
 * @param[in] points those of the surface, or the same scaled: area and volume are in their units
 */
std::vector<ShellChain> CloseShells(
  const FacetComplex& surface, const Shells& shells, const std::vector<Point>& points);
} // namespace insideout
