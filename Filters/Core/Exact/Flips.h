// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ProgressRange.h"
#include "Exact/ExactState.h"
#include "Exact/FlipTarget.h"

#include <functional>
#include <limits>

namespace insideout
{
/** The cost limit of a flip: it may add at most this number of obstacles. */
struct FlipLimits
{
  int Increase = -1;
  int LargestRing = 12;
};

/** Any flip, for meshes without a target; larger rings hardly ever gain. */
constexpr FlipLimits AnyFlip = { 0, 10 };

/** The effort for removing an edge by flips. */
struct FlipEffort
{
  FlipLimits Limits;
  int Depth;  ///< levels of recursion: edges that are removed first to make its ring smaller
  int Budget; ///< number of attempts

  /** The work (WorkBudget) after which attempts end. */
  std::int64_t EndOfWork = std::numeric_limits<std::int64_t>::max();
};

/** Only flips that reduce the obstacles. Larger rings can rarely be triangulated. */
constexpr FlipEffort PlainFlips = { { -1, 10 }, 0, 0 };

/**
 * Flips remove a face or an edge, in the way that leaves a target the fewest obstacles. Present
 * constraints stay.
 *
 * An edge with n cells around it is removed by triangulating the ring of n points; every triangle
 * becomes two cells (Freitag and Ollivier-Gooch 1997); the best triangulation is found by dynamic
 * programming (Klincsek 1980).
 */

/** Remove the face across from corner `face`: two cells become three. */
bool RemoveFace(
  ExactState& state, Id cell, int face, const FlipTarget& target, const FlipLimits& limits);

/** Remove the edge between u and v, of `cell`. */
bool RemoveEdge(
  ExactState& state, Id u, Id v, Id cell, const FlipTarget& target, const FlipLimits& limits);

/**
 * The same; if that fails, first make the ring smaller by removing edges between it and u or v,
 * down to the effort's depth.
 * @param[in,out] budget remaining number of edges to try
 */
bool RemoveEdgeDeeply(
  ExactState& state, Id u, Id v, const FlipTarget& target, const FlipEffort& effort, int& budget);

/**
 * Recover constraints by flips that reduce the obstacles each time, then some of the rest by deeper
 * flips; cuts recover the remainder faster.
 * @param[in] missing the constraints, in the order in which they are tried
 * @param[in] constraints their total number, to which the work is proportional
 * @param[in] recover called with a constraint and an effort; returns whether the mesh has it then
 * @return the constraints still missing, in the same order
 */
std::vector<Id> RecoverInRounds(const ExactState& state, std::vector<Id> missing,
  std::size_t constraints, const ProgressRange& phase,
  const std::function<bool(Id, const FlipEffort&)>& recover);
} // namespace insideout
