// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/EdgeRemoval.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace insideout
{
/** How hard flips try to take an edge away. */
struct FlipEffort
{
  FlipOperator::Limits Limits;
  int Depth;  ///< levels of edges that may go before it, to make its ring smaller
  int Budget; ///< how many of these are tried

  /** The work (WorkBudget) beyond which none is tried any more. */
  std::int64_t EndOfWork = std::numeric_limits<std::int64_t>::max();
};

/**
 * Where the engine stops trying. None of these decides what is right, for predicates are exact:
 * they decide when it tries something else, and so that it ends. All are counts, of tries or of
 * work (WorkBudget: 100 million units are about a second), none is time or length.
 */
struct EngineLimits
{
  // --- Pulls (RecoverSegments.h) ---

  /** Missing segments of a vertex, from which on they are recovered at once. Flips recover fewer in
   * less work. */
  static constexpr std::size_t LeastPulled = 4;

  // --- Flips (FlipRounds.h, RecoverSegments.h, RecoverFacets.h) ---

  /** Only flips that leave less in the way than before. Few larger rings can be triangulated. */
  static constexpr FlipEffort PlainFlips = { { -1, 10 }, 0, 0 };

  /** For a round of plain flips, per point and constraint: some 0.02 ms. Surfaces of which flips
   * recover nearly all take a tenth. */
  static constexpr std::int64_t WorkPerElement = 1000;

  /** The deeper flips that follow, each of which gains less for more work. */
  static constexpr std::array<FlipEffort, 3> DeepFlips = { { { { -1, 10 }, 1, 40 },
    { { 0, 12 }, 2, 150 }, { { 1, 12 }, 3, 500 } } };

  /** For each of these, per point and constraint, and at most: a ms or two, for the surfaces on
   * which they do without any cut. What they do not get, cuts recover in less time. */
  static constexpr std::int64_t DeepWorkPerElement = 375;
  static constexpr std::int64_t MostWorkOnDeepFlips = 60000;

  /** Nearly all segments need fewer than ten flips, and some would go on for ever. */
  static constexpr int FlipsPerSegment = 50;

  /** Passes over all edges that cross a facet: each leaves fewer, or other ones. */
  static constexpr int PassesPerFacet = 20;

  /** Flips in a plane for each edge crossed. Where the plane is triangulated all over, few are
   * needed. */
  static constexpr std::size_t FlatFlipsPerCrossing = 8;

  /** Any flip, where nothing is in the way of anything; of larger rings hardly one gains. */
  static constexpr FlipOperator::Limits AnyFlip = { 0, 10 };

  // --- Steiner points (RecoverSegments.h, SteinerPoints.h, MovePoint.h) ---

  /** On one segment, and beside it: one that needs more passes through what it may not. */
  static constexpr int SplitsPerSegment = 1000;

  /** Binary digits of a place on a segment: cells are not thinner, for doubles have 1074. */
  static constexpr int DigitsOnSegment = 500;

  /** Cells that give way to a point that moves: nearly all moves change fewer. */
  static constexpr std::size_t LargestCavity = 400;

  /** Stop removing points one by one when fewer than one in this many goes, or after this many
   * passes, which none was seen to take. */
  static constexpr std::size_t LeastYield = 50;
  static constexpr int RemovingPasses = 1000;

  // --- Shaking (RecoverConstraints.h, SteinerPoints.h) ---

  /** Flips at random for each cell around a point, and at most around a point. */
  static constexpr std::size_t FlipsPerCell = 2;
  static constexpr std::size_t FlipsPerShake = 200;

  /** Stop after this many rounds of shaking that remove no point. */
  static constexpr int ShakesWithoutGain = 12;

  /** Share of the work of this recovery, as a divisor, that may go into shaking Steiner points that
   * have places; some ms more. */
  static constexpr std::int64_t WorkPerShake = 10;
  static constexpr std::int64_t WorkOnShaking = 1000000;

  // --- Rounding (RoundPoints.h) ---

  /** Places that are tried per point, of its hundreds, where many points are tried again and again.
   */
  static constexpr int PlacesAtRandom = 60;

  /** Other places that are tried for a point which is in the way, or for one more. */
  static constexpr int PlacesPerStir = 8;

  // --- Taking out and recovering anew (RecoverConstraints.h, RecoverLostFacets.h) ---

  /** Rings of cells around points that find no place in which facets are given up. */
  static constexpr int RingsGivenUp = 5;

  /** Facets are taken out in fewer than this many rings of cells around a lost one. */
  static constexpr unsigned RingsOfRuins = 3;

  /** Nearly all facets that are lost at first are there after fewer tries, without more points. */
  static constexpr int TriesBeforeSplitting = 4;

  /** On facets that are lost, beside as much as all before took: a second or two. */
  static constexpr std::int64_t WorkOnLostFacets = 100000000;

  /** Edges that are tried to flip a face away that is a facet's twin. There are few of these, so
   * that they may be tried hard. */
  static constexpr FlipEffort TwinFlips = { { 0, 12 }, 2, 200 };

  /** Attempts from scratch before meshing without facets. */
  static constexpr int Attempts = 8;
};
} // namespace insideout
