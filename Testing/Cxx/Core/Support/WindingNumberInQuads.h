// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "WindingNumber/Sites.h"

namespace testmeshes
{
/**
 * The winding number of a complex at a site by brute force, as a reference: the sum of all solid
 * angles in quadruple precision. If the site is too close to a facet for quadruple precision,
 * enough digits are used to be exact. So a facet in whose plane the site lies counts 0.
 *
 * @param[in] site a barycenter, or a point by SiteAt
 * @return NaN if coordinates differ so much in size that even those digits were too few
 */
double WindingNumberInQuads(const insideout::FacetComplex& surface, const insideout::Site& site);
} // namespace testmeshes
