// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ChainFacets.h"

#include "Common/ParallelLoop.h"
#include "Common/Vectors.h"
#include "WindingNumber/Pi.h"
#include "WindingNumber/SolidAngle.h"

#include <algorithm>
#include <cmath>

namespace insideout
{
namespace
{
constexpr double NanosecondsPerFacet = 40; // for its plane

/** A point about 1 away from a site, in the direction opposite to another point. */
Point Opposite(const RoundedSite& site, const Point& place)
{
  Vector<long double> d;
  for (int axis = 0; axis < 3; ++axis)
  {
    d[axis] = (static_cast<long double>(place[axis]) - site.High[axis]) - site.Low[axis];
  }
  const long double length = std::sqrt(Dot(d, d));
  Point result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = static_cast<double>(site.High[axis] - d[axis] / length);
  }
  return result;
}
} // namespace

ChainFacets::ChainFacets(
  const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles)
  : NumberOfFacets(static_cast<Id>(triangles.size()))
  , Facets(new Facet[triangles.size()])
{
  ParallelLoop(triangles.size(), NanosecondsPerFacet,
    [&](std::size_t f)
    {
      const std::array<Point, 3> corners = CornersOf(points, triangles[f].Corners);
      this->Facets[f] = { PlaneOfTriangle(corners), corners, triangles[f].Count };
    });
}

int ChainFacets::SideOf(Id facet, const Point& place) const
{
  return SideOfPlane(this->Facets[facet].Plane, this->Facets[facet].Corners, place);
}

bool ChainFacets::MayMeet(Id facet, const Box& box) const
{
  if (!this->BoxOf(facet).Meets(box))
  {
    return false;
  }
  const PlaneOfTriangle& plane = this->Facets[facet].Plane;
  const Point& corner = this->Facets[facet].Corners[0];
  double side = 0;
  double reach = 0;
  double size = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = box.Low[axis] / 2 + box.High[axis] / 2;
    const double half = box.High[axis] / 2 - box.Low[axis] / 2;
    side += plane.Normal[axis] * (centre - corner[axis]);
    reach += std::abs(plane.Normal[axis]) * half;
    size += std::abs(centre - corner[axis]) + half;
  }
  // Coordinates are below 1, so that an absolute error of 2^-50 covers the rounding of the box's.
  return std::abs(side) <= reach + 4 * plane.UndecidedSide * (size + 0x1p-2);
}

bool ChainFacets::CountCrossings(const SidedFacet* first, const SidedFacet* last,
  const PreparedSite& from, const Point& to, std::vector<Id>* touched, double& sum) const
{
  for (const SidedFacet* f = first; f != last; ++f)
  {
    const Facet& facet = this->Facets[f->Facet()];
    const int toSide = f->Side();
    const int fromSide = SideOfPlane(facet.Plane, facet.Corners, from);
    if (fromSide * toSide > 0)
    {
      continue;
    }
    if (fromSide == 0)
    {
      const bool touches = IsInTriangle(facet.Corners, from.Exact);
      if (toSide == 0 || (touches && !touched))
      {
        return false;
      }
      if (touches)
      {
        touched->push_back(f->Facet());
      }
      continue;
    }
    if (toSide == 0)
    {
      if (IsInTriangle(facet.Corners, SiteAt(to)))
      {
        return false;
      }
      continue;
    }
    int least = 2;
    int most = -2;
    for (int k = 0; k < 3 && !(least < 0 && most > 0); ++k)
    {
      const int sign = SignOfDeterminant(from, to, facet.Corners[k], facet.Corners[(k + 1) % 3]);
      least = std::min(least, sign);
      most = std::max(most, sign);
    }
    if (least * most < 0)
    {
      continue;
    }
    if (least * most == 0)
    {
      return false;
    }
    sum += toSide > 0 ? facet.Count : -facet.Count;
  }
  return true;
}

double ChainFacets::AngleOfTouched(
  std::vector<Id> touched, const PreparedSite& site, const Point& towards) const
{
  // A sum of doubles, always in the same order.
  std::sort(touched.begin(), touched.end());
  const Point back = Opposite(site, towards);
  double sum = 0;
  for (const Id f : touched)
  {
    const Facet& facet = this->Facets[f];
    const double sign = this->SideOf(f, towards) < 0 ? 1 : -1;
    int edges = 0;
    double turns = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Point& a = facet.Corners[k];
      const Point& b = facet.Corners[(k + 1) % 3];
      if (!IsOnLine(a, b, site.Exact))
      {
        ++edges;
        const std::complex<double> z = HalfSolidAngle({ back, a, b }, site.Exact);
        turns += sign * std::atan2(std::abs(z.imag()), z.real()) / (2 * Pi);
      }
    }
    if (edges == 3)
    {
      // Within the triangle: half a sphere, regardless of rounding.
      turns = sign / 2;
    }
    sum += facet.Count * turns;
  }
  return sum;
}
} // namespace insideout
