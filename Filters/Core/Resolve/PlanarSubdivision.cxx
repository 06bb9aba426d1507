// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/PlanarSubdivision.h"

#include "Common/Edge.h"
#include "Common/TrianglePredicates.h"
#include "Resolve/SiteTriangulation.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>

namespace insideout
{
namespace
{
using Corners = std::array<VertexHandle, 3>;

/**
 * Limit of flips: flips to a Delaunay triangulation terminate unless rounded tests contradict each
 * other.
 */
constexpr std::size_t FlipsPerEdge = 20;

/** From this number of vertices on, walks to new ones through slivers dominate the time. */
constexpr std::size_t ManyVertices = 256;

/**
 * Relative rounding error is some 1e-15: points nearly on a circle count as outside, so no edge is
 * flipped back and forth.
 */
constexpr double LeastInCircle = 1e-12;

/** A segment between two vertices: an edge of a facet, or its intersection with another. */
struct Constraint
{
  VertexHandle First;
  VertexHandle Last;
  Id Facet;               ///< None for a segment between corners:
  std::array<Id, 2> Edge; ///< these
  std::array<double, 2> Low;
  std::array<double, 2> High;
  std::multimap<double, VertexHandle> Along; ///< its vertices, by position along WideAxis

  int WideAxis() const
  {
    return this->High[1] - this->Low[1] > this->High[0] - this->Low[0] ? 1 : 0;
  }

  bool BoxMeets(const Constraint& other) const
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
      this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1];
  }
};

class Subdivider
{
public:
  Subdivider(const FacetList& surface, Id host);

  /** The later of two crossing edges gets its crossing on the earlier one. */
  Subdivider(const FacetList& surface, Id host, int axis);

  void AddFacet(Id facet);
  void AddCut(const Cut& cut);
  PlanarSubdivision Subdivide();

private:
  VertexHandle AddPoint(const ConstructedPoint& point, std::initializer_list<Id> lines);
  bool IsKnown(Id line) const
  {
    return line != None && line < static_cast<Id>(this->Constraints.size());
  }
  VertexHandle Insert(PlanarSite& site, std::initializer_list<Id> lines);
  VertexHandle NearestKnown(const PlanarSite& site, std::initializer_list<Id> lines) const;
  void AddConstraint(
    VertexHandle first, VertexHandle last, Id facet, const std::array<Id, 2>& edge);
  Id LineOfEdge(const ConstructedPoint& point) const;
  void AddCrossings();
  void AddCrossing(Id a, Id b);
  ConstructedPoint NameOfCrossing(const Constraint& a, const Constraint& b) const;
  void Smooth(std::vector<Triangulation::Edge> edges);
  void SmoothAll();
  void SmoothAround(VertexHandle vertex);
  bool WantsFlip(FaceHandle face, int index) const;
  void Flip(FaceHandle face, int index);
  void FindPieces();
  FaceHandle FirstFaceInside(const Corners& triangle) const;
  void AddSource(FaceHandle face, const PieceSource& source);

  const FacetList& Surface;
  const Id Host; ///< the facet that defines the plane
  const int Axis;
  const bool PrefersFirst = false;
  Triangulation Cells;
  std::deque<PlanarSite> Sites;
  std::map<ConstructedPoint, VertexHandle> Vertices;
  std::vector<Corners> Triangles;
  std::vector<Id> Facets; ///< one per triangle
  std::vector<Constraint> Constraints;
  std::map<std::array<Id, 2>, Id> Edges; ///< of the facets, by their points, with their constraints
  PlanarSubdivision Result;
};

CGAL::Orientation OrientationOf(const Corners& triangle)
{
  return Orient(triangle[0]->point(), triangle[1]->point(), triangle[2]->point());
}

/** Whether a face, which no edge of the triangle cuts, lies inside the triangle. */
bool IsInside(FaceHandle face, const Corners& triangle, CGAL::Orientation orientation)
{
  for (int k = 0; k < 3; ++k)
  {
    for (int v = 0; v < 3; ++v)
    {
      if (Orient(triangle[k]->point(), triangle[(k + 1) % 3]->point(), face->vertex(v)->point()) ==
        -orientation)
      {
        return false;
      }
    }
  }
  return true;
}

/** The midpoint of a site's bounds. */
std::array<double, 2> Near(const PlanarSite& site)
{
  const auto& range = site.Range;
  return { range[0][0] / 2 + range[0][1] / 2, range[1][0] / 2 + range[1][1] / 2 };
}

std::array<double, 2> Near(VertexHandle vertex)
{
  return Near(*vertex->point().Where);
}

