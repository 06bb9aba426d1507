// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace insideout
{
/**
 * Set Sources and SourceOffsets of a surface whose facets are set.
 *
 * @param[in] places per source, in the order of their numbers: its facet, None for none, and
 * whether the facet is oriented the other way
 */
void SetFacetSources(const std::vector<FacetSource>& places, FacetComplex& surface);
} // namespace insideout
