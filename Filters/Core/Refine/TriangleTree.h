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
   * samples tell, eight along each edge: it may be more by a tenth of `enough`, and where the
   * triangle is not near one other triangle, but several, by what is between samples.
   *
   * @param[in] enough what is below it need not be told exactly
   * @param[in] known at least `enough`: what is below it need not be told at all
   */
  double LargestDistanceOf(
    const LabelledTriangle& triangle, double enough, double known, Id hint = None) const
  {
    return this->LargestDistanceOf(triangle, { Precision * enough, known }, hint, 0);
  }

  /** Whether no point of a triangle is farther than that; no where that would take long to tell.
   * @param[in] ofCorners the nearest points of its label to the corners */
  bool IsWithin(const LabelledTriangle& triangle, double distance,
    const std::array<Nearest, 3>& ofCorners) const;

private:
  static constexpr double Precision = 0.1;

  /** About a distance: what it need not be told better than, and more than. */
  struct Interest
  {
    double Precision;
    double Known;
  };
  double LargestDistanceOf(
    const LabelledTriangle& triangle, const Interest& interest, Id hint, int divisions) const;

  std::vector<LabelledTriangle> Triangles;
  BoxTree Tree;
};
} // namespace insideout
