// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Orient/ShellCounts.h"

#include <string>

namespace insideout
{
/** Which way the facets are meant to face. */
enum class Orientation
{
  Automatic, ///< facets that disagree, and shells that are inside out, are turned over
  AsGiven,   ///< nothing is turned
  Reverse,   ///< everything is
  Outward    ///< every shell that encloses something faces outward, whatever lies within what
};

/** Facets that meet beyond the corners and edges that they share. */
enum class Crossings
{
  Unknown,
  Absent ///< no two facets do
};

/** The facets that were turned over, and the make-up of the surface. A shell is what Shells.h says.
 */
struct FacetTurns
{
  std::vector<std::int16_t> Multiplicity; ///< one per facet: how often it counts in the end
  std::vector<char> Turned;               ///< one per facet; of several copies the first one tells
  std::vector<char> IsSheet;    ///< one per facet: of a shell that encloses nothing, or counts 0
  std::vector<char> IsMembrane; ///< one per facet: of a membrane (Membranes.h)
  std::vector<Id> Shell; ///< one per facet, None for those that count 0; of several the first

  /** What each shell encloses in the end, holes capped: negative for a cavity, 0 for a sheet. */
  std::vector<double> ShellVolumes;
  std::vector<char> ShellHasHoles; ///< one per shell; 0 for a sheet

  Id Shells = 0;
  Id Membranes = 0; ///< shells that do not count
  Id MembraneFacets = 0;
  Id UncountedSheets = 0; ///< sheets outside the solid that do not count
  Id TurnedFacets = 0;
  Id TurnedShells = 0;      ///< as a whole
  Id DisagreeingFacets = 0; ///< that were given against their shells
  Id UndecidedShells = 0;   ///< that might as well face the other way

  /** Facets given again whose copies do not count, cancel or face both ways, where facets disagree
   * or, where none do, beside open edges. Closed surfaces that share them mean more, if some of
   * their facets are reversed. */
  Id DoubtfulCopies = 0;

  double TurnedShare = 0;   ///< of the surface's area
  double SheetShare = 0;    ///< of the surface's area
  double MembraneShare = 0; ///< of the surface's area
  ShellCounts Kinds;        ///< in the end, if facets agree with their shells
  std::vector<std::string> Warnings;
  std::vector<std::string> UncountedWarnings; ///< of membranes and sheets that count nothing
};

/**
 * Which facets to turn over, so that the winding number is that of the solid that is meant (thesis,
 * section 8.7, leaves this open). Multiplicity and Sources tell which way a facet faces, not its
 * corners. Facets may cross.
 *
 * Automatic first makes the facets of each shell agree (Shells.h), then chooses which shells to
 * turn (ChooseTurns.h) by the volumes that they enclose, holes capped (ShellChains.h,
 * SampleRegions.h). Sheets are not turned, and turn nothing else. Membranes (Membranes.h) do not
 * count, whatever the orientation. No choice depends on the number of threads.
 *
 * @param[in] edges those of surface.Facets
 * @param[in] crossings where there are none it is quicker
 * @throws Error (Stopped)
 */
FacetTurns FindFacetTurns(const FacetComplex& surface, const std::vector<FacetEdge>& edges,
  Orientation orientation, Monitor& monitor, Crossings crossings = Crossings::Unknown);

/** The same, and turn them. @param[in,out] surface Multiplicity and Sources change */
FacetTurns OrientFacets(FacetComplex& surface, const std::vector<FacetEdge>& edges,
  Orientation orientation, Monitor& monitor, Crossings crossings = Crossings::Unknown);

/** The input triangles of facets that are marked, ascending. @param[in] marks one per facet */
std::vector<Id> TrianglesOfFacets(const FacetComplex& surface, const std::vector<char>& marks);

/** The counts under their names, for `statistics`. */
void AddTurns(const FacetTurns& turns, Statistics& statistics);
} // namespace insideout
