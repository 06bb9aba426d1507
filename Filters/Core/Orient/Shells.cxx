// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/Shells.h"

#include "Common/DisjointSets.h"
#include "Common/Vectors.h"
#include "Orient/SurfacePatches.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace insideout
{
namespace
{
/** Two patches that meet, the lower first, and how much asks that one of them is turned over. */
struct Relation
{
  Id Low;
  Id High;
  bool Branching; ///< not only edges of two facets
  double Weight;  ///< length of edges: above 0 to stay as they are, below to be turned
};

/** A patch at an edge, and how often it runs along it, less the other way. */
struct PatchAtEdge
{
  Id Patch;
  int Sum;
};

/** The facets that count, patch by patch, of one edge; those that balance there are left out. */
void UnbalancedAt(const FacetEdge* first, const FacetEdge* last, const FacetComplex& surface,
  const SurfacePatches& patches, std::vector<PatchAtEdge>& unbalanced)
{
  unbalanced.clear();
  for (const FacetEdge* edge = first; edge != last; ++edge)
  {
    unbalanced.push_back(
      { patches.Patch[edge->Facet], edge->Direction * surface.Multiplicity[edge->Facet] });
  }
  std::sort(unbalanced.begin(), unbalanced.end(),
    [](const PatchAtEdge& a, const PatchAtEdge& b) { return a.Patch < b.Patch; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < unbalanced.size();)
  {
    PatchAtEdge sum = { unbalanced[i].Patch, 0 };
    for (; i < unbalanced.size() && unbalanced[i].Patch == sum.Patch; ++i)
    {
      sum.Sum += unbalanced[i].Sum;
    }
    if (sum.Sum != 0)
    {
      unbalanced[kept++] = sum;
    }
  }
  unbalanced.resize(kept);
}

void AddRelations(const std::vector<PatchAtEdge>& unbalanced, bool branching, double length,
  std::vector<Relation>& relations)
{
  int sum = 0;
  for (const PatchAtEdge& at : unbalanced)
  {
    sum += at.Sum;
  }
  const auto add = [&](std::size_t i, double weight) {
    relations.push_back({ unbalanced[i - 1].Patch, unbalanced[i].Patch, branching, weight });
  };
  if (unbalanced.size() == 2 && std::abs(unbalanced[0].Sum) == std::abs(unbalanced[1].Sum))
  {
    add(1, sum == 0 ? length : -length);
  }
  else if (sum == 0)
  {
    for (std::size_t i = 1; i < unbalanced.size(); ++i)
    {
      add(i, length);
    }
  }
}

/** One of each pair of patches, strongest first. */
std::vector<Relation> RelationsOfPatches(
  const FacetComplex& surface, const std::vector<FacetEdge>& edges, const SurfacePatches& patches)
{
  std::vector<Relation> relations;
  std::vector<PatchAtEdge> unbalanced;
  ForEachEdge(edges,
    [&](const FacetEdge* first, const FacetEdge* last)
    {
      const Id patch = patches.Patch[first->Facet];
      if (last - first < 2 || (last - first == 2 && patch == patches.Patch[first[1].Facet]))
      {
        return;
      }
      UnbalancedAt(first, last, surface, patches, unbalanced);
      AddRelations(unbalanced, last - first > 2,
        Distance(surface.Points[first->Low], surface.Points[first->High]), relations);
    });
  const auto key = [](const Relation& r) { return std::tie(r.Low, r.High, r.Branching); };
  std::stable_sort(relations.begin(), relations.end(),
    [&](const Relation& a, const Relation& b) { return key(a) < key(b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < relations.size(); ++kept)
  {
    Relation sum = relations[i++];
    for (; i < relations.size() && key(relations[i]) == key(sum); ++i)
    {
      sum.Weight += relations[i].Weight;
    }
    relations[kept] = sum;
  }
  relations.resize(kept);
  std::sort(relations.begin(), relations.end(),
    [](const Relation& a, const Relation& b)
    {
      return std::make_tuple(a.Branching, -std::abs(a.Weight), a.Low, a.High) <
        std::make_tuple(b.Branching, -std::abs(b.Weight), b.Low, b.High);
    });
  return relations;
}

/** Sets of patches, in which each is turned against the set's representative or not. */
class TurnedSets
{
public:
  explicit TurnedSets(Id count)
    : Parents(count)
    , AgainstParent(count, 0)
  {
    for (Id i = 0; i < count; ++i)
    {
      this->Parents[i] = i;
    }
  }

  struct Place
  {
    Id Set;
    char Turned;
  };

  Place Find(Id i)
  {
    Place place = { i, 0 };
    while (this->Parents[place.Set] != place.Set)
    {
      // Halve the way, as DisjointSets does.
      const Id parent = this->Parents[place.Set];
      this->AgainstParent[place.Set] ^= this->AgainstParent[parent];
      this->Parents[place.Set] = this->Parents[parent];
      place.Turned ^= this->AgainstParent[place.Set];
      place.Set = this->Parents[place.Set];
    }
    return place;
  }

  void Join(Id i, Id j, bool turned)
  {
    const Place a = this->Find(i);
    const Place b = this->Find(j);
    if (a.Set != b.Set)
    {
      this->Parents[b.Set] = a.Set;
      this->AgainstParent[b.Set] = static_cast<char>(a.Turned ^ b.Turned ^ turned);
    }
  }

private:
  std::vector<Id> Parents;
  std::vector<char> AgainstParent;
};

/** Turn over the fewer of each shell. */
void TurnTheFewer(Shells& shells)
{
  std::vector<Id> size(shells.Count, 0);
  std::vector<Id> turned(shells.Count, 0);
  for (std::size_t f = 0; f < shells.Shell.size(); ++f)
  {
    if (shells.Shell[f] != None)
    {
      ++size[shells.Shell[f]];
      turned[shells.Shell[f]] += shells.Turned[f];
    }
  }
  for (std::size_t f = 0; f < shells.Shell.size(); ++f)
  {
    const Id shell = shells.Shell[f];
    if (shell != None && 2 * static_cast<std::int64_t>(turned[shell]) > size[shell])
    {
      shells.Turned[f] ^= 1;
    }
  }
}
} // namespace

Shells FindShells(const FacetComplex& surface, const std::vector<FacetEdge>& edges)
{
  const std::vector<std::int16_t>& counts = surface.Multiplicity;
  const bool allCount = std::find(counts.begin(), counts.end(), 0) == counts.end();
  std::vector<FacetEdge> some;
  if (!allCount)
  {
    std::copy_if(edges.begin(), edges.end(), std::back_inserter(some),
      [&](const FacetEdge& edge) { return counts[edge.Facet] != 0; });
  }
  const std::vector<FacetEdge>& counted = allCount ? edges : some;
  const SurfacePatches patches = FindPatches(surface, counted);
  TurnedSets sets(patches.Count);
  for (const Relation& relation : RelationsOfPatches(surface, counted, patches))
  {
    if (relation.Weight != 0)
    {
      sets.Join(relation.Low, relation.High, relation.Weight < 0);
    }
  }

  Shells shells;
  shells.Patches = patches.Count;
  shells.Shell.assign(surface.Facets.size(), None);
  shells.Turned.assign(surface.Facets.size(), 0);
  struct Seen
  {
    Id Shell = None;
    char Turned = 0; // the shell's lowest facet against the representative
  };
  std::vector<Seen> seen(patches.Count);
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    if (surface.Multiplicity[f] == 0)
    {
      continue;
    }
    const TurnedSets::Place place = sets.Find(patches.Patch[f]);
    Seen& shell = seen[place.Set];
    if (shell.Shell == None)
    {
      shell = { shells.Count++, place.Turned };
    }
    shells.Shell[f] = shell.Shell;
    shells.Turned[f] = static_cast<char>(place.Turned ^ shell.Turned);
  }
  TurnTheFewer(shells);
  return shells;
}
} // namespace insideout
