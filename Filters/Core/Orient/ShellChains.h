// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Orient/Shells.h"
#include "WindingNumber/CountedBoundary.h"

namespace insideout
{
/**
 * The largest area of caps relative to the facets'. On the cap of half a sphere, with a ratio of
 * 1/2, w is 1/2; a shell that is noticeably more open has no inside.
 */
constexpr double LargestCaps = 0.6;

enum class ShellKind
{
  Closed,
  Holed, ///< open, but with a well-defined volume once its holes are capped
  Sheet  ///< encloses no volume
};

/** A shell with its holes closed. */
struct ShellChain
{
  ShellKind Kind;
  std::vector<CountedTriangle> Triangles; ///< facets that agree, and caps; no boundary
  std::vector<CountedTriangle> Caps;      ///< caps that close the holes
  std::vector<CountedTriangle> Facets;    ///< facets, made to agree
  bool IsLoose = false;                   ///< the others balance without it (LoosePatches.h)
  double Area = 0;                        ///< of the facets
  double Volume = 0; ///< enclosed by the chain; negative if the shell faces inward
};

/**
 * Every shell as a chain without boundary, facets turned to agree with their shell. Holes are
 * closed by fans (HoleCaps.h). If the fans' area exceeds `LargestCaps` times the facets' area, the
 * shell is a sheet.
 *
 * @param[in] edges those of surface.Facets
 * @param[in] points those of the surface, or the same scaled: area and volume are in their units
 */
std::vector<ShellChain> CloseShells(const FacetComplex& surface, const FacetEdges& edges,
  const Shells& shells, const std::vector<Point>& points);
} // namespace insideout
