// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"
#include "Common/Monitor.h"
#include "Common/ProgressRange.h"

namespace insideout
{
/** How far places are from a surface, without sign: which side they are on w tells. */
class SurfaceDistance
{
public:
  /** @param[in] facets at least one; points of none are no part of the surface */
  SurfaceDistance(const std::vector<Point>& points, const std::vector<Triangle>& facets);

  /** The same of a part of a surface, whose points have coordinates below 2^exponent. */
  SurfaceDistance(
    const std::vector<Point>& points, const std::vector<Triangle>& facets, int exponent);

  /** The nearest point of the surface. */
  struct Nearest
  {
    double Distance; ///< in units of the surface; NaN where the place is not finite
    Point Place;     ///< on the surface
    Id Facet; ///< of several the lowest, as far as rounding tells; None where it is not finite
    double Squared; ///< the distance's square, scaled; 0 from afar, where all facets are as near

    /** Whether this is the nearest point of two parts together, scaled alike; facets have their
     * numbers in the whole. */
    bool IsNearerThan(const Nearest& other) const
    {
      return this->Squared < other.Squared ||
        (this->Squared == other.Squared && this->Facet < other.Facet);
    }
  };

  /** Right to rounding of coordinates. Safe to call from several threads. */
  Nearest At(const Point& place) const;

  /**
   * At each of several places; the same as one by one.
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
