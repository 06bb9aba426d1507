// SPDX-License-Identifier: GPL-3.0-or-later
#include "Support/ReadTriangles.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>

#include <cstdio>

/** What CGAL makes of pairs of surfaces, for judge-boolean.py: it dies of some. */
namespace
{
namespace PMP = CGAL::Polygon_mesh_processing;

/** As CGAL's manual has it for soups: repaired, oriented, outward. */
template <typename Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> Read(const char* path)
{
  const insideout::TriangleSoup soup = testmeshes::ReadTriangles(path);
  std::vector<typename Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  for (const insideout::Point& p : soup.Points)
  {
    points.emplace_back(p[0], p[1], p[2]);
  }
  for (const insideout::Triangle& t : soup.Triangles)
  {
    triangles.push_back({ static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
      static_cast<std::size_t>(t[2]) });
  }
  PMP::repair_polygon_soup(points, triangles);
  PMP::orient_polygon_soup(points, triangles);
  CGAL::Surface_mesh<typename Kernel::Point_3> mesh;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  if (CGAL::is_closed(mesh))
  {
    PMP::orient_to_bound_a_volume(mesh);
  }
  return mesh;
}

template <typename Mesh>
void PrintVolume(const Mesh& mesh)
{
  std::printf("%.17g\n", CGAL::to_double(PMP::volume(mesh)));
}

bool ByCorefinement(const char* first, const char* second)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto a = Read<Kernel>(first);
  const auto b = Read<Kernel>(second);
  const auto safely = CGAL::parameters::throw_on_self_intersection(true);
  for (int operation = 0; operation < 3; ++operation)
  {
    auto one = a;
    auto other = b;
    CGAL::Surface_mesh<Kernel::Point_3> made;
    const bool done = operation == 0 ? PMP::corefine_and_compute_union(one, other, made, safely)
      : operation == 1 ? PMP::corefine_and_compute_intersection(one, other, made, safely)
                       : PMP::corefine_and_compute_difference(one, other, made, safely);
    if (!done)
    {
      return false;
    }
    PrintVolume(made);
  }
  return true;
}

bool ByNef(const char* first, const char* second)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Nef = CGAL::Nef_polyhedron_3<Kernel>;
  const Nef a(Read<Kernel>(first));
  const Nef b(Read<Kernel>(second));
  for (const Nef& nef : { a + b, a * b, a - b })
  {
    CGAL::Surface_mesh<Kernel::Point_3> made;
    CGAL::convert_nef_polyhedron_to_polygon_mesh(nef, made, true);
    PrintVolume(made);
  }
  return true;
}
} // namespace

/** JudgeBooleanPeers corefinement|nef A B: prints the volumes of A or B, A and B, A - B. */
int main(int argc, char** argv)
{
  if (argc != 4)
  {
    return 2;
  }
  try
  {
    const bool done =
      std::string(argv[1]) == "nef" ? ByNef(argv[2], argv[3]) : ByCorefinement(argv[2], argv[3]);
    return done ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
