// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Types.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

/** Points with exact rational coordinates, evaluated lazily. */
namespace insideout
{
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactNumber = ExactKernel::FT;
using ExactPoint = ExactKernel::Point_3;

inline ExactPoint ToExact(const Point& p)
{
  return { p[0], p[1], p[2] };
}

/** The point between p and q where a linear function vanishes that is a at p and b at q.
 * Evaluated at once, for expressions on expressions get slow. */
ExactPoint ZeroBetween(
  const ExactPoint& p, const ExactNumber& a, const ExactPoint& q, const ExactNumber& b);

/** The nearest double; of two equally near ones the lower. */
double Nearest(const ExactNumber& x);

/** The same for each coordinate. */
Point Nearest(const ExactPoint& p);
} // namespace insideout
