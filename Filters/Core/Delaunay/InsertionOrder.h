// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <cstddef>
#include <vector>

namespace insideout
{
/**
 * An order in which points become Delaunay tetrahedra fast (Amenta, Choi, Rote 2003): rounds, each
 * of points from everywhere and eight times as large as the one before, and within a round along a
 * curve through space. The first four points span space.
 */
struct InsertionOrder
{
  std::vector<Id> Points;
  std::vector<std::size_t> Rounds; ///< where they end
};

/** @throws Error Planar */
InsertionOrder OrderOfInsertion(const std::vector<Point>& points);
} // namespace insideout
