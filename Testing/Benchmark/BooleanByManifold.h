// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BooleanByUs.h"

#include <functional>
#include <string>

namespace benchmark
{
/** Two surfaces that manifold has taken, or what it says of the first that it refuses. */
struct ManifoldPair
{
  std::string Refusal;
  double Seconds;                                    ///< processor time that taking both took
  std::function<Made(insideout::SetOperation)> Make; ///< anew at each call
};

/** Points of equal coordinates become one first, for manifold pairs edges by points. */
ManifoldPair TakeByManifold(const insideout::TriangleSoup& a, const insideout::TriangleSoup& b);
} // namespace benchmark
