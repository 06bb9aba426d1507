// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlanarSubdivision.h"

#include "TrianglePredicates.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <numeric>

namespace insideout
{
namespace
{
/** The index of a vertex or piece; unlike a bare Id it begins as None. */
struct Index
{
  Id Value = None;
};

using PlanarPoint = ExactKernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, ExactKernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Index, ExactKernel,
  CGAL::Constrained_triangulation_face_base_2<ExactKernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<ExactKernel,
  CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Triangulation::Vertex_handle;
using FaceHandle = Triangulation::Face_handle;
using Corners = std::array<VertexHandle, 3>;

/** A segment between two vertices, with a box that surely contains it. */
struct Constraint
{
  VertexHandle First;
  VertexHandle Last;
  CGAL::Bbox_2 Box;
};

class Subdivider
{
public:
  explicit Subdivider(int axis)
    : Axis(axis)
  {
  }

  void AddTriangle(const std::array<Point, 3>& triangle);
  void AddSegment(const ExactSegment& segment);
  PlanarSubdivision Subdivide();

private:
  VertexHandle AddPoint(const ExactPoint& point);
  void AddConstraint(VertexHandle first, VertexHandle last);
  void AddCrossings();
  void AddCrossing(const Constraint& a, const Constraint& b);
  void FindPieces();
  FaceHandle FirstFaceInside(const Corners& triangle) const;
  void AddSource(FaceHandle face, const PieceSource& source);

  const int Axis;
  Triangulation Cells;
  std::vector<ExactPoint> Points; ///< by index of the vertex
  std::vector<Corners> Triangles;
  std::vector<Constraint> Constraints;
  PlanarSubdivision Result;
};

PlanarPoint ProjectExact(const ExactPoint& point, int axis)
{
  return { point[(axis + 1) % 3], point[(axis + 2) % 3] };
}

/** Twice the signed area of a triangle. */
ExactNumber Area(const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c)
{
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

CGAL::Orientation Orientation(const Corners& triangle)
{
  return CGAL::orientation(triangle[0]->point(), triangle[1]->point(), triangle[2]->point());
}

/** Whether a face, which no edge of the triangle cuts, lies in the triangle. Its centroid is on no
 * edge, so that the filter nearly always decides. */
bool IsInside(FaceHandle face, const Corners& triangle, CGAL::Orientation orientation)
{
  const PlanarPoint centroid =
    CGAL::centroid(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
  for (int k = 0; k < 3; ++k)
  {
    if (CGAL::orientation(triangle[k]->point(), triangle[(k + 1) % 3]->point(), centroid) !=
      orientation)
    {
      return false;
    }
  }
  return true;
}

VertexHandle Subdivider::AddPoint(const ExactPoint& point)
{
  const VertexHandle vertex = this->Cells.insert(ProjectExact(point, this->Axis));
  if (vertex->info().Value == None)
  {
    vertex->info().Value = static_cast<Id>(this->Points.size());
    this->Points.push_back(point);
  }
  return vertex;
}

void Subdivider::AddConstraint(VertexHandle first, VertexHandle last)
{
  if (first != last)
  {
    this->Constraints.push_back({ first, last, first->point().bbox() + last->point().bbox() });
  }
}

void Subdivider::AddTriangle(const std::array<Point, 3>& triangle)
{
  Corners corners;
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = this->AddPoint(ToExact(triangle[k]));
  }
  for (int k = 0; k < 3; ++k)
  {
    this->AddConstraint(corners[k], corners[(k + 1) % 3]);
  }
  this->Triangles.push_back(corners);
}

void Subdivider::AddSegment(const ExactSegment& segment)
{
  const VertexHandle first = this->AddPoint(segment.First);
  this->AddConstraint(first, this->AddPoint(segment.Last));
}

/**
 * Adds the points where two constraints cross in their interiors. Computed from the constraints as
 * they were given and not from parts of them, which keeps the numbers short. After that the
 * triangulation need not construct a point any more: it splits constraints at vertices by itself.
 */
void Subdivider::AddCrossings()
{
  std::vector<const Constraint*> byLow;
  for (const Constraint& constraint : this->Constraints)
  {
    byLow.push_back(&constraint);
  }
  std::stable_sort(byLow.begin(), byLow.end(),
    [](const Constraint* a, const Constraint* b) { return a->Box.xmin() < b->Box.xmin(); });
  for (std::size_t i = 0; i < byLow.size(); ++i)
  {
    for (std::size_t j = i + 1; j < byLow.size() && byLow[j]->Box.xmin() <= byLow[i]->Box.xmax();
         ++j)
    {
      if (CGAL::do_overlap(byLow[i]->Box, byLow[j]->Box))
      {
        this->AddCrossing(*byLow[i], *byLow[j]);
      }
    }
  }
}

void Subdivider::AddCrossing(const Constraint& a, const Constraint& b)
{
  if (a.First == b.First || a.First == b.Last || a.Last == b.First || a.Last == b.Last)
  {
    return;
  }
  const PlanarPoint& p = a.First->point();
  const PlanarPoint& q = a.Last->point();
  const PlanarPoint& r = b.First->point();
  const PlanarPoint& s = b.Last->point();
  if (CGAL::orientation(r, s, p) * CGAL::orientation(r, s, q) < 0 &&
    CGAL::orientation(p, q, r) * CGAL::orientation(p, q, s) < 0)
  {
    this->AddPoint(ZeroBetween(this->Points[a.First->info().Value], Area(r, s, p),
      this->Points[a.Last->info().Value], Area(r, s, q)));
  }
}

FaceHandle Subdivider::FirstFaceInside(const Corners& triangle) const
{
  const CGAL::Orientation orientation = Orientation(triangle);
  Triangulation::Face_circulator face = this->Cells.incident_faces(triangle[0]);
  while (this->Cells.is_infinite(face) || !IsInside(face, triangle, orientation))
  {
    ++face;
  }
  return face;
}

void Subdivider::AddSource(FaceHandle face, const PieceSource& source)
{
  Id& piece = face->info().Value;
  if (piece == None)
  {
    piece = static_cast<Id>(this->Result.Pieces.size());
    Triangle corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = face->vertex(k)->info().Value;
    }
    this->Result.Pieces.push_back({ corners, {} });
  }
  this->Result.Pieces[piece].Sources.push_back(source);
}

/** Spreads over each triangle from a face at its first corner. */
void Subdivider::FindPieces()
{
  std::vector<FaceHandle> front;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Corners& triangle = this->Triangles[t];
    const CGAL::Orientation orientation = Orientation(triangle);
    const PieceSource source{ static_cast<Id>(t), orientation == CGAL::CLOCKWISE };
    const auto isTaken = [&](FaceHandle face)
    {
      return face->info().Value != None &&
        this->Result.Pieces[face->info().Value].Sources.back().Facet == source.Facet;
    };
    front.push_back(this->FirstFaceInside(triangle));
    this->AddSource(front.back(), source);
    while (!front.empty())
    {
      const FaceHandle face = front.back();
      front.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const FaceHandle neighbor = face->neighbor(k);
        if (!this->Cells.is_infinite(neighbor) && !isTaken(neighbor) &&
          IsInside(neighbor, triangle, orientation))
        {
          this->AddSource(neighbor, source);
          front.push_back(neighbor);
        }
      }
    }
  }
}

