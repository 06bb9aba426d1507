// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/EnclosedTriangles.h"

#include "Common/SortUniquely.h"
#include "Common/SortedTriangle.h"
#include "Common/TrianglePredicates.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cstdlib>
#include <map>

namespace insideout
{
namespace
{
// Limit of pieces of edges and triangles together. An outline that only touches itself has about 4
// per edge; this number takes a second for 50,000 edges.
constexpr std::size_t MostParts = 100000;
constexpr std::size_t MostPartsPerEdge = 20;

// Limit of crossings. An error of drawing or rounding crosses a few edges. With more, the enclosed
// region is not an intended surface, and detours take long.
constexpr int MostDetours = 100;

struct Winding
{
  int Number = 0;
  bool IsKnown = false;
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Id, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<Winding, Kernel,
  CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel,
  CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
  CGAL::No_constraint_intersection_requiring_constructions_tag>;
using VertexHandle = Delaunay::Vertex_handle;
using FaceHandle = Delaunay::Face_handle;

/** The squared distance of r from the line through p and q. */
double SquaredDistance(VertexHandle r, VertexHandle p, VertexHandle q)
{
  const double area = CGAL::area(p->point(), q->point(), r->point());
  return 4 * area * area / CGAL::squared_distance(p->point(), q->point());
}

/**
 * CGAL's triangulation, with edges inserted piece by piece. Cocircular points are distinguished by
 * their coordinates, so that the triangulation is unique.
 */
class OutlineTriangulation : public Delaunay
{
public:
  /** The first piece of the way from a to b. */
  struct Piece
  {
    VertexHandle End;
    bool IsEdge;             ///< next point on the way from a; or else another edge is in the way,
    insideout::Edge Crossed; ///< this one, which is not an edge any more if End is a or b
  };
  Piece Advance(VertexHandle a, VertexHandle b)
  {
    VertexHandle end;
    FaceHandle face;
    int index;
    if (this->includes_edge(a, b, end, face, index))
    {
      this->mark_constraint(face, index);
      return { end, true, {} };
    }
    List_faces faces;
    List_edges left;
    List_edges right;
    if (this->find_intersected_faces(a, b, faces, left, right, end))
    {
      return { end, false, this->Crossed };
    }
    this->triangulate_hole(faces, left, right);
    return { end, true, {} };
  }

protected:
  /**
   * Called if an edge from a to b would cross another one.
   * @return the end, of the four, that is nearest to the line of the other edge, as far as doubles
   * tell
   */
  VertexHandle intersect(FaceHandle face, int index, VertexHandle a, VertexHandle b) override
  {
    VertexHandle low = face->vertex(cw(index));
    VertexHandle high = face->vertex(ccw(index));
    if (low->info() > high->info())
    {
      std::swap(low, high);
    }
    this->Crossed = { { low->info(), high->info() } };
    const std::array<VertexHandle, 4> ends = { low, high, a, b };
    const double distances[4] = { SquaredDistance(low, a, b), SquaredDistance(high, a, b),
      SquaredDistance(a, low, high), SquaredDistance(b, low, high) };
    const auto nearest = std::min_element(distances, distances + 4) - distances;
    if (nearest >= 2)
    {
      this->remove_constrained_edge(face, index);
    }
    return ends[nearest];
  }

private:
  insideout::Edge Crossed = { { None, None } };
};

struct CountedTriangle
{
  Triangle Corners; ///< ascending
  int Count;        ///< negative if they run the other way
};

/** A line with its count. */
struct Way
{
  Id From;
  Id To;
  int Count;
};

class EnclosedArea
{
public:
  EnclosedArea(const std::vector<Point>& points, const std::vector<OutlineEdge>& outline, int axis)
    : Points(points)
    , Outline(outline)
    , Axis(axis)
    , PartsLeft(MostParts + MostPartsPerEdge * outline.size())
  {
  }

