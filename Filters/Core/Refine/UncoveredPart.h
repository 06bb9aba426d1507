// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"
#include "Common/Types.h"

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

  /** A convex polygon in the triangle's plane. */
  struct Polygon
  {
    /** Nothing is subtracted from a part if cuts might make more corners. */
    static constexpr int MostCorners = 16;

    Polygon() = default;
    Polygon(const Polygon& other) { *this = other; }
    Polygon& operator=(const Polygon& other);
    void Add(const PlanarPoint& corner) { this->Corners[this->Size++] = corner; }
    void FindBox();

    int Size = 0;
    PlanarPoint Low; ///< from FindBox
    PlanarPoint High;
    std::array<PlanarPoint, MostCorners> Corners;
  };
  class NearTriangle;

  Point ToPlane(const Point& place) const;

  Point Origin;
  std::array<Point, 3> Axes; ///< of length 1; the third is the normal
  bool HasNormal;
  double Near;
  double Size = 0; ///< the largest coordinate in the plane
  std::vector<Polygon> Parts;
  std::vector<Polygon> Left; ///< of a part, scratch
};
} // namespace insideout