PlanarSubdivision Subdivider::Subdivide()
{
  this->AddCrossings();
  for (const Constraint& constraint : this->Constraints)
  {
    this->Cells.insert_constraint(constraint.First, constraint.Last);
  }
  this->FindPieces();
  for (Piece& piece : this->Result.Pieces)
  {
    if (piece.Sources[0].Reversed)
    {
      std::swap(piece.Corners[1], piece.Corners[2]);
      for (PieceSource& source : piece.Sources)
      {
        source.Reversed = !source.Reversed;
      }
    }
  }
  for (const ExactPoint& point : this->Points)
  {
    this->Result.Points.push_back(Nearest(point));
  }
  return std::move(this->Result);
}

int AxisOf(const std::array<Point, 3>& triangle)
{
  const std::vector<FilteredPoint> corners = ToFiltered({ triangle[0], triangle[1], triangle[2] });
  return ProjectionAxis({ corners[0], corners[1], corners[2] });
}
} // namespace

PlanarSubdivision SubdividePlane(
  const std::vector<std::array<Point, 3>>& triangles, const std::vector<ExactSegment>& segments)
{
  Subdivider subdivider(AxisOf(triangles[0]));
  for (const std::array<Point, 3>& triangle : triangles)
  {
    subdivider.AddTriangle(triangle);
  }
  for (const ExactSegment& segment : segments)
  {
    subdivider.AddSegment(segment);
  }
  return subdivider.Subdivide();
}
} // namespace insideout
