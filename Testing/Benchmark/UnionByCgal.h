// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "BooleanByUs.h"

#include <functional>

/** The reference for booleans: CGAL's corefinement. */
namespace benchmark
{
/** The union of two surfaces, anew at each call: PMP::corefine_and_compute_union on Surface_meshes
 * of Epick's points. @param[in] a,b closed, oriented outward, without crossings */
std::function<Made()> UnionByCgal(
  const insideout::TriangleSoup& a, const insideout::TriangleSoup& b);
} // namespace benchmark
