// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "FacetComplex.h"
#include "Sites.h"

namespace testmeshes
{
/**
 * The same as WindingNumberInQuads with seven binary digits less for each number, in a tenth of the
 * time.
 */
double WindingNumberInDoubleDoubles(
  const insideout::FacetComplex& surface, const insideout::Site& site);
} // namespace testmeshes
