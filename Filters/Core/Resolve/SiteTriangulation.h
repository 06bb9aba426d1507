// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Resolve/ConstructedPoint.h"

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <vector>

/** CGAL's constrained triangulation, over points that have names instead of coordinates. */
namespace insideout
{
/** A point of the plane and the lines (by index of the constraint) that it is known to lie on. */
struct PlanarSite
{
  PlanarSite(const ConstructedPoint& name, const FacetList& surface, const Point& origin, int axis)
    : Position(name, surface, origin)
    , Range{ { this->Position.Range((axis + 1) % 3), this->Position.Range((axis + 2) % 3) } }
  {
  }

  void PutOn(Id line)
  {
    if (line != None && !this->LiesOn(line))
    {
      this->Lines.push_back(line);
    }
  }

  bool LiesOn(Id line) const
  {
    return std::find(this->Lines.begin(), this->Lines.end(), line) != this->Lines.end();
  }

  LazyPoint Position;
  std::array<std::array<double, 2>, 2> Range; ///< certainly around the point, seen along the axis
  std::vector<Id> Lines;
};

/** Whether three points lie on a line by construction, so that no predicate is needed. */
inline bool ShareALine(const PlanarSite& p, const PlanarSite& q, const PlanarSite& r)
{
  return std::any_of(
    p.Lines.begin(), p.Lines.end(), [&](Id line) { return q.LiesOn(line) && r.LiesOn(line); });
}

/** The triangulation's data of a point, sufficient for exact predicates. */
struct SitePoint
{
  PlanarSite* Where = nullptr;
  int Axis = 0;

  bool operator==(const SitePoint& other) const { return this->Where == other.Where; }
};

inline CGAL::Orientation Orient(const SitePoint& p, const SitePoint& q, const SitePoint& r)
{
  const bool known = p == q || q == r || p == r || ShareALine(*p.Where, *q.Where, *r.Where);
  return known ? CGAL::COLLINEAR
               : CGAL::enum_cast<CGAL::Orientation>(CGAL::Sign(
                   Orientation(p.Where->Position, q.Where->Position, r.Where->Position, p.Axis)));
}

inline CGAL::Comparison_result CompareAlong(const SitePoint& p, const SitePoint& q, int coordinate)
{
  return p == q ? CGAL::EQUAL
                : CGAL::Comparison_result(
                    Compare(p.Where->Position, q.Where->Position, (p.Axis + coordinate) % 3));
}

/** The predicates that CGAL's triangulations require, for sites. */
struct SiteTraits
{
  using Point_2 = SitePoint;
  struct Segment_2
  {
  };
  struct Triangle_2
  {
  };
  struct Orientation_2
  {
    CGAL::Orientation operator()(const SitePoint& p, const SitePoint& q, const SitePoint& r) const
    {
      return Orient(p, q, r);
    }
  };
  struct Compare_x_2
  {
    CGAL::Comparison_result operator()(const SitePoint& p, const SitePoint& q) const
    {
      return CompareAlong(p, q, 1);
    }
  };
  struct Compare_y_2
  {
    CGAL::Comparison_result operator()(const SitePoint& p, const SitePoint& q) const
    {
      return CompareAlong(p, q, 2);
    }
  };
  struct Construct_point_2
  {
    const SitePoint& operator()(const SitePoint& p) const { return p; }
  };

  Orientation_2 orientation_2_object() const { return {}; }
  Compare_x_2 compare_x_2_object() const { return {}; }
  Compare_y_2 compare_y_2_object() const { return {}; }
  Construct_point_2 construct_point_2_object() const { return {}; }
};

/** The index of a vertex or piece; unlike a plain Id it is None by default. */
struct Index
{
  Id Value = None;
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, SiteTraits>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Index, SiteTraits,
  CGAL::Constrained_triangulation_face_base_2<SiteTraits>>;
using Triangulation = CGAL::Constrained_triangulation_2<SiteTraits,
  CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
} // namespace insideout
