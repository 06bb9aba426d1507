// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "Common/Monitor.h"
#include "Resolve/SplittableFacets.h"

namespace insideout
{
/** The meaning of a facet, besides its corners. */
struct Meaning
{
  Id Root = None;                   ///< a facet of the given complex that it is a piece of
  int Multiplicity = 0;             ///< along its own orientation
  std::vector<FacetSource> Sources; ///< by triangle; those of one triangle are all turned alike
};

/** A facet to be added. */
struct MeantFacet
{
  Triangle Corners;
  Meaning Means;
};

/**
 * The surface between two rounds of resolving: points and facets that change, and for each facet
 * its meaning in the given complex. Keeps a reference to that complex, and takes its points and, at
 * the end, its origins.
 */
class WorkingSurface
{
public:
  /** Begin with the constraints of the complex. */
  explicit WorkingSurface(FacetComplex& given);

  std::vector<Point> Points;                ///< the given ones first; new ones are added
  std::vector<Triangle> Facets;             ///< changed only by the functions below
  std::vector<std::array<Id, 2>> Crossings; ///< pairs of facets that cross, as far as searched

  Id NumberOfGivenPoints() const { return this->GivenPoints; }

  /** A facet of the given complex that a facet is a piece of. */
  Id RootOf(Id facet) const;

  Meaning MeaningOf(Id facet) const;

  /** Add a point that lies on a facet of the given complex. @return its id */
  Id AddPoint(const Point& p, Id root);

  /**
   * Remove facets and append others. A facet with the corners of another adds its meaning to that;
   * facets without a meaning are removed, too.
   */
  void Replace(std::vector<char> isRemoved, const std::vector<MeantFacet>& added);

  /** Replace facets by parts of the same meaning. */
  void Apply(const Replacement& replacement);

  /** Search the facets added since the last call for crossings. @throws Error (Stopped) */
  void FindCrossings(Monitor& monitor);

  /**
   * The same for all facets, if the crossings within sets are known.
   * @param[in] setOf one per facet
   * @param[in] nearOthers the facets that may meet one of another set
   */
  void FindCrossingsBetween(const std::vector<Id>& setOf, const std::vector<Id>& nearOthers,
    const std::vector<std::array<Id, 2>>& known, Monitor& monitor);

  /** The facets that were not searched for crossings yet. */
  std::vector<Id> UncheckedFacets() const;

  /** The degenerate ones among the facets that were not searched for crossings yet. */
  std::vector<Id> DegenerateFacets() const;

  std::vector<Id> CrossingFacets() const;

  /**
   * The complex: the constraints, then facets left out, then facets that were not constraints in
   * the given one. Unused new points are dropped; the other new points have the origins of the
   * facets that they lie on. The last function to be called.
   * @throws Error TooLarge, Stopped
   */
  FacetComplex Assemble(const std::vector<Id>& leftOut, Monitor& monitor);

private:
  void AddFacets(const std::vector<MeantFacet>& facets, std::vector<char>& isRemoved);
  Id AddMeaning(Meaning meaning);
  void DropUnusedPoints();
  void MoveToEnd(const std::vector<Id>& leftOut);
  void SetMeanings(FacetComplex& surface) const;
  std::vector<PointOrigin> OriginsOfPoints(Monitor& monitor) const;

  FacetComplex* Given;
  Id GivenPoints;
  std::vector<Id> MeaningIds; ///< per facet: a given facet, or after those the meaning of a piece
  std::vector<Meaning> Meanings; ///< of pieces, including removed ones
  std::vector<Id> Roots;         ///< of new points: the given facet on which they lie
  Id FirstUnchecked = 0;         ///< facets from here on are not searched for crossings yet
};

/**
 * Add the sources and multiplicity of a coincident facet, or of its reverse. If rounding folded a
 * triangle onto itself, its opposite pieces cancel.
 */
void Add(Meaning& meaning, const Meaning& other, bool reversed);
} // namespace insideout
