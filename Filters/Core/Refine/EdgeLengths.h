// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/** Lengths and rounds of remeshing, of cells with their surface and of a surface alone. */
namespace insideout
{
/**
 * Relative to the required edge length: outside of this range an edge is split or contracted, and
 * its halves are then near the length.
 */
constexpr double LongestEdge = 4.0 / 3;
constexpr double ShortestEdge = 4.0 / 5;

/**
 * An edge is not split if another edge of a piece is this many times as long. The value is below
 * 3/2: in a low piece, halving a short edge of 2/3 of the long one makes the other short edge 2/3
 * of it, and the process would repeat.
 */
constexpr double MostTimesLonger = 1.4;

/** Limit of an edge's relative length when others are contracted. */
constexpr double LongestContracted = 1.6;

/** Each round halves edges: most surfaces take fewer. The limit excludes an endless loop. */
constexpr int MostRoundsOfSplits = 60;

/** Rounds of split, contract, flip and move. The first use the lengths as wanted, which shows where
 * edges have to stay short; the others use lengths that are short there. */
constexpr int RoundsOfWishes = 3;
constexpr int RoundsWhereRemeshed = 7;

/**
 * Bound of the longest edge over the least height of a triangle that is not thin; 1.2 for an
 * equilateral one.
 */
constexpr double MostHeights = 2;

/** Relative to the required length: the least distance for moving a point to the center of the
 * points around it. */
constexpr double LeastMove = 0.03;
} // namespace insideout
