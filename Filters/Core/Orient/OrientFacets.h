// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Statistics.h"
#include "Orient/ShellCounts.h"

#include <string>

namespace insideout
{
/** The intended orientation of the facets. */
enum class Orientation
{
  Automatic, ///< facets that disagree, and inverted shells, are turned over
  AsGiven,   ///< nothing is turned
  Reverse,   ///< all are turned over
  Outward    ///< every shell that encloses a volume faces outward, regardless of nesting
};

/** Facets that intersect beyond shared corners and edges. */
enum class Crossings
{
  Unknown,
  Absent ///< no two facets do
};

/** The facets that were turned over, and the composition of the surface. For shells see Shells.h.
 */
struct FacetTurns
{
  std::vector<std::int16_t> Multiplicity; ///< one per facet: its final count
  std::vector<char> Turned;               ///< one per facet; of several copies, the first decides
  /// one per facet: belongs to a shell that encloses nothing, or counts 0
  std::vector<char> IsSheet;
  std::vector<char> IsMembrane; ///< one per facet: belongs to a membrane (Membranes.h)
  std::vector<Id> Shell; ///< one per facet, None for those that count 0; of several the first

  /**
   * The volume that each shell finally encloses, holes capped: negative for a cavity, 0 for a
   * sheet.
   */
  std::vector<double> ShellVolumes;
  std::vector<char> ShellHasHoles; ///< one per shell; 0 for a sheet

  Id Shells = 0;
  Id Membranes = 0; ///< membranes: shells that do not count
  Id MembraneFacets = 0;
  Id UncountedSheets = 0; ///< sheets outside the solid that do not count
  Id TurnedFacets = 0;
  Id TurnedShells = 0;      ///< the surface as a whole was turned over
  Id DisagreeingFacets = 0; ///< given with the opposite orientation to their shells
  Id UndecidedShells = 0;   ///< could equally face the other way

  /** Repeated facets whose copies do not count, cancel or face both ways, next to facets that
   * disagree or, if none do, next to open edges. They hint at closed surfaces that share facets,
   * some of them reversed. */
  Id DoubtfulCopies = 0;

  double TurnedShare = 0;   ///< of the surface's area
  double SheetShare = 0;    ///< of the surface's area
  double MembraneShare = 0; ///< of the surface's area
  ShellCounts Kinds;        ///< in the end, once facets agree with their shells
  std::vector<std::string> Warnings;
  std::vector<std::string> UncountedWarnings; ///< area of membranes and sheets that do not count
};

/**
 * Decide which facets to turn over, so that the winding number is that of the intended solid
 * (thesis, section 8.7, leaves this open). A facet's orientation is given by Multiplicity and
 * Sources, not by its corners. Facets may cross.
 *
 * Automatic first makes the facets of each shell agree (Shells.h), then chooses which shells to
 * turn (ChooseTurns.h) by the volumes that they enclose, holes capped (ShellChains.h,
 * SampleRegions.h). Sheets are not turned and do not influence other shells. Membranes
 * (Membranes.h) do not count, whatever the orientation. No choice depends on the number of threads.
 *
 * @param[in] edges those of surface.Facets
 * @param[in] crossings without any this is faster
 * @throws Error (Stopped)
 */
FacetTurns FindFacetTurns(const FacetComplex& surface, const FacetEdges& edges,
  Orientation orientation, Monitor& monitor, Crossings crossings = Crossings::Unknown);

/** The same, and turn them. @param[in,out] surface Multiplicity and Sources change */
FacetTurns OrientFacets(FacetComplex& surface, const FacetEdges& edges, Orientation orientation,
  Monitor& monitor, Crossings crossings = Crossings::Unknown);

/** The input triangles of facets that are marked, ascending. @param[in] marks one per facet */
std::vector<Id> TrianglesOfFacets(const FacetComplex& surface, const std::vector<char>& marks);

/** The counts under their names, for `statistics`. */
void AddTurns(const FacetTurns& turns, Statistics& statistics);
} // namespace insideout
