// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ProgressRange.h"
#include "Planar/PlanarHull.h"
#include "WindingNumber/PolylineWindingNumber.h"

namespace insideout
{
/** The winding number of a curve in a plane, at places in space: that of their feet in the plane.
 */
class CurveWindingNumber
{
public:
  /** @param[in] hull of the curve, of which only the curve and the plane are kept */
  explicit CurveWindingNumber(const PlanarHull& hull);

  /** At one finite place. Safe to call from several threads. */
  double At(const Point& p) const;

  /**
   * One value per place, NaN where it is not finite.
   * @throws Error (Stopped)
   */
  std::vector<double> At(
    const std::vector<Point>& points, Monitor& monitor, const ProgressRange& progress) const;

  /** By how much w rises per unit of length, away from the curve: in the plane. */
  Point Gradient(const Point& p) const;

private:
  insideout::Plane Plane;
  std::vector<CountedPlace> OpenEnds;
  PolylineWindingNumber Number;
};
} // namespace insideout
