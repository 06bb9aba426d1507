// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

#include <array>
#include <vector>

namespace insideout
{
/**
 * The part of a triangle not known to be near a surface. Triangles of the surface are subtracted
 * one by one; each removes the polygons over or under it, along the triangle's normal, that are
 * near it as a whole. So a triangle can be covered by many triangles, none of which covers all of
 * it, such as needles in its plane.
 */
class UncoveredPart
{
public:
  /** Start with all of a triangle, or nothing if it is too thin to have a normal.
   * @param[in] distance that counts as near
   */
  UncoveredPart(const std::array<Point, 3>& triangle, double distance);

  /** Subtract a triangle of the surface: only points that are near it, up to rounding. */
  void Cover(const std::array<Point, 3>& near);

  bool IsEmpty() const { return this->Parts.empty() && this->HasNormal; }

  /** Whether so large a number of polygons remains that continuing does not pay off. */
  bool IsHopeless() const { return !this->HasNormal || this->Parts.size() > MostParts; }

private:
  static constexpr std::size_t MostParts = 100;

  /** In the plane: two coordinates, and the height above it, which is 0. */
  using Polygon = std::vector<Point>;

  Point ToPlane(const Point& place) const;
  bool CoverPart(const Polygon& part, const std::array<Point, 3>& near, const Box& reach);

  Point Origin;
  std::array<Point, 3> Axes; ///< of length 1; the third is the normal
  bool HasNormal;
  double Near;
  std::vector<Polygon> Parts;  ///< convex
  std::vector<Polygon> Left;   ///< of a part, scratch
  std::array<Polygon, 3> Cuts; ///< scratch
};
} // namespace insideout
