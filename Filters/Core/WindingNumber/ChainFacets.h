// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Box.h"
#include "WindingNumber/CountedBoundary.h"
#include "WindingNumber/SitePredicates.h"

#include <cstdint>
#include <memory>

namespace insideout
{
/** A facet of a list, and the side of its plane on which a certain place lies: +1, 0 or -1. */
class SidedFacet
{
public:
  SidedFacet(Id facet, int side)
    : Bits(static_cast<std::uint32_t>(facet) << 2 | static_cast<std::uint32_t>(side + 1))
  {
  }
  Id Facet() const { return static_cast<Id>(this->Bits >> 2); }
  int Side() const { return static_cast<int>(this->Bits & 3u) - 1; }

private:
  std::uint32_t Bits;
};

/**
 * The triangles of a chain, prepared for counting those between two places; the count is the
 * difference of the winding numbers there. Safe to use from several threads.
 */
class ChainFacets
{
public:
  /** @param[in] points below 1 in each coordinate; triangles not degenerate, fewer than 2^30 */
  ChainFacets(const std::vector<Point>& points, const std::vector<CountedTriangle>& triangles);

  struct Facet
  {
    PlaneOfTriangle Plane;
    std::array<Point, 3> Corners;
    int Count;
  };

  Id Size() const { return this->NumberOfFacets; }
  const Facet& operator[](Id facet) const { return this->Facets[facet]; }
  /** Recomputed: storing them takes memory and saves no time. */
  Box BoxOf(Id facet) const
  {
    const auto& [a, b, c] = this->Facets[facet].Corners;
    Box box = { a, a };
    box.Add(b);
    box.Add(c);
    return box;
  }

  int SideOf(Id facet, const Point& place) const;

  /** False only where the facet certainly has no point in the box. */
  bool MayMeet(Id facet, const Box& box) const;

  /**
   * Add the difference of the winding numbers at `from` and `to` that is due to some facets. Facets
   * that `from` lies on are appended to `touched` and not counted.
   *
   * @param[in] first, last the facets, with the sides that `to` lies on
   * @return whether the line between the two decides it. It does not if it meets an edge or lies in
   * the plane of a facet, if `to` lies on a facet, or if `from` does and `touched` is null
   */
  bool CountCrossings(const SidedFacet* first, const SidedFacet* last, const PreparedSite& from,
    const Point& to, std::vector<Id>* touched, double& sum) const;

  /**
   * The winding number of the facets that the site lies on, at a place next to it in some
   * direction. Seen from there they are infinite wedges, whose winding numbers are summed.
   */
  double AngleOfTouched(
    std::vector<Id> touched, const PreparedSite& site, const Point& towards) const;

private:
  // An array: a vector would be zeroed by one thread before several fill it.
  Id NumberOfFacets;
  std::unique_ptr<Facet[]> Facets;
};
} // namespace insideout
