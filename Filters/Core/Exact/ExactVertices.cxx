// SPDX-License-Identifier: GPL-3.0-or-later
#include "Exact/ExactVertices.h"

#include "Common/DoubleDouble.h"
#include "Common/SignOfDeterminant.h"
#include "Mesh/MeshCell.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
/** Work of a predicate that requires exact numbers; the unit is one decided in doubles. */
constexpr std::int64_t WorkOfExactPredicate = 100;

/** The same for one decided in double-doubles. */
constexpr std::int64_t WorkOfDoubleDoubles = 20;

/** Logarithm of the size of the cache of coplanar vertices: 2 MB. */
constexpr int DigitsOfCache = 16;

/** Relative error of a quotient. */
constexpr double ErrorOfQuotient = 0x1p-50;

/**
 * Make w positive, and near enough to 1 to avoid over- and underflow of doubles: exponents of long
 * numbers grow with their digits.
 */
void Normalize(std::array<DyadicNumber, 4>& coordinates)
{
  const auto multiply = [&coordinates](const DyadicNumber& factor)
  {
    for (DyadicNumber& x : coordinates)
    {
      x = factor * x;
    }
  };
  const DyadicNumber large(0x1p64);
  const DyadicNumber small(0x1p-64);
  if (coordinates[3].sign() < 0)
  {
    multiply(DyadicNumber(-1));
  }
  while (coordinates[3] > large)
  {
    multiply(small);
  }
  while (coordinates[3] < small)
  {
    multiply(large);
  }
}

/** x / y in doubles: 0 only if x = 0, and exact if a double represents it. */
double Quotient(const DyadicNumber& x, const DyadicNumber& y)
{
  double low;
  double high;
  {
    const IntervalRounding rounding;
    const Interval quotient = Interval(CGAL::to_interval(x)) / Interval(CGAL::to_interval(y));
    low = quotient.inf();
    high = quotient.sup();
  }
  const double middle = 0.5 * low + 0.5 * high;
  for (const double candidate : { middle, low, high })
  {
    if (std::isfinite(candidate) && DyadicNumber(candidate) * y == x)
    {
      return candidate;
    }
  }
  // The sizes are near the limits of doubles.
  if (!std::isfinite(middle))
  {
    return std::isfinite(low) ? low : high;
  }
  return middle != 0 ? middle : low != 0 ? low : high;
}

/** Three points are not collinear where the sine of the angle at the first is above this. */
constexpr double LargestSine = 1e-9;

/** A filter in doubles, which may miss collinear points that nearly coincide. */
bool AreNearlyCollinear(const Point& a, const Point& b, const Point& c)
{
  const Eigen::Vector3d u(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  const Eigen::Vector3d v(c[0] - a[0], c[1] - a[1], c[2] - a[2]);
  return u.cross(v).norm() <= LargestSine * u.norm() * v.norm();
}

/**
 * Double-doubles give a normal and an offset to the precision of a double if these exceed this
 * share of the largest products of coordinates.
 */
constexpr double LeastShare = 0x1p-45;
} // namespace

ExactVertices::ExactVertices(const std::vector<Point>& points, WorkBudget& work)
  : Budget(&work)
{
  this->Places.reserve(points.size() + 1);
  this->NameOf.reserve(points.size() + 1);
  for (const Point& point : points)
  {
    this->Add(point);
  }
}

Id ExactVertices::Add(const Point& point)
{
  this->Places.push_back(point);
  this->ExactOf.push_back(None);
  this->NameOf.push_back(++this->LastName);
  return this->Size() - 1;
}

Id ExactVertices::AddBetween(
  Id first, Id second, const DyadicNumber& a, const DyadicNumber& b, const Span& span)
{
  const std::array<DyadicNumber, 4> from = this->CoordinatesOf(first);
  const std::array<DyadicNumber, 4> to = this->CoordinatesOf(second);
  ExactPoint point;
  for (int k = 0; k < 4; ++k)
  {
    point.Coordinates[k] = a * from[k] + b * to[k];
  }
  Normalize(point.Coordinates);
  Point place;
  for (int k = 0; k < 3; ++k)
  {
    place[k] = Quotient(point.Coordinates[k], point.Coordinates[3]);
    const DyadicNumber rest = point.Coordinates[k] - DyadicNumber(place[k]) * point.Coordinates[3];
    point.Beyond[k] = Quotient(rest, point.Coordinates[3]);
  }
  point.Within = span;
  const Id vertex = this->Add(place);
  if (std::any_of(
        point.Beyond.begin(), point.Beyond.end(), [](double beyond) { return beyond != 0; }))
  {
    this->ExactOf[vertex] = static_cast<Id>(this->ExactPoints.size());
    this->ExactPoints.push_back(std::move(point));
  }
  return vertex;
}

