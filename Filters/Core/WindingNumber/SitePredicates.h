// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/Sites.h"

namespace insideout
{
/** A site with its place in doubles. */
struct PreparedSite : RoundedSite
{
  explicit PreparedSite(const Site& site)
    : RoundedSite(site)
    , Exact(site)
  {
  }

  Site Exact;
};

/** Decides fast on which side of a triangle a place lies. */
struct PlaneOfTriangle
{
  PlaneOfTriangle() = default;
  explicit PlaneOfTriangle(const std::array<Point, 3>& corners);

  Point Normal;         ///< cross product of the edges from corner 0
  double UndecidedSide; ///< |normal . d| up to this times |d| does not decide the side
};

/**
 * The side of a plane on which a place lies, from the vector that leads from it to corner 0: +1
 * where the normal points to, -1 on the other, 0 if doubles do not decide. Coordinates below 1.
 */
int QuickSide(const PlaneOfTriangle& plane, const Point& toCorner);

/**
 * The side of the triangle's plane on which the site lies: +1 where the normal points to, -1 on the
 * other, 0 in the plane. Exact; doubles decide nearly always. Coordinates below 1.
 */
int SideOfPlane(
  const PlaneOfTriangle& plane, const std::array<Point, 3>& triangle, const PreparedSite& site);
int SideOfPlane(
  const PlaneOfTriangle& plane, const std::array<Point, 3>& triangle, const Point& point);

/**
 * Sign of the determinant of the vectors from the site to a, b and c: the side of the plane through
 * a, b and c on which it lies. Exact; quick for a prepared site, with coordinates below 1.
 */
int SignOfDeterminant(const Site& site, const Point& a, const Point& b, const Point& c);
int SignOfDeterminant(const PreparedSite& site, const Point& a, const Point& b, const Point& c);

/** Whether the site, which lies in the plane of the triangle, lies in the triangle or on its
 * boundary. Exact. */
bool IsInTriangle(const std::array<Point, 3>& triangle, const Site& site);

/** Whether the site, which lies in the triangle, lies on the line through a and b. Exact. */
bool IsOnLine(const Point& a, const Point& b, const Site& site);
} // namespace insideout
