// SPDX-License-Identifier: GPL-3.0-or-later
#include "Validate/FacetSources.h"

namespace insideout
{
void SetFacetSources(const std::vector<FacetSource>& places, FacetComplex& surface)
{
  // Counted two facets ahead, so that filling moves each offset to its final position.
  std::vector<Id>& offsets = surface.SourceOffsets;
  offsets.assign(surface.Facets.size() + 2, 0);
  for (const FacetSource& place : places)
  {
    if (place.Triangle != None)
    {
      ++offsets[static_cast<std::size_t>(place.Triangle) + 2];
    }
  }
  for (std::size_t f = 2; f < offsets.size(); ++f)
  {
    offsets[f] += offsets[f - 1];
  }
  surface.Sources.resize(static_cast<std::size_t>(offsets.back()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i].Triangle != None)
    {
      Id& next = offsets[static_cast<std::size_t>(places[i].Triangle) + 1];
      surface.Sources[next++] = { static_cast<Id>(i), places[i].Reversed };
    }
  }
  offsets.pop_back();
}
} // namespace insideout
