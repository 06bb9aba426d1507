// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/** Facets that face one way or the other together, and which of them were given against the rest.
 */
struct Shells
{
  std::vector<Id> Shell;    ///< one per facet; None for those that count 0
  std::vector<char> Turned; ///< one per facet: 1 where it has to be turned over to agree
  Id Patches = 0;           ///< of the surface (SurfacePatches.h)
  Id Count = 0;             ///< of shells, numbered by their lowest facet
};

/**
 * Shells: patches put together again at the edges where they can agree which way to run.
 *
 * Where two patches meet in an edge, and no other does that is not balanced there by itself, they
 * are to run opposite ways along it: as they do already, or once one of them is turned over. The
 * patches of an edge that is balanced by more than two are joined as they are. What patches ask of
 * one another may be at odds, as on a surface with one side only: then edges of two facets go
 * before others, and what a greater length of edges asks for before less.
 *
 * In each shell the fewer facets are Turned, of as many those that the lowest facet is not of.
 *
 * @param[in] edges those of surface.Facets
 */
Shells FindShells(const FacetComplex& surface, const std::vector<FacetEdge>& edges);
} // namespace insideout
