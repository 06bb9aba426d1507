// SPDX-License-Identifier: GPL-3.0-or-later
#include "ExactPoint.h"

#include <cmath>
#include <limits>

namespace insideout
{
ExactPoint ZeroBetween(
  const ExactPoint& p, const ExactNumber& a, const ExactPoint& q, const ExactNumber& b)
{
  const ExactPoint zero = p + (q - p) * (a / (a - b));
  zero.exact();
  return zero;
}

double Nearest(const ExactNumber& x)
{
  if (x.approx().is_point())
  {
    return x.approx().inf();
  }
  const auto& exact = x.exact();
  using Rational = std::decay_t<decltype(exact)>;
  const std::pair<double, double> bounds = CGAL::to_interval(exact);
  double nearest = bounds.first;
  while (nearest < bounds.second)
  {
    const double next = std::nextafter(nearest, std::numeric_limits<double>::infinity());
    if (exact - Rational(nearest) <= Rational(next) - exact)
    {
      break;
    }
    nearest = next;
  }
  return nearest;
}

Point Nearest(const ExactPoint& p)
{
  return { Nearest(p.x()), Nearest(p.y()), Nearest(p.z()) };
}
} // namespace insideout
