// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace insideout
{
/**
 * Insert points into a CGAL triangulation whose vertices store an id, in an order in which
 * successive points are near each other. A vertex gets the lowest id of coincident points.
 * @param[in] check called at intervals with the fraction of points inserted; may throw
 */
template <typename Triangulation, typename Check>
void InsertPoints(
  const std::vector<Point>& points, Triangulation& triangulation, const Check& check)
{
  using Traits = typename Triangulation::Geom_traits;
  constexpr std::size_t InsertionsBetweenChecks = 256;
  std::vector<typename Traits::Point_3> places;
  places.reserve(points.size());
  for (const Point& point : points)
  {
    places.emplace_back(point[0], point[1], point[2]);
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto placeOf = CGAL::make_property_map(places);
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_3<Traits, decltype(placeOf)>(placeOf));

  typename Triangulation::Cell_handle near;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i % InsertionsBetweenChecks == 0)
    {
      check(static_cast<double>(i) / static_cast<double>(order.size()));
    }
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(places[order[i]], near);
    const bool isNew = triangulation.number_of_vertices() > before;
    const Id id = static_cast<Id>(order[i]);
    vertex->info() = isNew ? id : std::min(id, vertex->info());
    near = vertex->cell();
  }
}
} // namespace insideout
