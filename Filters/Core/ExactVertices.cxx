// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactVertices.h"

#include <cmath>

namespace insideout
{
namespace
{
/** What a predicate that intervals do not decide takes, in units of one that doubles do. */
constexpr std::int64_t WorkOfExactPredicate = 100;
} // namespace

ExactVertices::ExactVertices(const std::vector<Point>& points)
{
  this->Places.reserve(points.size() + 1);
  for (const Point& point : points)
  {
    this->Add(point);
  }
}

Id ExactVertices::Add(const Point& point)
{
  this->Places.emplace_back(point[0], point[1], point[2]);
  this->ExactOf.push_back(None);
  return this->Size() - 1;
}

Id ExactVertices::AddBetween(Id first, Id second, const DyadicNumber& a, const DyadicNumber& b)
{
  const std::array<DyadicNumber, 4> from = this->CoordinatesOf(first);
  const std::array<DyadicNumber, 4> to = this->CoordinatesOf(second);
  Homogeneous point;
  for (int k = 0; k < 4; ++k)
  {
    point.Coordinates[k] = a * from[k] + b * to[k];
  }
  const DyadicNumber zero(0);
  if (point.Coordinates[3] < zero)
  {
    for (DyadicNumber& x : point.Coordinates)
    {
      x = zero - x;
    }
  }

  Point nearest;
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    const Interval w(CGAL::to_interval(point.Coordinates[3]));
    for (int k = 0; k < 3; ++k)
    {
      point.Box[k] = Interval(CGAL::to_interval(point.Coordinates[k])) / w;
    }
  }
  bool isDouble = true;
  for (int k = 0; k < 3; ++k)
  {
    nearest[k] = 0.5 * point.Box[k].inf() + 0.5 * point.Box[k].sup();
    // The box of a double has it inside, but not always in the middle.
    for (const double x : { nearest[k], point.Box[k].inf(), point.Box[k].sup() })
    {
      if (std::isfinite(x) && DyadicNumber(x) * point.Coordinates[3] == point.Coordinates[k])
      {
        nearest[k] = x;
      }
    }
    isDouble = isDouble && std::isfinite(nearest[k]) &&
      DyadicNumber(nearest[k]) * point.Coordinates[3] == point.Coordinates[k];
  }
  const Id vertex = this->Add(nearest);
  if (!isDouble)
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
}

std::array<DyadicNumber, 4> ExactVertices::CoordinatesOf(Id vertex) const
{
  if (this->ExactOf[vertex] != None)
  {
    return this->ExactPoints[this->ExactOf[vertex]].Coordinates;
  }
  const Kernel::Point_3& p = this->Places[vertex];
  return { { DyadicNumber(p.x()), DyadicNumber(p.y()), DyadicNumber(p.z()), DyadicNumber(1) } };
}

std::array<ExactVertices::Interval, 3> ExactVertices::BoxOf(Id vertex) const
{
  if (this->ExactOf[vertex] != None)
  {
    return this->ExactPoints[this->ExactOf[vertex]].Box;
  }
  const Kernel::Point_3& p = this->Places[vertex];
  return { { Interval(p.x()), Interval(p.y()), Interval(p.z()) } };
}

int ExactVertices::OrientExactly(Id a, Id b, Id c, Id d) const
{
  {
    const CGAL::Protect_FPU_rounding<true> protection;
    const std::array<Interval, 3> origin = this->BoxOf(a);
    std::array<std::array<Interval, 3>, 3> m = { { this->BoxOf(b), this->BoxOf(c),
      this->BoxOf(d) } };
    for (auto& row : m)
    {
      for (int k = 0; k < 3; ++k)
      {
        row[k] -= origin[k];
      }
    }
    const Interval volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
      m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
      m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    if (volume.inf() > 0)
    {
      return 1;
    }
    if (volume.sup() < 0)
    {
      return -1;
    }
  }
  this->WorkDone += WorkOfExactPredicate;
  return this->Determinant(a, b, c, d).sign();
}

DyadicNumber ExactVertices::Determinant(Id a, Id b, Id c, Id d) const
{
  const std::array<std::array<DyadicNumber, 4>, 4> m = { { this->CoordinatesOf(a),
    this->CoordinatesOf(b), this->CoordinatesOf(c), this->CoordinatesOf(d) } };
  // Laplace's expansion by the minors of the first two rows and of the last two.
  const auto minor = [&m](int row, int i, int j) -> DyadicNumber
  { return m[row][i] * m[row + 1][j] - m[row][j] * m[row + 1][i]; };
  // The rows differ from the volume's by the sign of moving the column of ones to the front.
  return minor(0, 0, 2) * minor(2, 1, 3) - minor(0, 0, 1) * minor(2, 2, 3) -
    minor(0, 0, 3) * minor(2, 1, 2) - minor(0, 1, 2) * minor(2, 0, 3) +
    minor(0, 1, 3) * minor(2, 0, 2) - minor(0, 2, 3) * minor(2, 0, 1);
}

ExactVertices::Plane ExactVertices::PlaneThrough(Id a, Id b, Id c, const Point& origin) const
{
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
  Plane plane;
  for (int k = 0; k < 3; ++k)
  {
    const int y = (k + 1) % 3;
    const int z = (k + 2) % 3;
    plane.Normal[k] = CGAL::to_double(DyadicNumber(
      m[0][3] * minor(1, 2, y, z) + m[1][3] * minor(2, 0, y, z) + m[2][3] * minor(0, 1, y, z)));
  }
  plane.Offset = CGAL::to_double(DyadicNumber(
    m[0][0] * minor(1, 2, 1, 2) + m[0][1] * minor(1, 2, 2, 0) + m[0][2] * minor(1, 2, 0, 1)));
  this->WorkDone += WorkOfExactPredicate;
  return plane;
}

Point ExactVertices::Nearest(Id vertex) const
{
  const Kernel::Point_3& p = this->Places[vertex];
  return { { p.x(), p.y(), p.z() } };
}

void ExactVertices::MoveTo(Id vertex, const Place& place)
{
  this->Places[vertex] = place.Approximate;
  this->ExactOf[vertex] = place.Exact;
}

void ExactVertices::MoveTo(Id vertex, const Point& point)
{
  this->MoveTo(vertex, Place{ Kernel::Point_3(point[0], point[1], point[2]), None });
}
} // namespace insideout
