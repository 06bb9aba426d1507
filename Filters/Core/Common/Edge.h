// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace insideout
{
/** The ends of an edge, the lower first. */
using Edge = std::array<Id, 2>;

inline Edge EdgeBetween(Id p, Id q)
{
  return { std::min(p, q), std::max(p, q) };
}

/** For tables of edges. */
struct HashOfEdge
{
  std::size_t operator()(const Edge& edge) const
  {
    const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::uint32_t>(edge[0]))
        << 32 |
      static_cast<std::uint32_t>(edge[1]);
    return std::hash<std::uint64_t>()(key * 0x9E3779B97F4A7C15u);
  }
};
} // namespace insideout