void ExactVertices::RemoveLast()
{
  if (this->ExactOf.back() != None)
  {
    this->ExactPoints.pop_back();
  }
  this->ExactOf.pop_back();
  this->Places.pop_back();
  this->NameOf.pop_back();
}

std::array<DyadicNumber, 4> ExactVertices::CoordinatesOf(Id vertex) const
{
  if (this->ExactOf[vertex] != None)
  {
    return this->ExactPoints[this->ExactOf[vertex]].Coordinates;
  }
  const Point& p = this->Places[vertex];
  return { { DyadicNumber(p[0]), DyadicNumber(p[1]), DyadicNumber(p[2]), DyadicNumber(1) } };
}

/** Whether all four corners are in the affine hull of three vertices. */
bool ExactVertices::AreInOnePlane(const Tetrahedron& cell) const
{
  Span span;
  std::size_t size = 0;
  for (const Id vertex : cell)
  {
    const Id exact = this->ExactOf[vertex];
    const Span within =
      exact == None ? Span{ { vertex, vertex, vertex } } : this->ExactPoints[exact].Within;
    for (const Id id : within)
    {
      if (std::find(span.begin(), span.begin() + size, id) == span.begin() + size)
      {
        if (size == span.size())
        {
          return false;
        }
        span[size++] = id;
      }
    }
  }
  return true;
}

/** @param[in] omitted the corner without name, -1 for none */
ExactVertices::Names ExactVertices::NamesOf(const Tetrahedron& cell, int omitted) const
{
  Names names;
  for (int k = 0; k < 4; ++k)
  {
    names[k] = k == omitted ? 0 : this->NameOf[cell[k]];
  }
  std::sort(names.begin(), names.end());
  return names;
}

