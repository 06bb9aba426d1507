// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Validate/FacetEdges.h"

namespace insideout
{
/** A further copy of a facet that counts several times, or cancels: each shell that shares the
 * facet has a copy. */
struct ShellCopy
{
  Id Facet;
  Id Shell;
  int Multiplicity; ///< along the facet's own orientation, before it is turned
  char Turned;
};

/** Sets of facets that are oriented together, and the facets given with the opposite orientation.
 */
struct Shells
{
  std::vector<Id> Shell; ///< one per facet, of its first copy; None for those that count 0
  std::vector<std::int16_t> Multiplicity; ///< one per facet: orientation of its first copy
  std::vector<char> Turned;               ///< one per facet: 1 if it has to be turned over to agree
  std::vector<ShellCopy> MoreCopies;      ///< by facet
  /// one per shell: the others balance without it (LoosePatches.h)
  std::vector<char> IsLoose;
  Id Patches = 0; ///< of the surface (SurfacePatches.h)
  Id Count = 0;   ///< of shells, numbered by their lowest facet
};

/**
 * Shells: patches joined at the seams where their orientations can agree.
 *
 * If two patches meet at a seam, and any others balance there by themselves, the two are to run
 * along it in opposite directions, perhaps after turning one. These demands may contradict each
 * other, as on a one-sided surface. Then edges of two facets take precedence, and greater lengths
 * of edges over smaller ones.
 *
 * If more patches balance, each is joined with another that runs against it (JoinCopies.h). A facet
 * that counts n times, or cancels, has copies there: so n closed surfaces that share facets become
 * n shells.
 *
 * Loose patches are joined only with each other.
 *
 * In each shell the minority of facets is Turned; on a tie, the half without the lowest facet.
 *
 * @param[in] edges those of surface.Facets
 */
Shells FindShells(const FacetComplex& surface, const FacetEdges& edges);
} // namespace insideout
