// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Numbers.h"
#include "Common/PointPredicates.h"
#include "Common/Types.h"
#include "Exact/WorkBudget.h"

#include <vector>

namespace insideout
{
/**
 * The vertices of a tetrahedralization under construction: doubles, and Steiner points that lie
 * exactly where two lines or a line and a plane meet. The latter have homogeneous coordinates (x,
 * y, z, w), w > 0, for which sums and products suffice. They also have nearly the same place in
 * doubles and in double-doubles, which decide nearly every predicate.
 */
class ExactVertices
{
public:
  /**
   * Up to three points in doubles whose affine hull contains a vertex, the last one repeated if
   * fewer suffice: for a Steiner point the ends of its segment or the corners of its facet.
   */
  using Span = std::array<Id, 3>;

  /** @param[in] work counts predicates; it has to outlive the vertices */
  ExactVertices(const std::vector<Point>& points, WorkBudget& work);

  /** The work spent on predicates; callers add their other work. */
  WorkBudget& Work() const { return *this->Budget; }

  Id Size() const { return static_cast<Id>(this->Places.size()); }

  /** @return the new vertex */
  Id Add(const Point& point);

  /**
   * Add the point a A + b B, with A and B the homogeneous coordinates of two vertices. It becomes a
   * double if doubles represent it exactly.
   * @param[in] a, b of one sign and not both 0, so that the point lies between the two
   * @param[in] span the affine hull that contains the point, exactly
   */
  Id AddBetween(
    Id first, Id second, const DyadicNumber& a, const DyadicNumber& b, const Span& span);

  /** Forget the last vertex. */
  void RemoveLast();

  /**
   * The sign of the volume of a tetrahedron, exactly; it is positive where a, b, c run
   * counter-clockwise seen from d.
   */
  int Orient(Id a, Id b, Id c, Id d) const { return this->Orient(a, b, c, d, *this->Budget); }

  /** The same, with the work counted elsewhere. */
  int Orient(Id a, Id b, Id c, Id d, WorkBudget& work) const;

  /** A positive multiple of the volume: the product of the four weights w times it. */
  DyadicNumber Determinant(Id a, Id b, Id c, Id d) const;

  /** The points x with Normal . (x - origin) = Offset; Normal has any length. */
  struct Plane
  {
    std::array<double, 3> Normal;
    double Offset;
  };

  /**
   * The plane through three vertices, accurate to a double however close they are. Huge or tiny
   * coordinates may give infinite or undefined numbers. a, b, c run counter-clockwise seen from
   * where Normal points to.
   */
  Plane PlaneThrough(Id a, Id b, Id c, const Point& origin) const;

  bool IsDouble(Id vertex) const { return this->ExactOf[vertex] == None; }

  /** Whether all vertices are doubles: then several threads may ask for signs. */
  bool AreDoubles() const { return this->ExactPoints.empty(); }

  /** The doubles nearest to a vertex, up to a few units in the last place. */
  Point Nearest(Id vertex) const;

  void MoveTo(Id vertex, const Point& point);

  /** Start a journal, with which GoBack restores the present vertices. */
  void StartJournal();
  void EndJournal() { this->Past = Journal(); }
  void GoBack();

  /** Drop the exact coordinates of unused vertices: they are long. */
  template <typename IsInUse>
  void ForgetExactly(const IsInUse& isInUse);

private:
  struct ExactPoint
  {
    std::array<DyadicNumber, 4> Coordinates;
    std::array<double, 3> Beyond; ///< correction of the position in doubles
    Span Within;
  };

  /** The names of four vertices, or 0 and those of three, ascending. */
  using Names = std::array<std::uint64_t, 4>;

  /** The vertices as they were when the journal began. */
  struct Journal
  {
    struct Move
    {
      Id Vertex;
      Point Place;
      Id Exact;
    };
    bool IsKept = false;
    std::vector<Move> Moves; ///< in order, from the start
    std::size_t Size;
    std::size_t NumberOfExact;
  };

  /** The correction of the coordinates in doubles. */
  Point Beyond(Id vertex) const;

  /**
   * PlaneThrough in double-doubles.
   * @return whether their precision suffices
   */
  bool FindPlane(Id a, Id b, Id c, const Point& origin, Plane& plane) const;

  std::array<DyadicNumber, 4> CoordinatesOf(Id vertex) const;
  Names NamesOf(const Tetrahedron& cell, int omitted) const;
  Names& EntryOf(const Names& names) const;
  bool AreKnownCoplanar(const Tetrahedron& cell) const;
  bool AreCollinear(const Triangle& three) const;
  void RememberCoplanar(const Tetrahedron& cell) const;
  bool AreInOnePlane(const Tetrahedron& cell) const;
  int OrientExactly(const Tetrahedron& cell, WorkBudget& work) const;

  std::vector<Point> Places;
  std::vector<Id> ExactOf; ///< into ExactPoints, None for doubles
  std::vector<ExactPoint> ExactPoints;
  std::vector<std::uint64_t> NameOf; ///< per vertex, another one after each change of its place
  std::uint64_t LastName = 0;
  mutable std::vector<Names> Coplanar; ///< cache of what exact numbers found
  WorkBudget* Budget;
  Journal Past;
};

template <typename IsInUse>
void ExactVertices::ForgetExactly(const IsInUse& isInUse)
{
  std::vector<ExactPoint> kept;
  for (Id vertex = 0; vertex < this->Size(); ++vertex)
  {
    Id& exact = this->ExactOf[vertex];
    if (exact != None && isInUse(vertex))
    {
      kept.push_back(std::move(this->ExactPoints[exact]));
      exact = static_cast<Id>(kept.size() - 1);
    }
    else if (exact != None)
    {
      exact = None;
      this->NameOf[vertex] = ++this->LastName;
    }
  }
  this->ExactPoints = std::move(kept);
}

inline int ExactVertices::Orient(Id a, Id b, Id c, Id d, WorkBudget& work) const
{
  work.Spend(1);
  if ((this->ExactOf[a] & this->ExactOf[b] & this->ExactOf[c] & this->ExactOf[d]) == None)
  {
    return Orient3D(this->Places[a], this->Places[b], this->Places[c], this->Places[d]);
  }
  return this->OrientExactly({ { a, b, c, d } }, work);
}
} // namespace insideout
