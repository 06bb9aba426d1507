// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FacetComplex.h"
#include "Sites.h"

namespace testmeshes
{
/**
 * The winding number of a complex at a site by brute force, to compare with: the sum of all solid
 * angles, an arctangent each, in quadruple precision. A facet counts 0 where its determinant is 0,
 * as it is for sites in its plane as long as coordinates are small whole numbers.
 *
 * @param[in] site a barycentre, or a point by SiteAt
 */
double WindingNumberInQuads(const insideout::FacetComplex& surface, const insideout::Site& site);
} // namespace testmeshes
