// SPDX-License-Identifier: GPL-3.0-or-later
#include "DelaunayOfPoints.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Delaunay =
  CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

constexpr const char* Stage = "tetrahedralizing";
constexpr std::size_t InsertionsBetweenChecks = 256;

/** What a cell takes: CGAL's, with its share of the points, and ours. */
constexpr double BytesPerCell = 200;

void CheckMemory(std::size_t cells, double mebibytes)
{
  if (BytesPerCell * static_cast<double>(cells) > mebibytes * 1024 * 1024)
  {
    throw Error(ErrorCode::TetrahedralizerFailed,
      "the points alone have more tetrahedra than the memory budget holds (" +
        std::to_string(cells) + " so far)");
  }
}

void Insert(const std::vector<Kernel::Point_3>& places, const std::vector<std::size_t>& order,
  double mebibytes, Monitor& monitor, Delaunay& delaunay)
{
  Delaunay::Cell_handle near;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i % InsertionsBetweenChecks == 0)
    {
      monitor.Check(Stage, static_cast<double>(i) / static_cast<double>(order.size()));
      CheckMemory(delaunay.tds().number_of_cells(), mebibytes);
    }
    const std::size_t before = delaunay.number_of_vertices();
    const Delaunay::Vertex_handle vertex = delaunay.insert(places[order[i]], near);
    const bool isNew = delaunay.number_of_vertices() > before;
    const Id id = static_cast<Id>(order[i]);
    vertex->info() = isNew ? id : std::min(id, vertex->info());
    near = vertex->cell();
  }
}
} // namespace

TetgenAnswer DelaunayOfPoints(const std::vector<Point>& points, double mebibytes, Monitor& monitor)
{
  std::vector<Kernel::Point_3> places;
  places.reserve(points.size());
  for (const Point& point : points)
  {
    places.emplace_back(point[0], point[1], point[2]);
  }
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto placeOf = CGAL::make_property_map(places);
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(placeOf)>(placeOf));

  Delaunay delaunay;
  Insert(places, order, mebibytes, monitor, delaunay);
  TetgenAnswer answer;
  answer.Points = points;
  answer.Cells.reserve(delaunay.number_of_finite_cells());
  for (const auto& cell : delaunay.finite_cell_handles())
  {
    Tetrahedron corners;
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = cell->vertex(k)->info();
    }
    std::sort(corners.begin(), corners.end());
    answer.Cells.push_back(corners);
  }
  std::sort(answer.Cells.begin(), answer.Cells.end());
  return answer;
}
} // namespace insideout
