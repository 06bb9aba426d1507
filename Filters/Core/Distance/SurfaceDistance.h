// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

namespace insideout
{
/** Unsigned distances of points from a surface; w decides the side. */
class SurfaceDistance
{
public:
  /** @param[in] facets at least one; points in no facet are not part of the surface */
  SurfaceDistance(const std::vector<Point>& points, const std::vector<Triangle>& facets);

  /** The same for a part of a surface, with coordinates below 2^exponent. */
  SurfaceDistance(
    const std::vector<Point>& points, const std::vector<Triangle>& facets, int exponent);

  /** The nearest point of the surface. */
  struct Nearest
  {
    double Distance; ///< in the surface's units; NaN if the place is not finite
    Point Place;     ///< on the surface
    Id Facet;        ///< on ties the lowest, up to rounding; None if the place is not finite
    /// squared distance, scaled; 0 for far places, where all facets are equally near
    double Squared;

    /** Whether this is the nearest point of two parts of a surface, scaled alike; facets are
     * numbered in the whole. */
    bool IsNearerThan(const Nearest& other) const
    {
      return this->Squared < other.Squared ||
        (this->Squared == other.Squared && this->Facet < other.Facet);
    }
  };

  /** Right up to rounding of coordinates. Thread-safe. */
  Nearest At(const Point& place) const;

  /**
   * At each of several points; the same as one by one.
   *
   * @throws Error (Stopped)
   */
  std::vector<Nearest> At(
    const std::vector<Point>& places, Monitor& monitor, const ProgressRange& progress) const;

private:
  bool Scale(const Point& place, Point& scaled) const;
  Nearest Unscaled(const Nearest& found, const Point& scaled) const;
  Nearest FromAfar(const Point& place) const;
  void Look(Id facet, const Point& scaled, Nearest& best) const;
  Nearest NearestTo(const Point& place, Id hint) const;
  void AtSome(const std::vector<Point>& places, const Id* first, const Id* last,
    std::vector<Nearest>& nearest) const;
  void AtMany(const std::vector<Point>& places, const Id* first, const Id* last,
    std::vector<Nearest>& nearest) const;

  int Exponent;
  std::vector<std::array<Point, 3>> Facets; ///< scaled to below 1
  BoxTree Tree;
};
} // namespace insideout
