// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>

namespace insideout
{
/** The ends of an edge, the lower first. */
using Edge = std::array<Id, 2>;

inline Edge EdgeBetween(Id p, Id q)
{
  return { std::min(p, q), std::max(p, q) };
}
} // namespace insideout