Subdivider::Subdivider(const FacetList& surface, Id host)
  : Surface(surface)
  , Host(host)
  , Axis(ProjectionAxis(CornersOf(surface, host)))
{
}

Subdivider::Subdivider(const FacetList& surface, Id host, int axis)
  : Surface(surface)
  , Host(host)
  , Axis(axis)
  , PrefersFirst(true)
{
}

/** The vertex at a point, which lies on the given lines; some of these may be None. */
VertexHandle Subdivider::AddPoint(const ConstructedPoint& point, std::initializer_list<Id> lines)
{
  VertexHandle vertex;
  const auto known = this->Vertices.find(point);
  if (known != this->Vertices.end())
  {
    vertex = known->second;
  }
  else
  {
    const Point& origin = this->Surface.Points[this->Surface.Facets[this->Host][0]];
    this->Sites.emplace_back(point, this->Surface, origin, this->Axis);
    PlanarSite& site = this->Sites.back();
    for (const Id line : lines)
    {
      site.PutOn(line);
    }
    vertex = this->Insert(site, lines);
    this->Vertices.insert({ point, vertex });
    if (vertex->info().Value == None)
    {
      vertex->info().Value = static_cast<Id>(this->Result.Points.size());
      this->Result.Points.push_back(point);
    }
  }
  for (const Id line : lines)
  {
    vertex->point().Where->PutOn(line);
    if (this->IsKnown(line))
    {
      Constraint& constraint = this->Constraints[line];
      constraint.Along.emplace(Near(vertex)[constraint.WideAxis()], vertex);
    }
  }
  return vertex;
}

/**
 * Insert a site. If there are many vertices, the walk to it begins at a neighbor and passes through
 * smoothed triangles; otherwise it would pass through most of them.
 */
VertexHandle Subdivider::Insert(PlanarSite& site, std::initializer_list<Id> lines)
{
  const SitePoint point{ &site, this->Axis };
  if (this->Vertices.size() < ManyVertices)
  {
    return this->Cells.insert(point);
  }
  if (this->Vertices.size() == ManyVertices)
  {
    this->SmoothAll();
  }
  const VertexHandle start = this->NearestKnown(site, lines);
  const VertexHandle vertex =
    this->Cells.insert(point, start == VertexHandle() ? FaceHandle() : start->face());
  this->SmoothAround(vertex);
  return vertex;
}

/**
 * The vertex on the given lines that is nearest to a site, approximately, or none: the walk from
 * there is short.
 */
VertexHandle Subdivider::NearestKnown(const PlanarSite& site, std::initializer_list<Id> lines) const
{
  const std::array<double, 2> place = Near(site);
  VertexHandle nearest;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](VertexHandle vertex)
  {
    const std::array<double, 2> other = Near(vertex);
    const double x = other[0] - place[0];
    const double y = other[1] - place[1];
    const double distance = x * x + y * y;
    if (distance < least)
    {
      least = distance;
      nearest = vertex;
    }
  };
  for (const Id line : lines)
  {
    if (this->IsKnown(line))
    {
      const Constraint& constraint = this->Constraints[line];
      const auto behind = constraint.Along.lower_bound(place[constraint.WideAxis()]);
      if (behind != constraint.Along.end())
      {
        look(behind->second);
      }
      if (behind != constraint.Along.begin())
      {
        look(std::prev(behind)->second);
      }
    }
  }
  return nearest;
}

/** The facet's edge on which the point lies by its name, None for none. */
Id Subdivider::LineOfEdge(const ConstructedPoint& point) const
{
  if (point.Kind != ConstructedPoint::Type::EdgeOnFacet)
  {
    return None;
  }
  const auto edge = this->Edges.find({ point.Ids[0], point.Ids[1] });
  return edge == this->Edges.end() ? None : edge->second;
}

void Subdivider::AddConstraint(
  VertexHandle first, VertexHandle last, Id facet, const std::array<Id, 2>& edge)
{
  Constraint constraint{ first, last, facet, edge, {}, {}, {} };
  for (int k = 0; k < 2; ++k)
  {
    const std::array<double, 2>& p = first->point().Where->Range[k];
    const std::array<double, 2>& q = last->point().Where->Range[k];
    constraint.Low[k] = std::min(p[0], q[0]);
    constraint.High[k] = std::max(p[1], q[1]);
  }
  for (const VertexHandle end : { first, last })
  {
    constraint.Along.emplace(Near(end)[constraint.WideAxis()], end);
  }
  this->Constraints.push_back(std::move(constraint));
}

