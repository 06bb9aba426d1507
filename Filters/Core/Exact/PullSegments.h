// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Exact/ExactState.h"

#include <cstddef>

namespace insideout
{
/**
 * Least number of vertices of a block. With 16,145 a block, 12 % of the segments of a million
 * facets need cells of several blocks, and these are pulled out of order: half as many vertices a
 * block give more Steiner points.
 */
constexpr std::size_t VerticesPerBlock = 16000;

/**
 * Recover segments by pulling one of their ends, or else the other. Blocks of vertices are pulled
 * on several threads, then what needs cells of several blocks, in blocks four times as large, and
 * so on; a small mesh is one block. The mesh is the same for any number of threads.
 * @return the segments that are still missing
 */
std::vector<Id> RecoverSegmentsByPulls(ExactState& state, const std::vector<Id>& missing,
  std::size_t verticesPerBlock = VerticesPerBlock);

/**
 * Pull segments with both ends in one block, where all cells that give way are in that block, too.
 * All vertices have to be doubles, and no journal may be kept.
 * @param[in] blockOf per vertex the number of its block, None for the infinite vertex
 * @return the segments that were put off: nothing has changed for them
 */
std::vector<Id> PullInBlocks(ExactState& state, const std::vector<Id>& missing,
  const std::vector<Id>& blockOf, std::size_t blocks);
} // namespace insideout
