// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberInDoubleDoubles.h"

#include "BruteForceWindingNumber.h"
#include "DoubleDouble.h"

namespace insideout
{
__float128 ArgumentOf(const DoubleDouble& y, const DoubleDouble& x)
{
  return atan2q(__float128(y.High) + y.Low, __float128(x.High) + x.Low);
}
} // namespace insideout

namespace testmeshes
{
double WindingNumberInDoubleDoubles(const FacetComplex& surface, const Site& site)
{
  return BruteForceWindingNumber<DoubleDouble>(surface, site, DoubleDoubleEpsilon);
}
} // namespace testmeshes