void Subdivider::AddFacet(Id facet)
{
  Corners corners;
  const Triangle& ids = this->Surface.Facets[facet];
  for (int k = 0; k < 3; ++k)
  {
    corners[k] = this->AddPoint(ConstructedPoint::Corner(ids[k]), {});
  }
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const Edge edge = EdgeBetween(ids[k], ids[next]);
    const Id line = static_cast<Id>(this->Constraints.size());
    if (this->Edges.insert({ edge, line }).second)
    {
      this->AddConstraint(corners[k], corners[next], None, edge);
      corners[k]->point().Where->PutOn(line);
      corners[next]->point().Where->PutOn(line);
    }
  }
  this->Result.Facets.push_back({ facet, ids,
    { corners[0]->info().Value, corners[1]->info().Value, corners[2]->info().Value } });
  this->Triangles.push_back(corners);
  this->Facets.push_back(facet);
}

void Subdivider::AddCut(const Cut& cut)
{
  const Id line = static_cast<Id>(this->Constraints.size());
  const VertexHandle first = this->AddPoint(cut.First, { line, this->LineOfEdge(cut.First) });
  const VertexHandle last = this->AddPoint(cut.Last, { line, this->LineOfEdge(cut.Last) });
  this->AddConstraint(first, last, cut.Facet, { { cut.First.Ids[0], cut.Last.Ids[0] } });
}

/**
 * Add the points where two constraints cross in their interiors. They are named after the facets
 * and edges that meet, not after their parts, which keeps numbers short. Afterwards the
 * triangulation constructs no points: it splits constraints at existing vertices.
 */
void Subdivider::AddCrossings()
{
  const Id count = static_cast<Id>(this->Constraints.size());
  std::vector<Id> byLow(count);
  std::iota(byLow.begin(), byLow.end(), 0);
  std::stable_sort(byLow.begin(), byLow.end(),
    [&](Id a, Id b) { return this->Constraints[a].Low[0] < this->Constraints[b].Low[0]; });
  for (Id i = 0; i < count; ++i)
  {
    const Constraint& a = this->Constraints[byLow[i]];
    for (Id j = i + 1; j < count && this->Constraints[byLow[j]].Low[0] <= a.High[0]; ++j)
    {
      if (a.BoxMeets(this->Constraints[byLow[j]]))
      {
        this->AddCrossing(byLow[i], byLow[j]);
      }
    }
  }
}

void Subdivider::AddCrossing(Id first, Id last)
{
  const Constraint& a = this->Constraints[first];
  const Constraint& b = this->Constraints[last];
  const SitePoint& p = a.First->point();
  const SitePoint& q = a.Last->point();
  const SitePoint& r = b.First->point();
  const SitePoint& s = b.Last->point();
  if (Orient(r, s, p) * Orient(r, s, q) < 0 && Orient(p, q, r) * Orient(p, q, s) < 0)
  {
    this->AddPoint(
      first < last ? this->NameOfCrossing(a, b) : this->NameOfCrossing(b, a), { first, last });
  }
}

ConstructedPoint Subdivider::NameOfCrossing(const Constraint& a, const Constraint& b) const
{
  if (a.Facet != None && b.Facet != None)
  {
    return ConstructedPoint::ThreeFacets(this->Host, a.Facet, b.Facet);
  }
  if (this->PrefersFirst)
  {
    return ConstructedPoint::OnFirstEdge(a.Edge, b.Edge, this->Axis);
  }
  if (a.Facet == None && b.Facet == None)
  {
    return ConstructedPoint::TwoEdges(a.Edge, b.Edge, this->Axis);
  }
  return a.Facet == None ? ConstructedPoint::EdgeOnFacet(a.Edge, b.Facet)
                         : ConstructedPoint::EdgeOnFacet(b.Edge, a.Facet);
}

/** Whether s lies inside the circle through p, q and r, which run counter-clockwise; in doubles. */
bool SeemsInCircle(const std::array<double, 2>& p, const std::array<double, 2>& q,
  const std::array<double, 2>& r, const std::array<double, 2>& s)
{
  double rows[3][3];
  const std::array<double, 2>* corners[3] = { &p, &q, &r };
  double size = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double x = (*corners[i])[0] - s[0];
    const double y = (*corners[i])[1] - s[1];
    rows[i][0] = x;
    rows[i][1] = y;
    rows[i][2] = x * x + y * y;
  }
  double determinant = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double* a = rows[(i + 1) % 3];
    const double* b = rows[(i + 2) % 3];
    determinant += rows[i][2] * (a[0] * b[1] - a[1] * b[0]);
    size += rows[i][2] * (std::abs(a[0] * b[1]) + std::abs(a[1] * b[0]));
  }
  return determinant > LeastInCircle * size;
}

