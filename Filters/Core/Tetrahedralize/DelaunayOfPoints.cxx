// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/DelaunayOfPoints.h"

#include "Common/Kernel.h"
#include "Common/Stages.h"
#include "Exact/InsertPoints.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>

namespace insideout
{
namespace
{
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Id, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Delaunay =
  CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

/** Memory per cell: CGAL's, with its share of the points, and ours. */
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
} // namespace

RawTetrahedra DelaunayOfPoints(const std::vector<Point>& points, double mebibytes, Monitor& monitor)
{
  Delaunay delaunay;
  InsertPoints(points, delaunay,
    [&](double fraction)
    {
      monitor.Check(Stages::Tetrahedralizing, fraction);
      CheckMemory(delaunay.tds().number_of_cells(), mebibytes);
    });
  RawTetrahedra raw;
  raw.Points = points;
  raw.Cells.reserve(delaunay.number_of_finite_cells());
  for (const auto& cell : delaunay.finite_cell_handles())
  {
    Tetrahedron corners;
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = cell->vertex(k)->info();
    }
    std::sort(corners.begin(), corners.end());
    raw.Cells.push_back(corners);
  }
  std::sort(raw.Cells.begin(), raw.Cells.end());
  return raw;
}
} // namespace insideout
