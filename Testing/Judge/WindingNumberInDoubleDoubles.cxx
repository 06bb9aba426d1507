// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumberInDoubleDoubles.h"

#include "DoubleDouble.h"

#include "BruteForceWindingNumber.h"

namespace testmeshes
{
double WindingNumberInDoubleDoubles(const FacetComplex& surface, const Site& site)
{
  return BruteForceWindingNumber<DoubleDouble>(surface, site, DoubleDoubleEpsilon);
}
} // namespace testmeshes