/** Whether the edge opposite to a face's corner should and can be flipped. */
bool Subdivider::WantsFlip(FaceHandle face, int index) const
{
  const FaceHandle neighbor = face->neighbor(index);
  if (this->Cells.is_infinite(face) || this->Cells.is_infinite(neighbor) ||
    face->is_constrained(index))
  {
    return false;
  }
  const VertexHandle apex = face->vertex(index);
  const VertexHandle left = face->vertex((index + 1) % 3);
  const VertexHandle right = face->vertex((index + 2) % 3);
  const VertexHandle opposite = neighbor->vertex(neighbor->index(face));
  return SeemsInCircle(Near(apex), Near(left), Near(right), Near(opposite)) &&
    Orient(apex->point(), left->point(), opposite->point()) == CGAL::LEFT_TURN &&
    Orient(apex->point(), opposite->point(), right->point()) == CGAL::LEFT_TURN;
}

/** Flip the edge opposite to a face's corner. The outer edges stay constrained or free. */
void Subdivider::Flip(FaceHandle face, int index)
{
  const FaceHandle neighbor = face->neighbor(index);
  this->Cells.flip(face, index);
  for (const FaceHandle& changed : { face, neighbor })
  {
    for (int k = 0; k < 3; ++k)
    {
      const FaceHandle beyond = changed->neighbor(k);
      const bool isInner = beyond == face || beyond == neighbor;
      changed->set_constraint(
        k, !isInner && beyond->is_constrained(this->Cells.mirror_index(changed, k)));
    }
  }
}

/**
 * Flip edges to a Delaunay triangulation. Rounded tests may contradict each other, so the number of
 * flips is limited.
 */
void Subdivider::Smooth(std::vector<Triangulation::Edge> edges)
{
  std::size_t flips = FlipsPerEdge * edges.size();
  while (!edges.empty() && flips > 0)
  {
    const FaceHandle face = edges.back().first;
    const int index = edges.back().second;
    edges.pop_back();
    if (!this->WantsFlip(face, index))
    {
      continue;
    }
    const FaceHandle neighbor = face->neighbor(index);
    this->Flip(face, index);
    --flips;
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace_back(face, k);
      edges.emplace_back(neighbor, k);
    }
  }
}

void Subdivider::SmoothAll()
{
  // CGAL's iterator over edges is unsuitable: its order depends on addresses.
  std::vector<Triangulation::Edge> edges;
  for (const FaceHandle face : this->Cells.finite_face_handles())
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace_back(face, k);
    }
  }
  this->Smooth(std::move(edges));
}

/** Flip edges around a new vertex. */
void Subdivider::SmoothAround(VertexHandle vertex)
{
  if (this->Cells.dimension() < 2)
  {
    return;
  }
  std::vector<Triangulation::Edge> edges;
  Triangulation::Face_circulator face = this->Cells.incident_faces(vertex);
  const Triangulation::Face_circulator first = face;
  do
  {
    edges.emplace_back(face, face->index(vertex));
  } while (++face != first);
  this->Smooth(std::move(edges));
}

FaceHandle Subdivider::FirstFaceInside(const Corners& triangle) const
{
  const CGAL::Orientation orientation = OrientationOf(triangle);
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

/** Flood each triangle from a face at its first corner. */
void Subdivider::FindPieces()
{
  std::vector<FaceHandle> front;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const Corners& triangle = this->Triangles[t];
    const CGAL::Orientation orientation = OrientationOf(triangle);
    const PieceSource source{ this->Facets[t], orientation == CGAL::CLOCKWISE };
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
    if (constraint.First != constraint.Last)
    {
      this->Cells.insert_constraint(constraint.First, constraint.Last);
    }
  }
  this->SmoothAll();
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
  return std::move(this->Result);
}
} // namespace

PlanarSubdivision SubdividePlane(
  const FacetList& surface, const std::vector<Id>& facets, const std::vector<Cut>& cuts)
{
  Subdivider subdivider(surface, facets[0]);
  for (const Id facet : facets)
  {
    subdivider.AddFacet(facet);
  }
  for (const Cut& cut : cuts)
  {
    subdivider.AddCut(cut);
  }
  return subdivider.Subdivide();
}

PlanarSubdivision SubdivideAlong(int axis, const FacetList& surface, const std::vector<Id>& facets)
{
  Subdivider subdivider(surface, facets[0], axis);
  for (const Id facet : facets)
  {
    subdivider.AddFacet(facet);
  }
  return subdivider.Subdivide();
}
} // namespace insideout
