// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/FacetComplex.h"

namespace insideout
{
/** Append a facet with the multiplicity and sources of a facet of another complex. */
inline void AppendFacet(
  FacetComplex& surface, const Triangle& corners, const FacetComplex& from, Id facet)
{
  const auto sources = from.Sources.begin();
  surface.Facets.push_back(corners);
  surface.Multiplicity.push_back(from.Multiplicity[facet]);
  surface.Sources.insert(surface.Sources.end(), sources + from.SourceOffsets[facet],
    sources + from.SourceOffsets[facet + 1]);
  surface.SourceOffsets.push_back(static_cast<Id>(surface.Sources.size()));
}
} // namespace insideout
