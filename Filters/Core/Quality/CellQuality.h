// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <algorithm>
#include <vector>

namespace insideout
{
/**
 * The quality of a tetrahedron. An inverted cell has the values of its mirror image, except for the
 * sign of the mean ratio.
 */
struct CellQuality
{
  /** In degrees, from 0 to 180, at each of TetrahedronEdges. */
  std::array<double, 6> DihedralAngles;

  /**
   * The radius of the circumsphere over the shortest edge: sqrt(6) / 4 = 0.612 at best, infinite
   * for a flat cell.
   */
  double RadiusEdgeRatio;

  /** 12 (3 V)^(2/3) over the sum of the squared edges, as in Verdict (Liu and Joe 1994): 1 at best,
   * 0 for a flat cell, negative for an inverted one. */
  double MeanRatio;

  double MinDihedralAngle() const
  {
    return *std::min_element(this->DihedralAngles.begin(), this->DihedralAngles.end());
  }
  double MaxDihedralAngle() const
  {
    return *std::max_element(this->DihedralAngles.begin(), this->DihedralAngles.end());
  }
};

/**
 * The quality of a tetrahedron, never NaN. Thick cells are computed in doubles; cells with a volume
 * below a millionth of their longest edge cubed in double-doubles, from exact differences of
 * coordinates. So all values have ten digits down to 1e-20 of that cube, where doubles give noise.
 * Only an exactly flat cell counts as flat: its angles are 0 and 180 degrees, and 0 at an edge of a
 * face without area.
 *
 * @param[in] corners finite coordinates
 */
CellQuality QualityOfCell(const std::array<Point, 4>& corners);

/** The same for one cell of a mesh. */
CellQuality QualityOfCell(const std::vector<Point>& points, const Tetrahedron& cell);
} // namespace insideout
