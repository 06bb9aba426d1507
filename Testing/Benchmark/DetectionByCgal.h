// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

#include <functional>
#include <string>

/** The reference for the resolver: CGAL finds the pairs of facets that meet, on one thread. */
namespace benchmark
{
struct Detection
{
  std::string Name;                 ///< of CGAL's algorithm
  std::function<std::size_t()> Run; ///< finds the pairs anew at each call, and counts them
};

/**
 * PMP::self_intersections on a Surface_mesh of Epick's points where the surface is a polygon mesh;
 * else box_self_intersection_d with exact tests of the pairs. Preparations are not part of Run.
 */
Detection DetectionByCgal(const insideout::FacetComplex& surface);
} // namespace benchmark
