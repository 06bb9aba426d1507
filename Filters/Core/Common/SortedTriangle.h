// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <cstddef>

namespace insideout
{
/** A triangle's points in ascending order, and whether sorting reversed it. */
struct SortedTriangle
{
  explicit SortedTriangle(const Triangle& t)
    : Points{ { std::min({ t[0], t[1], t[2] }), 0, std::max({ t[0], t[1], t[2] }) } }
    , Turned((t[0] > t[1]) ^ (t[1] > t[2]) ^ (t[0] > t[2]))
  {
    // Branchless, because the order is unpredictable.
    this->Points[1] = t[0] ^ t[1] ^ t[2] ^ this->Points[0] ^ this->Points[2];
  }

  Triangle Points;
  bool Turned;
};

/** For tables of triangles. */
struct HashOfTriangle
{
  std::size_t operator()(const Triangle& t) const
  {
    std::size_t hash = 0;
    for (const Id point : t)
    {
      hash = (hash ^ static_cast<std::size_t>(point)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};
} // namespace insideout
