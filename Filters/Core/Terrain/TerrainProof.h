// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** A projection, seen from one end of a coordinate axis. */
class AxisView
{
public:
  /** The views are numbered: from above along x, y, z, then from below. */
  static constexpr std::size_t Count = 6;
  explicit AxisView(std::size_t number)
    : Axis(number < 3 ? number : number - 3)
    , IsFromAbove(number < 3)
  {
  }

  PlanarPoint Image(const Point& p) const
  {
    const std::size_t right = (this->Axis + 1) % 3;
    const std::size_t up = (this->Axis + 2) % 3;
    return this->IsFromAbove ? PlanarPoint{ p[right], p[up] } : PlanarPoint{ p[up], p[right] };
  }

  /** The component of a direction toward the viewer. */
  double Towards(const Point& direction) const
  {
    return this->IsFromAbove ? direction[this->Axis] : -direction[this->Axis];
  }

  /** Whether the corners run counter-clockwise, exactly. */
  bool ShowsFront(const std::vector<Point>& points, const Triangle& facet) const;

private:
  std::size_t Axis;
  bool IsFromAbove;
};

/** An edge of one facet, in that facet's direction. */
struct BorderEdge
{
  Id From;
  Id To;
};

/**
 * Whether facets that all face one way are a terrain: no two of them meet beyond the corners and
 * edges that they share by id (MeetBeyondSharedCorners). The proof uses only their border, which is
 * short, and is exact. The answer may be false for a terrain.
 *
 * The facets' images in the view run counter-clockwise. Their border is the sum of their edges, in
 * which opposite ones cancel. Three conditions must hold:
 *
 * 1. Images of two edges of the border have only ends in common that they share by id (so no edge
 *   is repeated).
 * 2. The border is connected through shared ends.
 * 3. Around each end, arriving and leaving edges alternate.
 *
 * Proof. Each image winds once around its own points. So the number of images that cover a point is
 * the winding number n of the border's image. To the left of an edge of the border n is one more
 * than to its right. Around an end, by 3, n alternates between two values, so all edges there have
 * the same n on their right; by 2 all edges of the border have. Far away n is 0, and it is nowhere
 * negative, so it is 0 to the right of all. Each place beside the border's image is covered at most
 * once, and the interiors of no two images overlap.
 *
 * Let the images of two facets have a common point x. It lies on edges of both, because around a
 * point inside one image only that image covers the plane.
 * - Within an edge that cancels, the facets on its two sides cover all around x. These are the two,
 *   and x is on their shared edge.
 * - At a corner without edges of the border, the facets that share it cover all around it. The two
 *   are among these, and x is their shared corner.
 * - Otherwise x is on the border, as a point of both. Within one edge of it there is only one
 *   facet, because two would overlap. Different edges have only ends in common that they share by
 *   id, by 1. So x is a corner that both share.
 *
 * In the worst case, time is quadratic in the border's length.
 *
 * @param[in] view one that shows the front of each facet
 * @param[in] border of the facets
 */
bool IsTerrain(
  const std::vector<Point>& points, const AxisView& view, const std::vector<BorderEdge>& border);
} // namespace insideout
