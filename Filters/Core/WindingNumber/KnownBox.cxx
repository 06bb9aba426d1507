// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/KnownBox.h"

#include "Common/Error.h"
#include "WindingNumber/PlaceInBox.h"

namespace insideout
{
namespace
{
// Detours tried. A detour fails only if it meets an edge or a corner exactly. The places are in
// irregular positions, so the first detour nearly always works; all fail only on input made for it.
constexpr int MostDetours = 64;

} // namespace

double WindingNumberIn(const KnownBox& box, const ChainFacets& facets, const PreparedSite& site)
{
  std::vector<Id> touched;
  double crossings = 0;
  Point towards = box.Reference;
  bool counted =
    facets.CountCrossings(box.FirstFacet, box.LastFacet, site, towards, &touched, crossings);
  for (int j = 0; !counted && j < MostDetours; ++j)
  {
    touched.clear();
    crossings = 0;
    towards = PlaceInBox(box.Bounds.Low, box.Bounds.High, j);
    std::vector<SidedFacet> sided;
    for (const SidedFacet* f = box.FirstFacet; f != box.LastFacet; ++f)
    {
      sided.emplace_back(f->Facet(), facets.SideOf(f->Facet(), towards));
    }
    counted = facets.CountCrossings(
                sided.data(), sided.data() + sided.size(), site, towards, &touched, crossings) &&
      facets.CountCrossings(box.FirstFacet, box.LastFacet, PreparedSite(SiteAt(towards)),
        box.Reference, nullptr, crossings);
  }
  if (!counted)
  {
    throw Error(ErrorCode::Inconsistent,
      "no way from a site to its box's reference avoids the edges of all facets");
  }
  const double ofTouched =
    touched.empty() ? 0 : facets.AngleOfTouched(std::move(touched), site, towards);
  return box.Value + crossings - ofTouched;
}
} // namespace insideout