/** The only entry of the cache for these names, which others may occupy. */
ExactVertices::Names& ExactVertices::EntryOf(const Names& names) const
{
  if (this->Coplanar.empty())
  {
    this->Coplanar.resize(std::size_t(1) << DigitsOfCache, Names());
  }
  std::uint64_t hash = 0;
  for (const std::uint64_t name : names)
  {
    hash = (hash ^ name) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return this->Coplanar[hash >> (64 - DigitsOfCache)];
}

/** Whether the cache has the four vertices, or three of them as collinear ones. */
bool ExactVertices::AreKnownCoplanar(const Tetrahedron& cell) const
{
  for (int omitted = -1; omitted < 4; ++omitted)
  {
    const Names names = this->NamesOf(cell, omitted);
    if (this->EntryOf(names) == names)
    {
      return true;
    }
  }
  return false;
}

bool ExactVertices::AreCollinear(const Triangle& three) const
{
  if (!AreNearlyCollinear(
        this->Nearest(three[0]), this->Nearest(three[1]), this->Nearest(three[2])))
  {
    return false;
  }
  const std::array<std::array<DyadicNumber, 4>, 3> m = { { this->CoordinatesOf(three[0]),
    this->CoordinatesOf(three[1]), this->CoordinatesOf(three[2]) } };
  const auto minor = [&m](int row, int other, int i, int j) -> DyadicNumber
  { return m[row][i] * m[other][j] - m[row][j] * m[other][i]; };
  for (int k = 0; k < 3; ++k) // the projections along the axes
  {
    const int x = (k + 1) % 3;
    const int y = (k + 2) % 3;
    const DyadicNumber area =
      m[0][3] * minor(1, 2, x, y) + m[1][3] * minor(2, 0, x, y) + m[2][3] * minor(0, 1, x, y);
    if (area.sign() != 0)
    {
      return false;
    }
  }
  return true;
}

/** Cache three collinear ones of the vertices, which are coplanar with any other; else all four. */
void ExactVertices::RememberCoplanar(const Tetrahedron& cell) const
{
  int omitted = 3;
  while (omitted >= 0 && !this->AreCollinear(FaceAcross(cell, omitted)))
  {
    --omitted;
  }
  const Names names = this->NamesOf(cell, omitted);
  this->EntryOf(names) = names;
}

int ExactVertices::OrientExactly(const Tetrahedron& cell, WorkBudget& work) const
{
  std::array<Point, 4> places;
  std::array<Point, 4> beyond;
  for (int k = 0; k < 4; ++k)
  {
    places[k] = this->Nearest(cell[k]);
    beyond[k] = this->Beyond(cell[k]);
  }
  Rows<double> rows;
  for (int k = 0; k < 3; ++k)
  {
    rows.Errors[k] = 0;
    for (int row = 0; row < 3; ++row)
    {
      rows.Entries[row][k] = places[row + 1][k] - places[0][k];
      rows.Errors[k] = std::max(rows.Errors[k],
        DoubleEpsilon * std::abs(rows.Entries[row][k]) + std::abs(beyond[row + 1][k]));
    }
    rows.Errors[k] += std::abs(beyond[0][k]);
  }
  int sign = SignOfDeterminant(rows, DoubleEpsilon);
  if (sign != Undecided && sign != 0)
  {
    return sign;
  }
  if (this->AreInOnePlane(cell))
  {
    return 0;
  }
  if (sign == 0) // the limits of work count it as if exact numbers had found it
  {
    work.Spend(WorkOfDoubleDoubles + WorkOfExactPredicate);
    return 0;
  }
  Rows<DoubleDouble> longRows;
  for (int k = 0; k < 3; ++k)
  {
    longRows.Errors[k] = 0;
    for (int row = 0; row < 3; ++row)
    {
      longRows.Entries[row][k] =
        TwoSum(places[row + 1][k], -places[0][k]) + TwoSum(beyond[row + 1][k], -beyond[0][k]);
      longRows.Errors[k] = std::max(longRows.Errors[k],
        DoubleDoubleEpsilon * std::abs(longRows.Entries[row][k].High) +
          ErrorOfQuotient * (std::abs(beyond[row + 1][k]) + std::abs(beyond[0][k])));
    }
  }
  work.Spend(WorkOfDoubleDoubles);
  sign = SignOfDeterminant(longRows, DoubleDoubleEpsilon);
  if (sign != Undecided)
  {
    return sign;
  }
  work.Spend(WorkOfExactPredicate); // whatever the cache holds
  if (this->AreKnownCoplanar(cell))
  {
    return 0;
  }
  sign = this->Determinant(cell[0], cell[1], cell[2], cell[3]).sign();
  if (sign == 0)
  {
    this->RememberCoplanar(cell);
  }
  return sign;
}

DyadicNumber ExactVertices::Determinant(Id a, Id b, Id c, Id d) const
{
  const std::array<std::array<DyadicNumber, 4>, 4> m = { { this->CoordinatesOf(a),
    this->CoordinatesOf(b), this->CoordinatesOf(c), this->CoordinatesOf(d) } };
  // Laplace expansion by the minors of the first two rows and of the last two.
  const auto minor = [&m](int row, int i, int j) -> DyadicNumber
  { return m[row][i] * m[row + 1][j] - m[row][j] * m[row + 1][i]; };
  // Moving the column of ones to the front changes the sign relative to the volume.
  return minor(0, 0, 2) * minor(2, 1, 3) - minor(0, 0, 1) * minor(2, 2, 3) -
    minor(0, 0, 3) * minor(2, 1, 2) - minor(0, 1, 2) * minor(2, 0, 3) +
    minor(0, 1, 3) * minor(2, 0, 2) - minor(0, 2, 3) * minor(2, 0, 1);
}

bool ExactVertices::FindPlane(Id a, Id b, Id c, const Point& origin, Plane& plane) const
{
  using Vector = std::array<DoubleDouble, 3>;
  const auto difference = [this](Id p, const Point& from, const Point& fromBeyond) -> Vector
  {
    const Point place = this->Nearest(p);
    const Point beyond = this->Beyond(p);
    Vector result;
    for (int k = 0; k < 3; ++k)
    {
      result[k] = TwoSum(place[k], -from[k]) + TwoSum(beyond[k], -fromBeyond[k]);
    }
    return result;
  };
  const auto size = [](const Vector& v) {
    return std::max({ std::abs(v[0].High), std::abs(v[1].High), std::abs(v[2].High) });
  };
  const Vector ab = difference(b, this->Nearest(a), this->Beyond(a));
  const Vector ac = difference(c, this->Nearest(a), this->Beyond(a));
  const Point zero = { { 0, 0, 0 } };
  const Vector fromOrigin = difference(a, origin, zero);
  Vector normal;
  for (int k = 0; k < 3; ++k)
  {
    const int y = (k + 1) % 3;
    const int z = (k + 2) % 3;
    normal[k] = ab[y] * ac[z] - ab[z] * ac[y];
    plane.Normal[k] = normal[k].High;
  }
  plane.Offset =
    (normal[0] * fromOrigin[0] + normal[1] * fromOrigin[1] + normal[2] * fromOrigin[2]).High;
  this->Budget->Spend(WorkOfDoubleDoubles);
  // Coordinates, and so their differences, have an error of about 2^-104 of their size.
  const double coordinate = size(difference(a, zero, zero)) + size(ab) + size(ac);
  const double side = std::max(size(ab), size(ac));
  const double ofNormal = coordinate * side;
  const double ofOffset = coordinate * (side * size(fromOrigin) + size(ab) * size(ac));
  return std::min(size(ab) * size(ac), ofOffset) > SmallestSize &&
    std::max(ofNormal, ofOffset) < LargestSize && size(normal) > LeastShare * ofNormal &&
    std::abs(plane.Offset) > LeastShare * ofOffset;
}

ExactVertices::Plane ExactVertices::PlaneThrough(Id a, Id b, Id c, const Point& origin) const
{
  Plane plane;
  if (this->FindPlane(a, b, c, origin, plane))
  {
    return plane;
  }
  std::array<std::array<DyadicNumber, 4>, 3> m = { { this->CoordinatesOf(a), this->CoordinatesOf(b),
    this->CoordinatesOf(c) } };
  for (std::array<DyadicNumber, 4>& row : m)
  {
    for (int k = 0; k < 3; ++k)
    {
      row[k] = row[k] - row[3] * DyadicNumber(origin[k]);
    }
  }
  const auto minor = [&m](int i, int j, int column, int other) -> DyadicNumber
  { return m[i][column] * m[j][other] - m[i][other] * m[j][column]; };
  for (int k = 0; k < 3; ++k)
  {
    const int y = (k + 1) % 3;
    const int z = (k + 2) % 3;
    plane.Normal[k] = CGAL::to_double(DyadicNumber(
      m[0][3] * minor(1, 2, y, z) + m[1][3] * minor(2, 0, y, z) + m[2][3] * minor(0, 1, y, z)));
  }
  plane.Offset = CGAL::to_double(DyadicNumber(
    m[0][0] * minor(1, 2, 1, 2) + m[0][1] * minor(1, 2, 2, 0) + m[0][2] * minor(1, 2, 0, 1)));
  this->Budget->Spend(WorkOfExactPredicate);
  return plane;
}

Point ExactVertices::Beyond(Id vertex) const
{
  const Id exact = this->ExactOf[vertex];
  return exact == None ? Point{ { 0, 0, 0 } } : this->ExactPoints[exact].Beyond;
}

Point ExactVertices::Nearest(Id vertex) const
{
  return this->Places[vertex];
}

void ExactVertices::StartJournal()
{
  this->Past = { true, {}, this->Places.size(), this->ExactPoints.size() };
}

void ExactVertices::GoBack()
{
  for (auto move = this->Past.Moves.rbegin(); move != this->Past.Moves.rend(); ++move)
  {
    this->Places[move->Vertex] = move->Place;
    this->ExactOf[move->Vertex] = move->Exact;
    this->NameOf[move->Vertex] = ++this->LastName;
  }
  this->Places.resize(this->Past.Size);
  this->ExactOf.resize(this->Past.Size);
  this->NameOf.resize(this->Past.Size);
  this->ExactPoints.resize(this->Past.NumberOfExact);
  this->EndJournal();
}

void ExactVertices::MoveTo(Id vertex, const Point& point)
{
  if (this->Past.IsKept)
  {
    this->Past.Moves.push_back({ vertex, this->Places[vertex], this->ExactOf[vertex] });
  }
  this->Places[vertex] = point;
  this->ExactOf[vertex] = None;
  this->NameOf[vertex] = ++this->LastName;
}
} // namespace insideout
