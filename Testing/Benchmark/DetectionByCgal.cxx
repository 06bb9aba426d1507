// SPDX-License-Identifier: GPL-3.0-or-later
#include "DetectionByCgal.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <memory>

namespace benchmark
{
namespace
{
using namespace insideout;
namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Position = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Position>;

struct Soup
{
  std::vector<Position> Points;
  std::vector<std::array<std::size_t, 3>> Triangles;
};

Soup ToSoup(const FacetComplex& surface)
{
  Soup soup;
  for (const Point& p : surface.Points)
  {
    soup.Points.emplace_back(p[0], p[1], p[2]);
  }
  for (const Triangle& t : surface.Facets)
  {
    soup.Triangles.push_back({ static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
      static_cast<std::size_t>(t[2]) });
  }
  return soup;
}

std::size_t PairsOfMesh(const Mesh& mesh)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  PMP::self_intersections<CGAL::Sequential_tag>(mesh, std::back_inserter(pairs));
  return pairs.size();
}

/** Whether two triangles meet beyond what they share, tested as PMP does: opposite edges against
 * triangles where they share a corner, the angle where they share an edge. */
bool MeetBeyondShared(const Soup& soup, std::array<std::size_t, 3> a, std::array<std::size_t, 3> b)
{
  const auto isIn = [](const std::array<std::size_t, 3>& t)
  { return [&t](std::size_t p) { return std::find(t.begin(), t.end(), p) != t.end(); }; };
  const auto shared = std::stable_partition(a.begin(), a.end(), isIn(b)) - a.begin();
  std::stable_partition(b.begin(), b.end(), isIn(a));
  const auto at = [&](std::size_t p) -> const Position& { return soup.Points[p]; };
  const auto triangle = [&](const std::array<std::size_t, 3>& t)
  { return Kernel::Triangle_3(at(t[0]), at(t[1]), at(t[2])); };
  const auto opposite = [&](const std::array<std::size_t, 3>& t)
  { return Kernel::Segment_3(at(t[1]), at(t[2])); };
  switch (shared)
  {
    case 0:
      return CGAL::do_intersect(triangle(a), triangle(b));
    case 1:
      return CGAL::do_intersect(triangle(a), opposite(b)) ||
        CGAL::do_intersect(triangle(b), opposite(a));
    case 2:
      return CGAL::coplanar(at(a[0]), at(a[1]), at(a[2]), at(b[2])) &&
        CGAL::coplanar_orientation(at(a[0]), at(a[1]), at(a[2]), at(b[2])) == CGAL::POSITIVE;
    default:
      return true;
  }
}

std::size_t PairsOfSoup(const Soup& soup)
{
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::size_t>;
  std::vector<Box> boxes;
  boxes.reserve(soup.Triangles.size());
  for (std::size_t t = 0; t < soup.Triangles.size(); ++t)
  {
    const auto& corners = soup.Triangles[t];
    boxes.emplace_back(soup.Points[corners[0]].bbox() + soup.Points[corners[1]].bbox() +
        soup.Points[corners[2]].bbox(),
      t);
  }
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(),
    [&](const Box& a, const Box& b)
    {
      if (MeetBeyondShared(soup, soup.Triangles[a.info()], soup.Triangles[b.info()]))
      {
        pairs.emplace_back(a.info(), b.info());
      }
    });
  return pairs.size();
}
} // namespace

Detection DetectionByCgal(const FacetComplex& surface)
{
  const auto soup = std::make_shared<Soup>(ToSoup(surface));
  if (!PMP::is_polygon_soup_a_polygon_mesh(soup->Triangles))
  {
    return { "box_self_intersection_d", [soup] { return PairsOfSoup(*soup); } };
  }
  const auto mesh = std::make_shared<Mesh>();
  PMP::polygon_soup_to_polygon_mesh(soup->Points, soup->Triangles, *mesh);
  return { "PMP::self_intersections", [mesh] { return PairsOfMesh(*mesh); } };
}
} // namespace benchmark
