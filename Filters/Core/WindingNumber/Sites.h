// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <vector>

namespace insideout
{
/** Weights of the four corners of a cell, whose exact sum is 1. */
using SiteWeights = std::array<double, 4>;

/** The weights of the barycenter. */
constexpr SiteWeights BarycentreWeights = { { 0.25, 0.25, 0.25, 0.25 } };

/**
 * A point at which a winding number is wanted: the sum of Weights[k] * Corners[k], which is never
 * rounded. Floating point would put the barycenter of many a sliver outside its own cell.
 */
struct Site
{
  std::array<Point, 4> Corners;
  SiteWeights Weights;
};

/** A point as a site. */
inline Site SiteAt(const Point& point)
{
  return { { { point, point, point, point } }, BarycentreWeights };
}

/** From the site to a point; as the weights sum to 1, differences can be taken first. */
template <typename Number>
std::array<Number, 3> VectorFrom(const Site& site, const Point& point)
{
  std::array<Number, 3> result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = 0;
    for (int k = 0; k < 4; ++k)
    {
      result[axis] +=
        Number(site.Weights[k]) * (Number(point[axis]) - Number(site.Corners[k][axis]));
    }
  }
  return result;
}

/** A site's position in double-double precision: High + Low. */
struct RoundedSite
{
  explicit RoundedSite(const Site& site);
  explicit RoundedSite(const Point& point)
    : High(point)
    , Low{ 0, 0, 0 }
  {
  }

  Point High;
  Point Low;
};

/** The cells {p, p, p, p} of this number of points. */
std::vector<Tetrahedron> CellsOfPoints(std::size_t count);

/** The same place in each of many cells. A cell {p, p, p, p} makes point p a site. */
struct Sites
{
  const std::vector<Point>& Points;
  const std::vector<Tetrahedron>& Cells;
  SiteWeights Weights = BarycentreWeights;

  Site operator[](std::size_t i) const
  {
    const Tetrahedron& cell = this->Cells[i];
    return { { { this->Points[cell[0]], this->Points[cell[1]], this->Points[cell[2]],
               this->Points[cell[3]] } },
      this->Weights };
  }

  RoundedSite Rounded(std::size_t i) const
  {
    const Tetrahedron& cell = this->Cells[i];
    const bool isPoint = cell[1] == cell[0] && cell[2] == cell[0] && cell[3] == cell[0];
    return isPoint ? RoundedSite(this->Points[cell[0]]) : RoundedSite((*this)[i]);
  }
};
} // namespace insideout
