// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"

#include <array>
#include <vector>

namespace insideout
{
/**
 * The part of a triangle that is not known to be near a surface. Triangles of the surface are told
 * one after the other; each takes away what is over or under it, along the triangle's normal, and
 * what is near it as a whole. So a triangle may be found to be near many, none of which is near all
 * of it: amid needles in its plane.
 */
class UncoveredPart
{
public:
  /** All of a triangle, none where it is too thin to have a normal.
   * @param[in] distance that is near */
  UncoveredPart(const std::array<Point, 3>& triangle, double distance);

  /** Take away what is near a triangle of the surface: all of it in truth, but for rounding. */
  void Cover(const std::array<Point, 3>& near);

  bool IsEmpty() const { return this->Parts.empty() && this->HasNormal; }

  /** Whether there is so much to look at that it is not worth its while. */
  bool IsHopeless() const { return !this->HasNormal || this->Parts.size() > MostParts; }

private:
  static constexpr std::size_t MostParts = 100;

  /** In the plane: two coordinates in it, and the height above it, which is 0. */
  using Polygon = std::vector<Point>;

  Point ToPlane(const Point& place) const;
  void CoverPart(const Polygon& part, const std::array<Point, 3>& near, const Box& reach);

  Point Origin;
  std::array<Point, 3> Axes; ///< of length 1; the third is the normal
  bool HasNormal;
  double Near;
  std::vector<Polygon> Parts; ///< convex
  std::vector<Polygon> Left;
};
} // namespace insideout
