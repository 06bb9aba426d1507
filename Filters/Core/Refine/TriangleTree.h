// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/BoxTree.h"

#include <limits>
#include <vector>

namespace insideout
{
/** A triangle by its corners' coordinates. Facets of one label may replace each other. */
struct LabelledTriangle
{
  std::array<Point, 3> Corners;
  Id Label;
};

/** Distances of places and triangles from a surface. */
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

  /** @param[in] hint a triangle of that label near the place, None for any: it wins ties, and saves
   * time
   */
  Nearest NearestTo(const Point& place, Id label, Id hint = None) const;

  /**
   * The largest distance of a triangle's points from the triangles of its label, by samples, eight
   * along each edge. It may be exceeded by a tenth of `enough`, and, if the triangle is not near a
   * single other triangle, between samples.
   *
   * @param[in] enough smaller distances need not be exact
   * @param[in] known at least `enough`: smaller distances need not be found at all
   */
  double LargestDistanceOf(
    const LabelledTriangle& triangle, double enough, double known, Id hint = None) const
  {
    return this->LargestDistanceOf(triangle, { Precision * enough, known }, hint, 0);
  }

  /**
   * Whether no point of a triangle is farther than `distance`; false if the decision would take
   * long.
   * @param[in] ofCorners the nearest points of its label to the corners
   */
  bool IsWithin(const LabelledTriangle& triangle, double distance,
    const std::array<Nearest, 3>& ofCorners) const;

private:
  static constexpr double Precision = 0.1;

  /** The required precision of a distance, and the least distance of interest. */
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
