// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Kernel.h"
#include "Common/Numbers.h"

#include <optional>
#include <vector>

/**
 * Points where facets meet: named by the features that meet there, and evaluated in intervals, or
 * exactly if these do not decide.
 */
namespace insideout
{
/** Facets whose points are constructed from. */
struct FacetList
{
  const std::vector<Point>& Points;
  const std::vector<Triangle>& Facets;
};

inline FilteredTriangle CornersOf(const FacetList& surface, Id facet)
{
  return ToFiltered(surface.Points, surface.Facets[facet]);
}

/**
 * A point by its construction. Points with equal names are equal; the reverse need not hold,
 * because an edge may cross two facets at one common point.
 */
struct ConstructedPoint
{
  enum class Type : char
  {
    Corner,      ///< point Ids[0]
    EdgeOnFacet, ///< where the edge from point Ids[0] to Ids[1] meets the plane of facet Ids[2]
    TwoEdges,    ///< on edge Ids[0], Ids[1] where, seen along Axis, edge Ids[2], Ids[3] crosses it
    ThreeFacets  ///< where the planes of facets Ids[0], Ids[1] and Ids[2] meet
  };

  Type Kind = Type::Corner;
  signed char Axis = None;
  std::array<Id, 4> Ids{ { None, None, None, None } };

  static ConstructedPoint Corner(Id point);
  static ConstructedPoint EdgeOnFacet(const std::array<Id, 2>& edge, Id facet);
  static ConstructedPoint TwoEdges(
    const std::array<Id, 2>& first, const std::array<Id, 2>& second, int axis);
  /** The same, on the first edge as it is given. */
  static ConstructedPoint OnFirstEdge(
    const std::array<Id, 2>& first, const std::array<Id, 2>& second, int axis);
  static ConstructedPoint ThreeFacets(Id a, Id b, Id c);

  bool operator==(const ConstructedPoint& other) const;
  bool operator<(const ConstructedPoint& other) const;
};

/**
 * The nearest doubles of the exact point; ties go to the even one. Equal points give equal doubles,
 * whatever their names.
 */
Point Nearest(const ConstructedPoint& point, const FacetList& surface);

/** The double nearest to a / b; ties go to the even one. */
double NearestQuotient(const DyadicNumber& a, const DyadicNumber& b);

/** A point X / W, with W > 0. */
template <class Number>
struct Homogeneous
{
  std::array<Number, 3> X;
  Number W;
};

/**
 * A constructed point with its coordinates relative to an origin: in intervals at once, exactly on
 * demand. Not thread-safe.
 */
class LazyPoint
{
public:
  LazyPoint(const ConstructedPoint& name, const FacetList& surface, const Point& origin);

  const ConstructedPoint& Name() const { return this->What; }
  const Homogeneous<Interval>& Approximate() const { return this->Bounds; }
  const Homogeneous<DyadicNumber>& Exact() const;

  /** An interval that contains the coordinate. */
  std::array<double, 2> Range(int coordinate) const;

private:
  ConstructedPoint What;
  const FacetList* Surface;
  Point Origin;
  Homogeneous<Interval> Bounds;
  mutable std::optional<Homogeneous<DyadicNumber>> Value;
};

/** Orders by one coordinate, exactly: -1, 0 or 1. Both have the same origin. */
int Compare(const LazyPoint& p, const LazyPoint& q, int coordinate);

/** Orders by x, then y, then z, exactly. */
int Compare(const LazyPoint& p, const LazyPoint& q);

/** The side of r seen from p to q, along an axis: 1 left, 0 on the line, -1 right. Exact. */
int Orientation(const LazyPoint& p, const LazyPoint& q, const LazyPoint& r, int axis);
} // namespace insideout
