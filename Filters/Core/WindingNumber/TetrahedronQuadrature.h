// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WindingNumber/Sites.h"

namespace insideout
{
/** Places in a cell and the weight of each; the weights sum to 1. */
struct QuadratureRule
{
  std::vector<SiteWeights> Sites;
  std::vector<double> Weights;
};

constexpr int HighestQuadratureOrder = 5;

/**
 * The smallest implemented symmetric rule, with positive weights and all places within the cell,
 * that integrates polynomials up to degree `order` exactly (Zhang, Cui and Liu 2009): 1 place for
 * order 1 (the barycenter), 4 for 2, 8 for 3, 14 for 4 and 5.
 *
 * @throws Error (InvalidParameter) where the order is not from 1 to HighestQuadratureOrder
 */
QuadratureRule TetrahedronQuadrature(int order);
} // namespace insideout
