// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

namespace insideout
{
/** Segments become edges of the mesh. Functions return the segments that are still missing. */

/** The segments without Steiner points that are no edges. */
std::vector<Id> FindMissingSegments(const ExactState& state, const std::vector<Id>& segments);

/** Recover segments by flips alone. */
std::vector<Id> RecoverSegmentsByFlips(ExactState& state, const std::vector<Id>& missing);

/** Where a missing piece of a segment is split. */
enum class SplitFrom
{
  Middle,   ///< in the middle of what it crosses: few points
  HigherEnd ///< at what it crosses first from the end with the higher number: other points
};

/**
 * Recover segments with Steiner points that lie exactly on them. Each lies where a missing
 * piece of the segment crosses something, within a cell or on an edge, so no constraint is lost.
 * Then flips or pulls connect the two parts, or these are split, too. Only segments that pass
 * through a vertex fail.
 */
std::vector<Id> RecoverSegmentsBySplits(
  ExactState& state, const std::vector<Id>& missing, SplitFrom from);
} // namespace insideout
