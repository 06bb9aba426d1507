// SPDX-License-Identifier: GPL-3.0-or-later
#include "Clouds/CloudWindingNumber.h"

#include "Common/ChunkedLoop.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SpatialOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insideout
{
namespace
{
// Smaller dipoles, near underflow, are left out: they matter only at their own place.
constexpr double LeastSquaredRadius = 1e-180;

// Relative precision of the distance from which a node is far: 2^-10.
constexpr int Halvings = 10;

constexpr int Terms = 3; // the number of terms of FarField

/** A bound of the remainder after three terms, for points within `radius` of a center, at
 * `distance` from it, relative to the sum of their areas over squared distances. */
double MostLeftOut(double thirdMoment, double area, double radius, double distance)
{
  const double t = radius / distance;
  const double share = thirdMoment / (area * distance * distance * distance);
  return share * (4 - 3 * t) * (1 + t) * (1 + t) / ((1 - t) * (1 - t));
}

/** The distance from which that remainder is small: above `least`, which is at least the radius. */
double ReachOf(double thirdMoment, double area, double radius, double least)
{
  const auto isFar = [&](double distance)
  {
    return distance > radius &&
      MostLeftOut(thirdMoment, area, radius, distance) <= CloudWindingNumber::Accuracy;
  };
  double near = least;
  double far = std::max(2 * least, std::numeric_limits<double>::min());
  while (!isFar(far))
  {
    near = far;
    far *= 2;
  }
  for (int i = 0; i < Halvings; ++i)
  {
    const double middle = (near + far) / 2;
    (isFar(middle) ? far : near) = middle;
  }
  return far;
}

/** Scales coordinates and areas to at most 1, so that sums do not overflow. */
int ExponentOf(const PointCloud& cloud)
{
  int exponentOfArea = 0;
  std::frexp(*std::max_element(cloud.Areas.begin(), cloud.Areas.end()), &exponentOfArea);
  const int half = static_cast<int>(std::ceil(exponentOfArea / 2.0));
  return std::max(LargestExponent(cloud.Points), half);
}
} // namespace

/** Sort points so that neighbors in space are near each other. */
std::vector<CloudWindingNumber::Dipole> CloudWindingNumber::DipolesOf(
  const PointCloud& cloud, int exponent)
{
  const std::vector<Point> scaled = ScaledPoints(cloud.Points, -exponent);
  std::vector<Dipole> dipoles;
  for (const Id p : SpatialOrder(scaled))
  {
    const double area = std::ldexp(cloud.Areas[p], -2 * exponent);
    Dipole dipole = { scaled[p], cloud.Normals[p], area / Pi };
    for (double& x : dipole.VectorArea)
    {
      x *= area;
    }
    if (dipole.SquaredRadius > LeastSquaredRadius)
    {
      dipoles.push_back(dipole);
    }
  }
  return dipoles;
}

std::vector<Box> CloudWindingNumber::BoxesOf(const std::vector<Dipole>& dipoles)
{
  std::vector<Box> boxes;
  boxes.reserve(dipoles.size());
  for (const Dipole& dipole : dipoles)
  {
    boxes.push_back({ dipole.Where, dipole.Where });
  }
  return boxes;
}

CloudWindingNumber::CloudWindingNumber(const PointCloud& cloud, bool sums)
  : Exponent(ExponentOf(cloud))
  , Dipoles(DipolesOf(cloud, this->Exponent))
  , Tree(BoxesOf(this->Dipoles))
{
  if (sums)
  {
    return;
  }
  this->Parts.resize(this->Tree.NumberOfParts());
  // Each level of the tree contains each point once.
  const double levels = std::log2(static_cast<double>(this->Parts.size()) + 1);
  const double nanosecondsPerPart = 400 + 100 * levels;
  ParallelLoop(this->Tree.NumberOfParts(), nanosecondsPerPart,
    [&](Id part) { this->Parts[part] = this->FarOf(part); });
}

CloudWindingNumber::Far CloudWindingNumber::FarOf(Id part) const
{
  FarField field;
  double area = 0;
  this->Tree.VisitPart(part,
    [&](Id i)
    {
      const Dipole& dipole = this->Dipoles[i];
      area += Pi * dipole.SquaredRadius;
      for (int axis = 0; axis < 3; ++axis)
      {
        field.Centre[axis] += Pi * dipole.SquaredRadius * dipole.Where[axis];
      }
    });
  for (double& x : field.Centre)
  {
    x /= area;
  }
  double squaredRadius = 0;
  double squaredRadiusOfDipole = 0;
  double thirdMoment = 0;
  this->Tree.VisitPart(part,
    [&](Id i)
    {
      const Dipole& dipole = this->Dipoles[i];
      const Point d = Difference(dipole.Where, field.Centre);
      const double squared = Dot(d, d);
      field.AddDipole(dipole.VectorArea, d);
      squaredRadius = std::max(squaredRadius, squared);
      squaredRadiusOfDipole = std::max(squaredRadiusOfDipole, dipole.SquaredRadius);
      thirdMoment += Pi * dipole.SquaredRadius * squared * std::sqrt(squared);
    });
  const double radius = std::sqrt(squaredRadius);
  const double reach =
    ReachOf(thirdMoment, area, radius, radius + std::sqrt(squaredRadiusOfDipole));
  return { field, reach * reach };
}

/** Call one function for each far node, and the other for each point that is not in such a node. */
template <class VisitFar, class VisitNear>
void CloudWindingNumber::Visit(
  const Point& scaled, const VisitFar& visitFar, const VisitNear& visitNear) const
{
  const auto isNear = [&](Id part)
  {
    if (this->Parts.empty())
    {
      return true;
    }
    const Far& far = this->Parts[part];
    const Point r = Difference(far.Field.Centre, scaled);
    if (Dot(r, r) < far.SquaredReach)
    {
      return true;
    }
    visitFar(far.Field, r);
    return false;
  };
  this->Tree.VisitOpened(isNear,
    [&](Id i)
    {
      const Dipole& dipole = this->Dipoles[i];
      const Point r = Difference(dipole.Where, scaled);
      const double squared = Dot(r, r);
      visitNear(dipole.VectorArea, r, squared, std::max(squared, dipole.SquaredRadius));
    });
}

double CloudWindingNumber::At(const Point& place) const
{
  if (!IsFinite(place))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const Point scaled = ScaledPoints({ place }, -this->Exponent).front();
  double w = 0;
  if (IsNear(scaled))
  {
    this->Visit(
      scaled, [&](const FarField& field, const Point& r) { w += field.At(r, Terms); },
      [&](const Point& n, const Point& r, double, double spread)
      { w += Dot(n, r) / (4 * Pi * spread * std::sqrt(spread)); });
  }
  return w;
}

std::vector<double> CloudWindingNumber::At(
  const std::vector<Point>& places, Monitor& monitor, const ProgressRange& progress) const
{
  std::vector<double> w(places.size());
  const std::vector<Id> order = SpatialOrderOfAny(places);
  const double nanosecondsPerPlace = 5000;
  ChunkedLoop(static_cast<Id>(places.size()), nanosecondsPerPlace, monitor, progress,
    [&](Id i) { w[order[i]] = this->At(places[order[i]]); });
  monitor.Check(progress.Stage, progress.End);
  return w;
}

Point CloudWindingNumber::Gradient(const Point& place) const
{
  Point gradient = { 0, 0, 0 };
  const Point scaled = ScaledPoints({ place }, -this->Exponent).front();
  if (!IsNear(scaled))
  {
    return gradient;
  }
  this->Visit(
    scaled,
    [&](const FarField& field, const Point& r)
    {
      const Point more = field.Gradient(r);
      for (int axis = 0; axis < 3; ++axis)
      {
        gradient[axis] += more[axis];
      }
    },
    [&](const Point& n, const Point& r, double squared, double spread)
    {
      const double inverse3 = 1 / (4 * Pi * spread * std::sqrt(spread));
      // Within the radius the term is linear, and its gradient constant.
      const double along = squared < spread ? 0 : 3 * Dot(n, r) * inverse3 / squared;
      for (int axis = 0; axis < 3; ++axis)
      {
        gradient[axis] += along * r[axis] - n[axis] * inverse3;
      }
    });
  for (double& x : gradient)
  {
    x = std::ldexp(x, -this->Exponent);
  }
  return gradient;
}
} // namespace insideout
