// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/SideOfCircle.h"

#include "Common/Kernel.h"
#include "Common/Numbers.h"

namespace insideout
{
SideOfCircle::SideOfCircle(const PlanarMetric& metric)
  : IsRound(metric.IsPerpendicular())
  , XX(metric.XX * metric.XX)
  , XY(metric.XX * metric.XY)
  , YY(metric.XY * metric.XY + metric.YY * metric.YY)
{
}

template <typename Number>
int SideOfCircle::Sign(const std::array<const PlanarPoint*, 4>& points) const
{
  std::array<std::array<Number, 3>, 3> rows;
  for (int k = 0; k < 3; ++k)
  {
    const Number x = Number((*points[k])[0]) - Number((*points[3])[0]);
    const Number y = Number((*points[k])[1]) - Number((*points[3])[1]);
    rows[k] = { { x, y,
      Number(this->XX) * x * x + Number(2 * this->XY) * x * y + Number(this->YY) * y * y } };
  }
  return CGAL::sign(rows[0][0] * (rows[1][1] * rows[2][2] - rows[1][2] * rows[2][1]) -
    rows[0][1] * (rows[1][0] * rows[2][2] - rows[1][2] * rows[2][0]) +
    rows[0][2] * (rows[1][0] * rows[2][1] - rows[1][1] * rows[2][0]));
}

int SideOfCircle::operator()(
  const PlanarPoint& a, const PlanarPoint& b, const PlanarPoint& c, const PlanarPoint& d) const
{
  if (this->IsRound)
  {
    const auto place = [](const PlanarPoint& p) { return Kernel::Point_2(p[0], p[1]); };
    return Kernel().side_of_oriented_circle_2_object()(place(a), place(b), place(c), place(d));
  }
  const std::array<const PlanarPoint*, 4> points{ { &a, &b, &c, &d } };
  try
  {
    const IntervalRounding rounding;
    return this->Sign<Interval>(points);
  }
  catch (const CGAL::Uncertain_conversion_exception&)
  {
    return this->Sign<DyadicNumber>(points);
  }
}
} // namespace insideout
