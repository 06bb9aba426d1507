// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/PatchSeams.h"

#include "Common/FacetComplex.h"
#include "Common/ScaledPoints.h"
#include "Common/Vectors.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace insideout
{
namespace
{
/** Limit of copies of a facet that are distinguished. More, as an already resolved surface may
 * claim, are merged into one with their count. */
constexpr int MostCopies = 64;

/** The patches at an edge that do not balance there by themselves. */
void PatchesAt(const FacetEdge* first, const FacetEdge* last, const FacetComplex& surface,
  const SurfacePatches& patches, std::vector<PatchAtSeam>& found)
{
  found.clear();
  for (const FacetEdge* edge = first; edge != last; ++edge)
  {
    found.push_back({ patches.Patch[edge->Facet],
      edge->Direction * SignOfCount(surface.Multiplicity[edge->Facet]) });
  }
  std::sort(found.begin(), found.end(),
    [](const PatchAtSeam& a, const PatchAtSeam& b) { return a.Patch < b.Patch; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < found.size();)
  {
    PatchAtSeam sum = { found[i].Patch, 0 };
    for (; i < found.size() && found[i].Patch == sum.Patch; ++i)
    {
      sum.Direction += found[i].Direction;
    }
    if (sum.Direction != 0)
    {
      found[kept++] = sum;
    }
  }
  found.resize(kept);
}

/** Edges run from their lower to their higher point; seams do not depend on it. */
void DirectAlongFirst(std::vector<PatchAtSeam>& patches)
{
  if (!patches.empty() && patches.front().Direction < 0)
  {
    for (PatchAtSeam& at : patches)
    {
      at.Direction = -at.Direction;
    }
  }
}

bool ComesBefore(const PatchSeam& a, const PatchSeam& b)
{
  return std::lexicographical_compare(a.Patches.begin(), a.Patches.end(), b.Patches.begin(),
    b.Patches.end(),
    [](const PatchAtSeam& x, const PatchAtSeam& y)
    { return std::make_pair(x.Patch, x.Direction) < std::make_pair(y.Patch, y.Direction); });
}

/** Merge edges at which the same patches meet into one seam. */
void JoinEqual(std::vector<PatchSeam>& seams)
{
  std::stable_sort(seams.begin(), seams.end(), ComesBefore);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < seams.size();)
  {
    PatchSeam seam = std::move(seams[i]);
    double longest = seam.Length;
    for (++i; i < seams.size() && seams[i].Patches == seam.Patches; ++i)
    {
      if (seams[i].Length > longest)
      {
        longest = seams[i].Length;
        seam.Longest = seams[i].Longest;
      }
      seam.Length += seams[i].Length;
      seam.Counting = std::max(seam.Counting, seams[i].Counting);
    }
    seams[kept++] = std::move(seam);
  }
  seams.resize(kept);
}
} // namespace

SeamedPatches FindSeams(const FacetComplex& surface, const FacetEdges& edges)
{
  SeamedPatches found;
  found.Patches = FindPatches(surface, edges);
  const std::vector<Id>& patch = found.Patches.Patch;
  found.Count.resize(found.Patches.Count);
  found.Weight.resize(found.Patches.Count, 1);
  found.Opposed.resize(found.Patches.Count, 0);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const int count = std::abs(surface.Multiplicity[f]);
    const int opposed = surface.Opposed.empty() ? 0 : surface.Opposed[f];
    const bool areFew = count + opposed <= MostCopies;
    found.Count[patch[f]] = areFew ? count : std::min(count, 1);
    found.Weight[patch[f]] = areFew ? 1 : std::max(count, 1);
    found.Opposed[patch[f]] = areFew ? opposed : 0;
  }
  if (found.Patches.Count == 1)
  {
    return found;
  }
  found.Points = ScaledPoints(surface.Points, -LargestExponent(surface.Points));
  std::vector<PatchAtSeam> patches;
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      if (last - first == 2 && patch[first->Facet] == patch[first[1].Facet])
      {
        return;
      }
      PatchesAt(first, last, surface, found.Patches, patches);
      if (patches.empty() ||
        (patches.size() == 1 && found.Opposed[patches.front().Patch] == 0)) // an open edge
      {
        return;
      }
      DirectAlongFirst(patches);
      const auto counts = [&](const FacetEdge& e) { return surface.Multiplicity[e.Facet] != 0; };
      found.Seams.push_back(
        { patches, Distance(found.Points[first->Low], found.Points[first->High]),
          { static_cast<Id>(first - edges.data()), static_cast<Id>(last - edges.data()) },
          static_cast<Id>(std::count_if(first, last, counts)) });
    });
  JoinEqual(found.Seams);
  return found;
}
} // namespace insideout