  std::optional<EnclosedTriangles> Triangulate();

private:
  void AddPoints();
  void AddEdge(const OutlineEdge& edge);
  void AddWay(const Way& way);
  void GoAround(const Way& way, const OutlineTriangulation::Piece& piece);
  void AddTriangle(Id a, Id b, Id c, int count);
  int CountAlong(VertexHandle from, VertexHandle to) const;
  void FindWindingNumbers();
  bool SpendPart();

  const std::vector<Point>& Points;
  const std::vector<OutlineEdge>& Outline;
  const int Axis;
  std::size_t PartsLeft;
  int DetoursLeft = MostDetours;
  OutlineTriangulation Cells;
  std::vector<Id> SeenAt; ///< the lowest of the points that project to one place
  std::vector<VertexHandle> Vertices;
  std::map<Edge, int> Pieces; ///< the outline's edges, as edges of the triangulation
  std::vector<Way> Ways;      ///< edges still to be inserted
  std::vector<CountedTriangle> Triangles;
  bool IsCrossed = false;
};

bool EnclosedArea::SpendPart()
{
  this->PartsLeft -= this->PartsLeft > 0;
  return this->PartsLeft > 0;
}

/** Points that the outline only passes, as along a bridge, are not needed. */
void EnclosedArea::AddPoints()
{
  std::vector<Id> used;
  for (const OutlineEdge& edge : this->Outline)
  {
    used.insert(used.end(), edge.Ends.begin(), edge.Ends.end());
  }
  SortUniquely(used);
  std::vector<std::pair<ProjectedPoint, Id>> seen;
  seen.reserve(used.size());
  for (const Id point : used)
  {
    seen.emplace_back(Project(ToFiltered(this->Points[point]), this->Axis), point);
  }
  std::sort(seen.begin(), seen.end());
  this->SeenAt.assign(this->Points.size(), None);
  std::size_t count = 0;
  for (const auto& [place, point] : seen)
  {
    if (count == 0 || seen[count - 1].first != place)
    {
      seen[count++] = { place, point };
    }
    this->SeenAt[point] = seen[count - 1].second;
  }
  seen.resize(count);
  this->Cells.insert(seen.begin(), seen.end());
  this->Vertices.resize(this->Points.size());
  for (const VertexHandle vertex : this->Cells.finite_vertex_handles())
  {
    this->Vertices[vertex->info()] = vertex;
  }
}

void EnclosedArea::AddTriangle(Id a, Id b, Id c, int count)
{
  if (a != b && b != c && c != a)
  {
    const SortedTriangle sorted(Triangle{ { a, b, c } });
    this->Triangles.push_back({ sorted.Points, sorted.Turned ? -count : count });
  }
}

/** Insert an edge where it is visible. The upright parts beside all edges cancel. */
void EnclosedArea::AddEdge(const OutlineEdge& edge)
{
  const auto [from, to] = edge.Ends;
  const Id seenFrom = this->SeenAt[from];
  const Id seenTo = this->SeenAt[to];
  this->AddTriangle(from, to, seenTo, edge.Count);
  this->AddTriangle(from, seenTo, seenFrom, edge.Count);
  if (seenFrom != seenTo)
  {
    this->AddWay({ seenFrom, seenTo, edge.Count });
  }
}

/**
 * Insert a line in pieces, or a detour around edges that it would cross; triangles fill the space
 * between the two.
 */
void EnclosedArea::AddWay(const Way& whole)
{
  this->Ways.push_back(whole);
  while (!this->Ways.empty() && this->SpendPart())
  {
    const Way way = this->Ways.back();
    this->Ways.pop_back();
    const auto piece = this->Cells.Advance(this->Vertices[way.From], this->Vertices[way.To]);
    if (!piece.IsEdge)
    {
      this->GoAround(way, piece);
      continue;
    }
    const Id end = piece.End->info();
    this->Pieces[EdgeBetween(way.From, end)] += way.From < end ? way.Count : -way.Count;
    if (end != way.To)
    {
      this->AddTriangle(way.From, way.To, end, way.Count);
      this->Ways.push_back({ end, way.To, way.Count });
    }
  }
}

/** One of two lines that cross takes a detour via an end of the other. */
void EnclosedArea::GoAround(const Way& way, const OutlineTriangulation::Piece& piece)
{
  this->IsCrossed = true;
  if (this->DetoursLeft == 0)
  {
    this->PartsLeft = 0;
    return;
  }
  --this->DetoursLeft;
  const Id end = piece.End->info();
  Way turned = way;
  if (end == way.From || end == way.To)
  {
    const auto crossed = this->Pieces.find(piece.Crossed);
    turned = { piece.Crossed[0], piece.Crossed[1], crossed->second };
    this->Pieces.erase(crossed);
    this->Ways.push_back(way);
  }
  this->AddTriangle(turned.From, turned.To, end, turned.Count);
  this->Ways.push_back({ end, turned.To, turned.Count });
  this->Ways.push_back({ turned.From, end, turned.Count });
}

/** The signed count of the outline along an edge of the triangulation. */
int EnclosedArea::CountAlong(VertexHandle from, VertexHandle to) const
{
  const Edge ends = EdgeBetween(from->info(), to->info());
  const auto piece = this->Pieces.find(ends);
  return piece == this->Pieces.end() ? 0 : from->info() == ends[0] ? piece->second : -piece->second;
}

/** From outside inward: the winding number on the left of an edge exceeds that on its right by this
 * count. */
void EnclosedArea::FindWindingNumbers()
{
  std::vector<FaceHandle> front = { this->Cells.infinite_face() };
  front.back()->info().IsKnown = true;
  while (!front.empty())
  {
    const FaceHandle face = front.back();
    front.pop_back();
    for (int k = 0; k < 3; ++k)
    {
      const FaceHandle neighbor = face->neighbor(k);
      Winding& there = neighbor->info();
      if (!there.IsKnown)
      {
        there.IsKnown = true;
        there.Number = face->info().Number;
        if (face->is_constrained(k))
        {
          there.Number -=
            this->CountAlong(face->vertex(Delaunay::ccw(k)), face->vertex(Delaunay::cw(k)));
        }
        front.push_back(neighbor);
      }
    }
  }
}

std::optional<EnclosedTriangles> EnclosedArea::Triangulate()
{
  this->AddPoints();
  if (this->Cells.dimension() < 2)
  {
    return std::nullopt;
  }
  for (const OutlineEdge& edge : this->Outline)
  {
    this->AddEdge(edge);
  }
  this->FindWindingNumbers();
  for (const FaceHandle face : this->Cells.finite_face_handles())
  {
    this->AddTriangle(face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info(),
      face->info().Number);
  }
  std::sort(this->Triangles.begin(), this->Triangles.end(),
    [](const CountedTriangle& a, const CountedTriangle& b) { return a.Corners < b.Corners; });
  EnclosedTriangles result;
  result.IsCrossed = this->IsCrossed;
  for (std::size_t first = 0, next = 0; first < this->Triangles.size(); first = next)
  {
    const Triangle& corners = this->Triangles[first].Corners;
    int count = 0;
    for (; next < this->Triangles.size() && this->Triangles[next].Corners == corners; ++next)
    {
      count += this->Triangles[next].Count;
    }
    const bool turned = count < 0;
    for (count = std::abs(count); count > 0 && this->SpendPart(); --count)
    {
      result.Triangles.push_back(
        turned ? Triangle{ { corners[0], corners[2], corners[1] } } : corners);
    }
  }
  if (this->PartsLeft == 0)
  {
    return EnclosedTriangles{ {}, true };
  }
  return result;
}
} // namespace

std::optional<EnclosedTriangles> TriangulateEnclosed(
  const std::vector<Point>& points, const std::vector<OutlineEdge>& outline, int axis)
{
  return EnclosedArea(points, outline, axis).Triangulate();
}
} // namespace insideout
