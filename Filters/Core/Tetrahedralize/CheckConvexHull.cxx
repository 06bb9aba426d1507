// SPDX-License-Identifier: GPL-3.0-or-later
#include "Tetrahedralize/CheckConvexHull.h"

#include "Common/Error.h"
#include "Common/Kernel.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace insideout
{
namespace
{
/** How far rounding may move a Steiner point off the hull, relative to the mesh's size. */
constexpr double LargestDent = 1e-12;

[[noreturn]] void ThrowInconsistent(const std::string& what)
{
  throw Error(ErrorCode::Inconsistent, "the mesh is inconsistent: its hull " + what);
}

std::string Name(Id a, Id b)
{
  return "edge " + std::to_string(a) + " " + std::to_string(b);
}

/** A face's edge on the hull, in the face's direction, and the face's third point. */
struct HullEdge
{
  Id From;
  Id To;
  Id Apex;

  bool operator<(const HullEdge& other) const
  {
    return std::tie(this->From, this->To) < std::tie(other.From, other.To);
  }
};

/** The hull's edges, sorted, each in both directions. */
std::vector<HullEdge> CollectEdges(const TetrahedralMesh& mesh)
{
  std::vector<HullEdge> edges;
  for (std::size_t c = 0; c < mesh.Cells.size(); ++c)
  {
    for (int k = 0; k < 4; ++k)
    {
      if (mesh.Neighbors[c][k] == None)
      {
        const std::array<int, 3>& corners = TetrahedronFaces[k];
        for (int i = 0; i < 3; ++i)
        {
          edges.push_back({ mesh.Cells[c][corners[i]], mesh.Cells[c][corners[(i + 1) % 3]],
            mesh.Cells[c][corners[(i + 2) % 3]] });
        }
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

class Hull
{
public:
  Hull(const TetrahedralMesh& mesh, std::size_t inputPoints)
    : Mesh(mesh)
    , FirstSteinerPoint(static_cast<Id>(inputPoints))
    , Edges(CollectEdges(mesh))
  {
    double size = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto ends = std::minmax_element(mesh.Points.begin(), mesh.Points.end(),
        [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
      size = std::max(size, (*ends.second)[axis] - (*ends.first)[axis]);
    }
    this->Tolerance = LargestDent * size;
  }

  void Check() const
  {
    this->CheckEdges();
    const std::size_t points = this->CheckPoints();
    if (2 * points != this->Edges.size() / 3 + 4)
    {
      ThrowInconsistent("is no sphere: " + std::to_string(points) + " points and " +
        std::to_string(this->Edges.size() / 3) + " faces");
    }
  }

private:
  using Iterator = std::vector<HullEdge>::const_iterator;

  Iterator Find(Id from, Id to) const
  {
    const auto found =
      std::lower_bound(this->Edges.begin(), this->Edges.end(), HullEdge{ from, to, None });
    if (found == this->Edges.end() || found->From != from || found->To != to)
    {
      ThrowInconsistent("is open at " + Name(from, to));
    }
    return found;
  }

  void CheckEdges() const
  {
    const auto twice = std::adjacent_find(this->Edges.begin(), this->Edges.end(),
      [](const HullEdge& a, const HullEdge& b) { return a.From == b.From && a.To == b.To; });
    if (twice != this->Edges.end())
    {
      ThrowInconsistent("touches itself at " + Name(twice->From, twice->To));
    }
    for (const HullEdge& edge : this->Edges)
    {
      const Id across = this->Find(edge.To, edge.From)->Apex;
      if (edge.From < edge.To && !this->IsConvex(edge.From, edge.To, edge.Apex, across))
      {
        ThrowInconsistent("is not convex at " + Name(edge.From, edge.To));
      }
    }
  }

  /** Check that each point has one ring of faces that winds once. A ring's last face is the one
   * that is last in lexicographic order.
   * @return the number of rings
   */
  std::size_t CheckPoints() const
  {
    std::size_t points = 0;
    std::size_t peaks = 0;
    for (auto first = this->Edges.begin(); first != this->Edges.end(); ++points)
    {
      const Id point = first->From;
      const auto last = std::find_if(
        first, this->Edges.end(), [point](const HullEdge& edge) { return edge.From != point; });
      const std::vector<Id> ring = this->Ring(first);
      if (ring.size() != static_cast<std::size_t>(last - first))
      {
        ThrowInconsistent("touches itself at point " + std::to_string(point));
      }
      if (std::all_of(ring.begin(), ring.end(),
            [&](Id p) { return this->Mesh.Points[p] < this->Mesh.Points[point]; }))
      {
        ++peaks;
        this->CheckThatRingGoesRoundOnce(point, ring);
      }
      first = last;
    }
    if (peaks != 1)
    {
      ThrowInconsistent("has " + std::to_string(peaks) + " peaks");
    }
    return points;
  }

  /** The link of the edge's first point, counter-clockwise seen from outside. */
  std::vector<Id> Ring(Iterator first) const
  {
    std::vector<Id> ring;
    for (Iterator at = first; ring.empty() || at != first; at = this->Find(at->From, at->Apex))
    {
      ring.push_back(at->To);
    }
    return ring;
  }

  /** Whether the ring, seen from its first point, turns one way and at most once. */
  void CheckThatRingGoesRoundOnce(Id point, const std::vector<Id>& ring) const
  {
    for (std::size_t i = 2; i < ring.size(); ++i)
    {
      if (!this->IsBelow(point, ring[0], ring[1], ring[i]) ||
        !this->IsBelow(point, ring[0], ring[i - 1], ring[i]))
      {
        ThrowInconsistent("winds around point " + std::to_string(point));
      }
    }
  }

  /**
   * For the faces a b c and b a d: whether d is not above the first and, if level with it, not on
   * it.
   */
  bool IsConvex(Id a, Id b, Id c, Id d) const
  {
    if (this->Side(a, b, c, d) != CGAL::COPLANAR)
    {
      return this->IsBelow(a, b, c, d);
    }
    return CGAL::coplanar_orientation(this->At(a), this->At(b), this->At(c), this->At(d)) ==
      CGAL::NEGATIVE;
  }

  bool IsBelow(Id a, Id b, Id c, Id d) const
  {
    return this->Side(a, b, c, d) != CGAL::POSITIVE ||
      (std::max({ a, b, c, d }) >= this->FirstSteinerPoint && this->IsFlat(a, b, c, d));
  }

  CGAL::Orientation Side(Id a, Id b, Id c, Id d) const
  {
    return CGAL::orientation(this->At(a), this->At(b), this->At(c), this->At(d));
  }

  /**
   * Whether a corner of the tetrahedron is so close to the opposite face that rounding may have
   * moved it there.
   */
  bool IsFlat(Id a, Id b, Id c, Id d) const
  {
    const Kernel::Vector_3 u = this->At(b) - this->At(a);
    const Kernel::Vector_3 v = this->At(c) - this->At(a);
    const Kernel::Vector_3 w = this->At(d) - this->At(a);
    const double volume = CGAL::to_double(CGAL::determinant(u, v, w));
    double area = 0;
    for (const Kernel::Vector_3& normal : { CGAL::cross_product(u, v), CGAL::cross_product(v, w),
           CGAL::cross_product(w, u), CGAL::cross_product(v - u, w - u) })
    {
      area = std::max(area, std::sqrt(normal.squared_length()));
    }
    return std::abs(volume) <= this->Tolerance * area;
  }

  FilteredPoint At(Id p) const { return ToFiltered(this->Mesh.Points[p]); }

  const TetrahedralMesh& Mesh;
  const Id FirstSteinerPoint;
  const std::vector<HullEdge> Edges;
  double Tolerance;
};
} // namespace

void CheckConvexHull(const TetrahedralMesh& mesh, std::size_t inputPoints)
{
  Hull(mesh, inputPoints).Check();
}
} // namespace insideout
