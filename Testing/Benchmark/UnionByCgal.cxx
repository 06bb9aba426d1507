// SPDX-License-Identifier: GPL-3.0-or-later
#include "UnionByCgal.h"

#include "Common/Statistics.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Surface_mesh.h>

namespace benchmark
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Mesh MeshOf(const insideout::TriangleSoup& soup)
{
  Mesh mesh;
  for (const insideout::Point& p : soup.Points)
  {
    mesh.add_vertex({ p[0], p[1], p[2] });
  }
  for (const insideout::Triangle& t : soup.Triangles)
  {
    mesh.add_face(Mesh::Vertex_index(static_cast<unsigned>(t[0])),
      Mesh::Vertex_index(static_cast<unsigned>(t[1])),
      Mesh::Vertex_index(static_cast<unsigned>(t[2])));
  }
  return mesh;
}
} // namespace

std::function<Made()> UnionByCgal(
  const insideout::TriangleSoup& a, const insideout::TriangleSoup& b)
{
  return [first = MeshOf(a), second = MeshOf(b)]()
  {
    Mesh one = first;
    Mesh other = second;
    Mesh result;
    insideout::Stopwatch stopwatch;
    const bool done = CGAL::Polygon_mesh_processing::corefine_and_compute_union(one, other, result);
    return Made{ stopwatch.Lap(), done ? result.number_of_faces() : 0 };
  };
}
} // namespace benchmark
