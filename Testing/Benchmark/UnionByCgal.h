// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <functional>

/** What booleans are compared with: CGAL's corefinement. */
namespace benchmark
{
struct Union
{
  double Seconds;     ///< of corefine_and_compute_union alone
  std::size_t Facets; ///< of the result; 0 where it says that it could not be made
};

/** The union of two surfaces, anew at each call: PMP::corefine_and_compute_union on Surface_meshes
 * of Epick's points. @param[in] a,b closed, oriented outward, without crossings */
std::function<Union()> UnionByCgal(
  const insideout::TriangleSoup& a, const insideout::TriangleSoup& b);
} // namespace benchmark
