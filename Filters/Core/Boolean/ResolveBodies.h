// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Boolean/Body.h"
#include "Common/Statistics.h"
#include "Orient/OrientFacets.h"
#include "Orient/ThickenFacets.h"
#include "Validate/CountedChain.h"

namespace insideout
{
struct BodyParameters
{
  CountedChainParameters Chain; ///< points of different bodies are merged alike
  insideout::Orientation Orientation = insideout::Orientation::Automatic;
  ThickenParameters Thicken;

  /** Distance between faces of two bodies up to which they touch: 0 for exact contact, -1 for the
   * rounding error of their coordinates (TouchBodies). */
  double TouchTolerance = -1;
};

/** The multiplicity of a facet in one body. */
struct BodyCount
{
  Id Body;
  int Count; ///< along the facet's orientation: w of the body rises by it from front to back
};

/** One body after validation and orientation, before it is resolved with the others. */
struct CountedBody
{
  SurfaceCounts Counts; ///< of the input alone, if the body has no facets
  FacetTurns Turns;     ///< by facets of the body's own chain
  Id ThickenedFacets = 0;
};

/** A shell with holes that encloses a volume; the cut may leave it out all the same. */
struct HoledShell
{
  std::string Body;          ///< its name
  Id Number;                 ///< of the shell in its body
  double Volume;             ///< once its holes are closed
  std::vector<Id> Triangles; ///< of its facets
};

/** Bodies resolved together. Points and triangles keep the numbers of the bodies. */
struct ResolvedBodies
{
  /**
   * A facet's sources are those of all bodies; its multiplicity is their sum, and 0 if they cancel.
   */
  FacetComplex Surface;

  /**
   * The counts of facet f are BodyCounts[CountOffsets[f]] to BodyCounts[CountOffsets[f + 1]]: one
   * per body that it counts for, ascending by body; none is 0.
   */
  std::vector<Id> CountOffsets = { 0 };
  std::vector<BodyCount> BodyCounts;

  std::vector<CountedBody> Bodies;
  std::vector<Id> MergedInto; ///< per point, the lowest point that it was merged with, or itself
  std::vector<Id> DegenerateTriangles; ///< left out; ascending
  std::vector<Id> TurnedTriangles;     ///< turned over; ascending
  std::vector<Id> SheetTriangles;      ///< of facets that enclose nothing; ascending
  std::vector<HoledShell> HoledShells; ///< of all bodies
  Id IntersectingPairs = 0;            ///< of facets, within bodies and among them
  Id TouchingPairs = 0;                ///< of bodies that touch up to rounding (TouchBodies)
  Id TouchMovedPoints = 0;             ///< so that they touch
  Id NearTriangles = 0;                ///< of bodies that nearly touch (FindNearBodies)
  double SecondsValidate = 0;          ///< until they met
  std::vector<std::string> Warnings;

  Id NumberOfBodies() const { return static_cast<Id>(this->Bodies.size()); }
};

/** The increase of a body's w from the front of a facet, where its normal points, to the back. */
inline int CountFor(const ResolvedBodies& bodies, Id facet, Id body)
{
  for (Id i = bodies.CountOffsets[facet]; i < bodies.CountOffsets[facet + 1]; ++i)
  {
    if (bodies.BodyCounts[i].Body == body)
    {
      return bodies.BodyCounts[i].Count;
    }
  }
  return 0;
}

/** Add the statistics TouchingPairs, TouchMovedPoints and NearTriangles. */
void AddTouches(const ResolvedBodies& bodies, Statistics& statistics);

/**
 * Stages validate and pre. First count and orient each body as if it were alone (CountFacets,
 * OrientFacets, ThickenFacets), so that bodies neither cancel nor turn each other's facets. Then
 * resolve all as one complex. Coincident pieces of several bodies are one facet, with a count per
 * body.
 *
 * A single body has nothing to join. A body without facets is empty, with a warning unless it has
 * no name.
 *
 * @throws Error EmptySurface if no body has a facet; errors of the stages, prefixed with the body's
 * name; Stopped
 */
ResolvedBodies ResolveBodies(
  std::vector<Body> bodies, const BodyParameters& parameters, Monitor& monitor);
} // namespace insideout
