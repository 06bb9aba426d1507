// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"
#include "WindingNumber/Sites.h"

#include <array>

namespace testmeshes
{
constexpr int SitesAtOnce = 8;

/**
 * The same as WindingNumberInQuads with seven binary digits less for each number, at eight sites in
 * a third of the time that one takes there.
 */
std::array<double, SitesAtOnce> WindingNumbersInDoubleDoubles(
  const insideout::FacetComplex& surface, const std::array<insideout::Site, SitesAtOnce>& sites);
} // namespace testmeshes
