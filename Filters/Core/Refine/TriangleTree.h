// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"

#include <limits>
#include <vector>

namespace insideout
{
/** A triangle by its corners' places. Facets of one label may stand in for another. */
struct LabelledTriangle
{
  std::array<Point, 3> Corners;
  Id Label;
};

/** How far places and triangles are from a surface. */
class TriangleTree
{
public:
  explicit TriangleTree(std::vector<LabelledTriangle> triangles);

  /** The nearest point of the triangles of a label. */
  struct Nearest
  {
    Id Triangle;
    Point Place;
    double Distance;
  };

  /** @param[in] hint a triangle of that label near the place, None for any: of several that are as
   *   near it is taken, and time is saved */
  Nearest NearestTo(const Point& place, Id label, Id hint = None) const;

  /**
   * The largest distance that a point of a triangle has from the triangles of its label, as far as
   * samples tell, eight along each edge: it may be more by a small part of `enough`, and where the
   * triangle is not near one other triangle, but several, by what is between samples.
   *
   * @param[in] enough what is below it need not be told more exactly
   */
  double LargestDistanceOf(const LabelledTriangle& triangle, double enough) const
  {
    return this->LargestDistanceOf(triangle, enough, None, 0);
  }

  /** Whether no point of a triangle is farther than that; no where that would take long to tell. */
  bool IsWithin(const LabelledTriangle& triangle, double distance, Id hint) const;

private:
  double LargestDistanceOf(
    const LabelledTriangle& triangle, double enough, Id hint, int divisions) const;

  std::vector<LabelledTriangle> Triangles;
  BoxTree Tree;
};
} // namespace insideout
