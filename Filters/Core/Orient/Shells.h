// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/** A further copy of a facet that counts several times, or cancels: shells that share it have one
 * each. */
struct ShellCopy
{
  Id Facet;
  Id Shell;
  int Multiplicity; ///< along the facet's own orientation, before it is turned
  char Turned;
};

/** Facets that face one way or the other together, and which of them were given against the rest.
 */
struct Shells
{
  std::vector<Id> Shell; ///< one per facet, of its first copy; None for those that count 0
  std::vector<std::int16_t> Multiplicity; ///< one per facet: of its first copy
  std::vector<char> Turned;          ///< one per facet: 1 where it has to be turned over to agree
  std::vector<ShellCopy> MoreCopies; ///< by facet
  std::vector<char> IsLoose;         ///< one per shell: without it the others fit (LoosePatches.h)
  Id Patches = 0;                    ///< of the surface (SurfacePatches.h)
  Id Count = 0;                      ///< of shells, numbered by their lowest facet
};

/**
 * Shells: patches put together again at the seams where they can agree which way to run.
 *
 * Where two patches meet at a seam, and no other does that is not balanced there by itself, they
 * are to run opposite ways along it: as they do already, or once one of them is turned over. What
 * patches ask of one another may be at odds, as on a surface with one side only: then edges of two
 * facets go before others, and what a greater length of edges asks for before less.
 *
 * Where more patches balance, each is joined with another that runs against it (JoinCopies.h). A
 * facet that counts n times, or cancels, has copies there: so n closed surfaces that share facets
 * are n shells.
 *
 * Loose patches are joined with each other alone.
 *
 * In each shell the fewer facets are Turned, of as many those that the lowest facet is not of.
 *
 * @param[in] edges those of surface.Facets
 */
Shells FindShells(const FacetComplex& surface, const std::vector<FacetEdge>& edges);
} // namespace insideout
