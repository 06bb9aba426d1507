// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ProgressRange.h"
#include "Planar/PlanarHull.h"
#include "WindingNumber/PolylineWindingNumber.h"

namespace insideout
{
/** The winding number of a curve in a plane, at points in space: at their projections onto the
 * plane. */
class CurveWindingNumber
{
public:
  /** @param[in] hull of the curve; only the curve and the plane are kept */
  explicit CurveWindingNumber(const PlanarHull& hull);

  /** At one finite point. Safe to call from several threads. */
  double At(const Point& p) const;

  /**
   * One value per point, NaN if it is not finite.
   * @throws Error (Stopped)
   */
  std::vector<double> At(
    const std::vector<Point>& points, Monitor& monitor, const ProgressRange& progress) const;

  /** The gradient of w in the plane, away from the curve. */
  Point Gradient(const Point& p) const;

private:
  insideout::Plane Plane;
  std::vector<CountedPlace> OpenEnds;
  PolylineWindingNumber Number;
};
} // namespace insideout
