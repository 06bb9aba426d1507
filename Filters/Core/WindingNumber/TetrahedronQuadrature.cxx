// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/TetrahedronQuadrature.h"

#include "Common/Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace insideout
{
namespace
{
/** Add a place and its images under the cell's symmetries. The last coordinate makes the sum 1. */
void AddOrbit(QuadratureRule& rule, double weight, SiteWeights place)
{
  std::sort(place.begin(), place.end());
  do
  {
    // Rounded to 52 binary places, so that the sum is exactly 1.
    SiteWeights rounded;
    for (int k = 0; k < 3; ++k)
    {
      rounded[k] = std::ldexp(std::round(std::ldexp(place[k], 52)), -52);
    }
    rounded[3] = 1 - rounded[0] - rounded[1] - rounded[2];
    rule.Sites.push_back(rounded);
    rule.Weights.push_back(weight);
  } while (std::next_permutation(place.begin(), place.end()));
}

/** Orbit S31: three coordinates equal. */
void AddS31(QuadratureRule& rule, double weight, double a)
{
  AddOrbit(rule, weight, { { a, a, a, 1 - 3 * a } });
}

/** Orbit S22: two pairs of equal coordinates. */
void AddS22(QuadratureRule& rule, double weight, double a)
{
  AddOrbit(rule, weight, { { a, a, 0.5 - a, 0.5 - a } });
}
} // namespace

QuadratureRule TetrahedronQuadrature(int order)
{
  QuadratureRule rule;
  switch (order)
  {
    case 1:
      rule.Sites = { BarycentreWeights };
      rule.Weights = { 1 };
      return rule;
    case 2:
      AddS31(rule, 0.25, 0.13819660112501051518);
      return rule;
    case 3:
      AddS31(rule, 0.13852796651186214232, 0.32805469671142664734);
      AddS31(rule, 0.11147203348813785768, 0.10695227393293068277);
      return rule;
    case 4:
    case 5:
      AddS31(rule, 0.11268792571801585080, 0.31088591926330060980);
      AddS31(rule, 0.07349304311636194934, 0.09273525031089122629);
      AddS22(rule, 0.04254602077708146644, 0.04550370412564964949);
      return rule;
    default:
      throw Error(ErrorCode::InvalidParameter,
        "the order of quadrature is " + std::to_string(order) + "; it has to be from 1 to " +
          std::to_string(HighestQuadratureOrder));
  }
}
} // namespace insideout
