// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/PlanarPoint.h"
#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** How things look from one end of a coordinate axis. */
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
 * Whether facets that all look one way are a terrain: no two of them meet beyond the corners and
 * the edges that they share by id (MeetBeyondSharedCorners). That is proved by their border alone,
 * which is short, and exactly. Where the answer is no they may be one all the same.
 *
 * The facets' images in the view run counter-clockwise. Their border is the sum of their edges, in
 * which opposite ones cancel. It has to hold that
 *
 * 1. images of two edges of the border have nothing in common but ends that they share by id (so
 *      that none is there twice);
 * 2. the border is in one piece: from each edge to each other one comes through shared ends;
 * 3. around each end edges that arrive and edges that leave take turns.
 *
 * Proof. The number of images that cover a point is the winding number of the border's image there,
 * for each image winds once around its own points. To the left of an edge of the border that is one
 * more than to its right. Around an end, by 3, one passes from n to n + 1 and back again and again,
 * so that all edges there have the same n on their right; by 2 all edges of the border have. Far
 * away the number is 0, and it is nowhere below, so n is 0: each place beside the border's image is
 * covered once or not at all, and the insides of no two images overlap.
 *
 * Let the images of two facets have a common point x. It lies on edges of both: all around a point
 * inside one image is covered by that image alone.
 * - Within an edge that cancels there is a facet on either side, and they cover all around x: these
 *   are the two, and x is on the edge that they share.
 * - At a corner that has no edge of the border, facets that share it cover all around it: the two
 *     are among these, and x is the corner that they share.
 * - Else x is on the border as a point of the one and of the other. Within one edge of it there is
 *   but one facet, for two would overlap. Different edges have only ends in common that they share
 *     by id, by 1: x is a corner that both share.
 *
 * It takes longer with the square of the border's length at worst.
 *
 * @param[in] view in that shows the front of each facet
 * @param[in] border of the facets
 */
bool IsTerrain(
  const std::vector<Point>& points, const AxisView& view, const std::vector<BorderEdge>& border);
} // namespace insideout
