// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/Types.h"

#include <optional>
#include <vector>

namespace insideout
{
/** The grid that coordinates were rounded to: floats, or decimals of few digits. */
class CoordinateGrid
{
public:
  /** The grid of floats. */
  CoordinateGrid() = default;

  /** Decimals with this number of significant digits, and this number of decimal places. */
  CoordinateGrid(int digits, int decimals)
    : Digits(digits)
    , Decimals(decimals)
  {
  }

  /** Half of the grid's spacing at a coordinate: the largest rounding error. */
  double RoundingAt(double coordinate) const;

private:
  int Digits = 0; ///< 0 for floats
  int Decimals = 0;
};

/**
 * Find the grid of a body's coordinates. They are floats if all of them are; they are decimals if
 * they need 6 to 9 significant digits, and many of them need all of these. Coordinates that need
 * fewer digits are taken for floats: whether they were rounded is unknown.
 *
 * @param[in] points those that are not finite are skipped
 * @return nothing if some coordinate needs the digits of a double
 */
std::optional<CoordinateGrid> FindCoordinateGrid(const std::vector<Point>& points);
} // namespace insideout
