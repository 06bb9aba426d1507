// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/ConstructedPoint.h"

#include "Common/Edge.h"
#include "Common/Vectors.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace insideout
{
namespace
{
/** The vector from q to p, without rounding to doubles. */
template <class Number>
Vector<Number> VectorTo(const Point& p, const Point& q)
{
  return { Number(p[0]) - Number(q[0]), Number(p[1]) - Number(q[1]), Number(p[2]) - Number(q[2]) };
}

/** The points x with Normal * x = Offset. */
template <class Number>
struct Plane
{
  Vector<Number> Normal;
  Number Offset;

  Number Height(const Vector<Number>& x) const { return Dot(this->Normal, x) - this->Offset; }
};

/** Evaluates constructions in one number type, relative to an origin. */
template <class Number>
class Evaluator
{
public:
  Evaluator(const FacetList& surface, const Point& origin)
    : Surface(surface)
    , Origin(origin)
  {
  }

  Homogeneous<Number> operator()(const ConstructedPoint& p) const
  {
    switch (p.Kind)
    {
      case ConstructedPoint::Type::EdgeOnFacet:
        return this->OnEdge(p.Ids[0], p.Ids[1], this->PlaneOf(p.Ids[2]));
      case ConstructedPoint::Type::TwoEdges:
        return this->OnEdge(p.Ids[0], p.Ids[1], this->PlaneAlong(p.Ids[2], p.Ids[3], p.Axis));
      case ConstructedPoint::Type::ThreeFacets:
        return Meet(this->PlaneOf(p.Ids[0]), this->PlaneOf(p.Ids[1]), this->PlaneOf(p.Ids[2]));
      default:
        return { this->Position(p.Ids[0]), Number(1) };
    }
  }

private:
  Vector<Number> Position(Id point) const
  {
    return VectorTo<Number>(this->Surface.Points[point], this->Origin);
  }

  Plane<Number> PlaneOf(Id facet) const
  {
    const Triangle& corners = this->Surface.Facets[facet];
    const Point& a = this->Surface.Points[corners[0]];
    const Vector<Number> normal = Cross(VectorTo<Number>(this->Surface.Points[corners[1]], a),
      VectorTo<Number>(this->Surface.Points[corners[2]], a));
    return { normal, Dot(normal, this->Position(corners[0])) };
  }

  /** The plane through an edge and along an axis. */
  Plane<Number> PlaneAlong(Id p, Id q, int axis) const
  {
    const Vector<Number> along = VectorTo<Number>(this->Surface.Points[q], this->Surface.Points[p]);
    Vector<Number> normal{ Number(0), Number(0), Number(0) };
    normal[(axis + 1) % 3] = along[(axis + 2) % 3];
    normal[(axis + 2) % 3] = -along[(axis + 1) % 3];
    return { normal, Dot(normal, this->Position(p)) };
  }

  Homogeneous<Number> OnEdge(Id p, Id q, const Plane<Number>& plane) const
  {
    const Vector<Number> first = this->Position(p);
    const Vector<Number> last = this->Position(q);
    const Number a = plane.Height(first);
    const Number b = plane.Height(last);
    return { { last[0] * a - first[0] * b, last[1] * a - first[1] * b, last[2] * a - first[2] * b },
      a - b };
  }

  /** Cramer's rule. */
  static Homogeneous<Number> Meet(
    const Plane<Number>& a, const Plane<Number>& b, const Plane<Number>& c)
  {
    const Vector<Number> bc = Cross(b.Normal, c.Normal);
    const Vector<Number> ca = Cross(c.Normal, a.Normal);
    const Vector<Number> ab = Cross(a.Normal, b.Normal);
    Homogeneous<Number> point;
    for (int k = 0; k < 3; ++k)
    {
      point.X[k] = a.Offset * bc[k] + b.Offset * ca[k] + c.Offset * ab[k];
    }
    point.W = Dot(a.Normal, bc);
    return point;
  }

  const FacetList& Surface;
  const Point& Origin;
};

template <class Number>
void Negate(Homogeneous<Number>& point)
{
  for (Number& x : point.X)
  {
    x = -x;
  }
  point.W = -point.W;
}

/** Bounds of the point with W certainly positive; infinite bounds if the sign of W is unknown. */
Homogeneous<Interval> Bound(
  const ConstructedPoint& name, const FacetList& surface, const Point& origin)
{
  const IntervalRounding rounding;
  Homogeneous<Interval> point = Evaluator<Interval>(surface, origin)(name);
  if (point.W.sup() < 0)
  {
    Negate(point);
  }
  else if (!(point.W.inf() > 0))
  {
    const double infinity = std::numeric_limits<double>::infinity();
    point.X.fill(Interval(-infinity, infinity));
    point.W = Interval(0, infinity);
  }
  return point;
}

Homogeneous<DyadicNumber> EvaluateExactly(
  const ConstructedPoint& name, const FacetList& surface, const Point& origin)
{
  Homogeneous<DyadicNumber> point = Evaluator<DyadicNumber>(surface, origin)(name);
  if (CGAL::sign(point.W) < 0)
  {
    Negate(point);
  }
  return point;
}

/** The sign of an expression of points: in intervals, or exactly if these do not decide. */
template <class Expression, class... Points>
int SignOf(const Expression& expression, const Points&... points)
{
  {
    const IntervalRounding rounding;
    const Interval value = expression(points.Approximate()...);
    if (value.inf() > 0 || value.sup() < 0)
    {
      return value.inf() > 0 ? 1 : -1;
    }
  }
  return CGAL::sign(expression(points.Exact()...));
}
} // namespace

ConstructedPoint ConstructedPoint::Corner(Id point)
{
  ConstructedPoint name;
  name.Ids[0] = point;
  return name;
}

ConstructedPoint ConstructedPoint::EdgeOnFacet(const std::array<Id, 2>& edge, Id facet)
{
  const Edge sorted = EdgeBetween(edge[0], edge[1]);
  return { Type::EdgeOnFacet, None, { { sorted[0], sorted[1], facet, None } } };
}

ConstructedPoint ConstructedPoint::TwoEdges(
  const std::array<Id, 2>& first, const std::array<Id, 2>& second, int axis)
{
  const Edge a = EdgeBetween(first[0], first[1]);
  const Edge b = EdgeBetween(second[0], second[1]);
  const auto& [low, high] = std::minmax(a, b);
  return OnFirstEdge(low, high, axis);
}

ConstructedPoint ConstructedPoint::OnFirstEdge(
  const std::array<Id, 2>& first, const std::array<Id, 2>& second, int axis)
{
  const Edge a = EdgeBetween(first[0], first[1]);
  const Edge b = EdgeBetween(second[0], second[1]);
  return { Type::TwoEdges, static_cast<signed char>(axis), { { a[0], a[1], b[0], b[1] } } };
}

ConstructedPoint ConstructedPoint::ThreeFacets(Id a, Id b, Id c)
{
  std::array<Id, 3> sorted{ { a, b, c } };
  std::sort(sorted.begin(), sorted.end());
  return { Type::ThreeFacets, None, { { sorted[0], sorted[1], sorted[2], None } } };
}

bool ConstructedPoint::operator==(const ConstructedPoint& other) const
{
  return this->Kind == other.Kind && this->Axis == other.Axis && this->Ids == other.Ids;
}

bool ConstructedPoint::operator<(const ConstructedPoint& other) const
{
  return std::tie(this->Kind, this->Axis, this->Ids) < std::tie(other.Kind, other.Axis, other.Ids);
}

double NearestQuotient(const DyadicNumber& a, const DyadicNumber& b)
{
  const mpq_class first(a);
  const mpq_class last(b);
  mpz_class numerator = abs(first.get_num()) * last.get_den();
  mpz_class denominator = abs(last.get_num()) * first.get_den();
  if (numerator == 0)
  {
    return 0;
  }
  // A quotient of 55 or 56 bits whose last bit represents all later ones rounds like the exact one.
  const long shift = 55 - static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) +
    static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  if (shift > 0)
  {
    numerator <<= shift;
  }
  else
  {
    denominator <<= -shift;
  }
  mpz_class quotient;
  mpz_class remainder;
  mpz_tdiv_qr(
    quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
  const std::uint64_t bits = quotient.get_ui() | (remainder != 0 ? 1 : 0);
  const double size = std::ldexp(static_cast<double>(bits), static_cast<int>(-shift));
  return sgn(first) * sgn(last) < 0 ? -size : size;
}

Point Nearest(const ConstructedPoint& name, const FacetList& surface)
{
  if (name.Kind == ConstructedPoint::Type::Corner)
  {
    return surface.Points[name.Ids[0]];
  }
  const Homogeneous<DyadicNumber> point = EvaluateExactly(name, surface, Point{ { 0, 0, 0 } });
  return { NearestQuotient(point.X[0], point.W), NearestQuotient(point.X[1], point.W),
    NearestQuotient(point.X[2], point.W) };
}

LazyPoint::LazyPoint(const ConstructedPoint& name, const FacetList& surface, const Point& origin)
  : What(name)
  , Surface(&surface)
  , Origin(origin)
  , Bounds(Bound(name, surface, origin))
{
}

const Homogeneous<DyadicNumber>& LazyPoint::Exact() const
{
  if (!this->Value)
  {
    this->Value = EvaluateExactly(this->What, *this->Surface, this->Origin);
  }
  return *this->Value;
}

std::array<double, 2> LazyPoint::Range(int coordinate) const
{
  const IntervalRounding rounding;
  const Interval range = this->Bounds.X[coordinate] / this->Bounds.W;
  return { range.inf(), range.sup() };
}

int Compare(const LazyPoint& p, const LazyPoint& q, int coordinate)
{
  return SignOf([coordinate](const auto& a, const auto& b)
    { return a.X[coordinate] * b.W - b.X[coordinate] * a.W; },
    p, q);
}

int Compare(const LazyPoint& p, const LazyPoint& q)
{
  if (p.Name() == q.Name())
  {
    return 0;
  }
  for (int k = 0; k < 2; ++k)
  {
    const int order = Compare(p, q, k);
    if (order != 0)
    {
      return order;
    }
  }
  return Compare(p, q, 2);
}

int Orientation(const LazyPoint& p, const LazyPoint& q, const LazyPoint& r, int axis)
{
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  return SignOf(
    [x, y](const auto& a, const auto& b, const auto& c)
    {
      return a.X[x] * (b.X[y] * c.W - c.X[y] * b.W) - a.X[y] * (b.X[x] * c.W - c.X[x] * b.W) +
        a.W * (b.X[x] * c.X[y] - c.X[x] * b.X[y]);
    },
    p, q, r);
}
} // namespace insideout
