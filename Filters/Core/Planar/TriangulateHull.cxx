// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/TriangulateHull.h"

#include "Common/Buckets.h"
#include "Common/Edge.h"
#include "Common/Error.h"
#include "Common/Kernel.h"
#include "Common/LoopProgress.h"
#include "Common/Stages.h"
#include "Planar/SideOfCircle.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace insideout
{
namespace
{
/** The kernel, with another metric for circles. */
struct MetricTraits : Kernel
{
  struct Side_of_oriented_circle_2
  {
    CGAL::Oriented_side operator()(const Kernel::Point_2& a, const Kernel::Point_2& b,
      const Kernel::Point_2& c, const Kernel::Point_2& d) const
    {
      const auto place = [](const Kernel::Point_2& p) { return PlanarPoint{ p.x(), p.y() }; };
      return static_cast<CGAL::Oriented_side>(this->Circle(place(a), place(b), place(c), place(d)));
    }

    SideOfCircle Circle;
  };

  explicit MetricTraits(const PlanarMetric& metric = PlanarMetric())
    : Circle(metric)
  {
  }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return { this->Circle }; }

  SideOfCircle Circle;
};

template <typename Traits>
class HullTriangulation
{
public:
  HullTriangulation(const SegmentComplex& curve, const Traits& traits, Monitor& monitor)
    : Curve(curve)
    , Watch(monitor)
    , Triangles(traits)
  {
  }

  PlanarMesh Make()
  {
    this->InsertPoints();
    this->InsertSegments();
    return this->Assemble();
  }

private:
  using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Id, Traits>;
  using Faces = CGAL::Constrained_triangulation_face_base_2<Traits,
    CGAL::Triangulation_face_base_with_info_2<Id, Traits>>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
  using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Traits, Structure,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

  void InsertPoints()
  {
    this->Watch.Check(Stages::Triangulating, 0);
    std::vector<std::pair<Kernel::Point_2, Id>> points;
    points.reserve(this->Curve.Points.size());
    for (std::size_t p = 0; p < this->Curve.Points.size(); ++p)
    {
      const PlanarPoint& place = this->Curve.Points[p];
      points.emplace_back(Kernel::Point_2(place[0], place[1]), static_cast<Id>(p));
    }
    this->Triangles.insert(points.begin(), points.end()); // sorts them along a curve first
    if (this->Triangles.dimension() < 2)
    {
      throw Error(
        ErrorCode::AllDegenerate, "all points lie on one line: there is no area to enclose");
    }
  }

  void InsertSegments()
  {
    std::vector<typename Triangulation::Vertex_handle> vertices(this->Curve.Points.size());
    for (auto v = this->Triangles.finite_vertices_begin();
         v != this->Triangles.finite_vertices_end(); ++v)
    {
      vertices[v->info()] = v;
    }
    const LoopProgress progress(
      this->Watch, { Stages::Triangulating, 0.5, 0.8 }, this->Curve.Segments.size());
    for (Id s = 0; s < this->Curve.NumberOfConstraints; ++s)
    {
      progress.Check(static_cast<std::size_t>(s));
      const auto& [from, to] = this->Curve.Segments[s];
      try
      {
        this->Triangles.insert_constraint(vertices[from], vertices[to]);
      }
      catch (const typename Triangulation::Intersection_of_constraints_exception&)
      {
        throw Error(
          ErrorCode::SelfIntersecting, "segment " + std::to_string(s) + " crosses another one");
      }
    }
  }

  PlanarMesh Assemble()
  {
    const Buckets<Id> segments(this->Curve.Points.size(),
      [&](auto visit)
      {
        for (Id s = 0; s < this->Curve.NumberOfConstraints; ++s)
        {
          const auto& [from, to] = this->Curve.Segments[s];
          visit(static_cast<std::size_t>(std::min(from, to)), s);
        }
      });
    PlanarMesh mesh;
    std::size_t found = 0;
    Id count = 0;
    for (auto f = this->Triangles.all_faces_begin(); f != this->Triangles.all_faces_end(); ++f)
    {
      f->info() = this->Triangles.is_infinite(f) ? None : count++;
    }
    mesh.Cells.reserve(count);
    for (auto f = this->Triangles.finite_faces_begin(); f != this->Triangles.finite_faces_end();
         ++f)
    {
      Triangle cell;
      std::array<Id, 3> neighbors;
      std::array<Id, 3> lies{ { None, None, None } };
      std::array<std::int8_t, 3> sides{ { 0, 0, 0 } };
      for (int k = 0; k < 3; ++k)
      {
        cell[k] = f->vertex(k)->info();
      }
      for (int k = 0; k < 3; ++k)
      {
        const int opposite = (k + 2) % 3;
        neighbors[k] = f->neighbor(opposite)->info();
        if (f->is_constrained(opposite))
        {
          const Segment edge = EdgeOf(cell, k);
          lies[k] = this->FindSegment(segments, edge);
          sides[k] = this->Curve.Segments[lies[k]] == edge ? 1 : -1;
          found += neighbors[k] == None || neighbors[k] > mesh.NumberOfCells();
        }
      }
      mesh.Cells.push_back(cell);
      mesh.Neighbors.push_back(neighbors);
      mesh.Segments.push_back(lies);
      mesh.SegmentSides.push_back(sides);
    }
    if (found != static_cast<std::size_t>(this->Curve.NumberOfConstraints))
    {
      throw Error(ErrorCode::SelfIntersecting, "a segment passes through a point of others");
    }
    this->Watch.Check(Stages::Triangulating, 1);
    return mesh;
  }

  Id FindSegment(const Buckets<Id>& segments, const Segment& edge) const
  {
    const Edge ends = EdgeBetween(edge[0], edge[1]);
    for (const Id s : segments[ends[0]])
    {
      if (EdgeBetween(this->Curve.Segments[s][0], this->Curve.Segments[s][1]) == ends)
      {
        return s;
      }
    }
    throw Error(ErrorCode::SelfIntersecting,
      "a segment passes through point " + std::to_string(edge[0]) + " of others");
  }

  const SegmentComplex& Curve;
  Monitor& Watch;
  Triangulation Triangles;
};
} // namespace

PlanarMesh TriangulateHull(
  const SegmentComplex& curve, const PlanarMetric& metric, Monitor& monitor)
{
  return metric.IsPerpendicular()
    ? HullTriangulation<Kernel>(curve, Kernel(), monitor).Make()
    : HullTriangulation<MetricTraits>(curve, MetricTraits(metric), monitor).Make();
}
} // namespace insideout
