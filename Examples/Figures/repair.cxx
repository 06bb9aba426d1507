// SPDX-License-Identifier: GPL-3.0-or-later
// Repairs a surface as a surface, by CGAL's functions: repair.py compiles it and draws what comes
// out.
//
//     repair cgal|meshfix IN.off OUT.off
//
// cgal: what the manual of CGAL 5.5's Polygon Mesh Processing puts together: the soup is cleaned
// and oriented, its borders are stitched, its holes are filled, and what still crosses itself is
// removed and filled again. meshfix: the steps of Attene, A lightweight approach to repairing
// digitized polygon meshes (2010): the largest component alone is kept, holes are filled, and
// facets that cross are taken away with ever more of what is around, and filled again.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

namespace
{
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Mesh::Face_index;

constexpr int Rounds = 10; // of cutting out and filling, as MeshFix has it

Mesh ReadAsSurface(const std::string& file)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_polygon_soup(file, points, polygons))
  {
    throw std::runtime_error("cannot read " + file);
  }
  PMP::repair_polygon_soup(points, polygons);
  PMP::orient_polygon_soup(points, polygons);
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(points, polygons, mesh);
  PMP::triangulate_faces(mesh);
  PMP::remove_degenerate_faces(mesh);
  PMP::stitch_borders(mesh);
  return mesh;
}

void FillHoles(Mesh& mesh)
{
  std::vector<Mesh::Halfedge_index> borders;
  PMP::extract_boundary_cycles(mesh, std::back_inserter(borders));
  for (const Mesh::Halfedge_index border : borders)
  {
    std::vector<Face> patch;
    PMP::triangulate_hole(mesh, border, std::back_inserter(patch));
  }
}

/** The facets that cross others, and a number of rings of facets around them. */
std::set<Face> CrossingFaces(const Mesh& mesh, int rings)
{
  std::vector<std::pair<Face, Face>> pairs;
  PMP::self_intersections(mesh, std::back_inserter(pairs));
  std::set<Face> crossing;
  for (const auto& [a, b] : pairs)
  {
    crossing.insert({ a, b });
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::set<Face> before = crossing;
    for (const Face face : before)
    {
      for (const Mesh::Vertex_index vertex : vertices_around_face(mesh.halfedge(face), mesh))
      {
        for (const Face other : faces_around_target(mesh.halfedge(vertex), mesh))
        {
          if (other != Mesh::null_face())
          {
            crossing.insert(other);
          }
        }
      }
    }
  }
  return crossing;
}

void RepairAsMeshFix(Mesh& mesh)
{
  PMP::keep_largest_connected_components(mesh, 1);
  FillHoles(mesh);
  for (int round = 0; round < Rounds; ++round)
  {
    const std::set<Face> crossing = CrossingFaces(mesh, round / 2);
    if (crossing.empty())
    {
      break;
    }
    for (const Face face : crossing)
    {
      CGAL::Euler::remove_face(mesh.halfedge(face), mesh);
    }
    PMP::keep_largest_connected_components(mesh, 1);
    PMP::duplicate_non_manifold_vertices(mesh);
    FillHoles(mesh);
  }
}

void RepairAsManual(Mesh& mesh)
{
  FillHoles(mesh);
  PMP::experimental::remove_self_intersections(mesh);
  FillHoles(mesh);
}
} // namespace

int main(int argc, char** argv)
{
  const std::string way = argc == 4 ? argv[1] : "";
  if (way != "cgal" && way != "meshfix")
  {
    std::fprintf(stderr, "usage: repair cgal|meshfix IN.off OUT.off\n");
    return 1;
  }
  try
  {
    Mesh mesh = ReadAsSurface(argv[2]);
    way == "cgal" ? RepairAsManual(mesh) : RepairAsMeshFix(mesh);
    if (CGAL::is_closed(mesh))
    {
      PMP::orient_to_bound_a_volume(mesh);
    }
    mesh.collect_garbage();
    std::printf(
      "closed %d, crosses itself %d\n", CGAL::is_closed(mesh), PMP::does_self_intersect(mesh));
    return CGAL::IO::write_polygon_mesh(argv[3], mesh, CGAL::parameters::stream_precision(17)) ? 0
                                                                                               : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "repair: %s\n", error.what());
    return 1;
  }
}
