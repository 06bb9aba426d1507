// SPDX-License-Identifier: GPL-3.0-or-later
#include "Orient/Shells.h"

#include "Orient/JoinCopies.h"
#include "Orient/LoosePatches.h"
#include "Orient/ShellChains.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace insideout
{
namespace
{
/**
 * Two patches that meet, the lower first, and the length of edges that asks for turning one of
 * them.
 */
struct Relation
{
  Id Low;
  Id High;
  bool Branching; ///< not only edges of two facets
  double Weight;  ///< length of edges: above 0 to keep both, below 0 to turn one
};

/** The seams of some patches: the relations they demand, and the pairs joined there. */
struct SeamsOfPatches
{
  std::vector<Relation> Relations;
  std::vector<PatchSeam> Balanced;
  std::vector<Id> Cancelling; ///< patches whose copies are joined with nothing else
};

void AddSeam(const PatchSeam& seam, const SeamedPatches& patches, SeamsOfPatches& seams)
{
  std::vector<PatchAtSeam> counting;
  std::vector<Id> opposed;
  std::int64_t sum = 0;
  for (const PatchAtSeam& at : seam.Patches)
  {
    if (patches.Count[at.Patch] > 0)
    {
      counting.push_back(at);
      sum += patches.RunOf(at);
    }
    if (patches.Opposed[at.Patch] > 0)
    {
      opposed.push_back(at.Patch);
    }
  }
  const auto run = [&](int i) { return std::abs(patches.RunOf(counting[i])); };
  if (counting.size() == 2 && run(0) == run(1) && (sum != 0 || opposed.empty()))
  {
    seams.Relations.push_back({ counting[0].Patch, counting[1].Patch, seam.Counting > 2,
      sum == 0 ? seam.Length : -seam.Length });
  }
  else if (sum == 0)
  {
    seams.Balanced.push_back(seam);
    return;
  }
  seams.Cancelling.insert(seams.Cancelling.end(), opposed.begin(), opposed.end());
}

/** One relation of each pair of patches, strongest first. */
void SortRelations(std::vector<Relation>& relations)
{
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
}

/** Join the copies of loose patches, or of all others. */
void JoinPatches(const FacetComplex& surface, const FacetEdges& edges, const SeamedPatches& patches,
  const PatchCopies& copies, const std::vector<char>& isLoose, char loose, TurnedSets& sets)
{
  SeamsOfPatches seams;
  for (const PatchSeam& seam : patches.Seams)
  {
    PatchSeam some = seam;
    some.Patches.clear();
    std::copy_if(seam.Patches.begin(), seam.Patches.end(), std::back_inserter(some.Patches),
      [&](const PatchAtSeam& at) { return isLoose[at.Patch] == loose; });
    if (!some.Patches.empty())
    {
      AddSeam(some, patches, seams);
    }
  }
  SortRelations(seams.Relations);
  for (const Relation& relation : seams.Relations)
  {
    const Id each = std::min(copies.Along(relation.Low), copies.Along(relation.High));
    for (Id i = 0; relation.Weight != 0 && i < each; ++i)
    {
      sets.Join(
        copies.First(relation.Low) + i, copies.First(relation.High) + i, relation.Weight < 0);
    }
  }
  JoinCopies(surface, edges, seams.Balanced, patches, copies, sets);
  for (const Id patch : seams.Cancelling)
  {
    for (Id i = 0; i < copies.Against(patch); ++i)
    {
      sets.Join(copies.First(patch) + i, copies.First(patch) + copies.Along(patch) + i, false);
    }
  }
}

/** A shell of copies, in which pairs of copies of one facet cancel. */
class CopiesLeft
{
public:
  CopiesLeft(const SeamedPatches& patches, const PatchCopies& copies, TurnedSets& sets)
    : Left(copies.Count(), 1)
  {
    for (Id p = 0; p < static_cast<Id>(patches.Count.size()); ++p)
    {
      const Id first = copies.First(p);
      const Id against = first + copies.Along(p);
      for (Id i = against; i < first + copies.Size(p); ++i)
      {
        for (Id j = first; j < against && this->Left[i]; ++j)
        {
          const TurnedSets::Place a = sets.Find(i);
          const TurnedSets::Place b = sets.Find(j);
          if (this->Left[j] && a.Set == b.Set && a.Turned == b.Turned)
          {
            this->Left[i] = this->Left[j] = 0;
          }
        }
      }
    }
  }

  bool operator[](Id copy) const { return this->Left[copy] != 0; }

private:
  std::vector<char> Left;
};

/** Turn over the smaller side of each shell. */
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
  for (const ShellCopy& copy : shells.MoreCopies)
  {
    ++size[copy.Shell];
    turned[copy.Shell] += copy.Turned;
  }
  const auto turnsMore = [&](Id shell)
  { return 2 * static_cast<std::int64_t>(turned[shell]) > size[shell]; };
  for (std::size_t f = 0; f < shells.Shell.size(); ++f)
  {
    shells.Turned[f] ^= shells.Shell[f] != None && turnsMore(shells.Shell[f]);
  }
  for (ShellCopy& copy : shells.MoreCopies)
  {
    copy.Turned ^= turnsMore(copy.Shell);
  }
}

/** Number the shells, and set each facet's shell. */
Shells NumberShells(const FacetComplex& surface, const SeamedPatches& patches,
  const PatchCopies& copies, const std::vector<char>& isLoose, TurnedSets& sets)
{
  Shells shells;
  shells.Patches = patches.Patches.Count;
  shells.Shell.assign(surface.Facets.size(), None);
  shells.Multiplicity.assign(surface.Facets.size(), 1);
  shells.Turned.assign(surface.Facets.size(), 0);
  const CopiesLeft left(patches, copies, sets);
  struct Seen
  {
    Id Shell = None;
    char Turned = 0; // orientation of the shell's lowest facet against the representative
  };
  std::vector<Seen> seen(copies.Count());
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    const Id patch = patches.Patches.Patch[f];
    const Id first = copies.First(patch);
    const int sign = SignOfCount(surface.Multiplicity[f]) * patches.Weight[patch];
    for (Id copy = first; copy < first + copies.Size(patch); ++copy)
    {
      if (!left[copy])
      {
        continue;
      }
      const TurnedSets::Place place = sets.Find(copy);
      Seen& shell = seen[place.Set];
      if (shell.Shell == None)
      {
        shell = { shells.Count++, place.Turned };
        shells.IsLoose.push_back(isLoose[patch]);
      }
      const int count = copy < first + copies.Along(patch) ? sign : -sign;
      const char turned = static_cast<char>(place.Turned ^ shell.Turned);
      if (shells.Shell[f] == None)
      {
        shells.Shell[f] = shell.Shell;
        shells.Multiplicity[f] = static_cast<std::int16_t>(count);
        shells.Turned[f] = turned;
      }
      else
      {
        shells.MoreCopies.push_back({ f, shell.Shell, count, turned });
      }
    }
  }
  TurnTheFewer(shells);
  return shells;
}

/** One per patch: whether its facets are turned over. */
std::vector<char> TurnedPatches(const Shells& shells, const SeamedPatches& patches)
{
  std::vector<char> turned(patches.Count.size(), 0);
  for (std::size_t f = 0; f < shells.Turned.size(); ++f)
  {
    turned[patches.Patches.Patch[f]] = shells.Turned[f];
  }
  return turned;
}

/** One per patch: the volume that it encloses once it is turned and its holes are capped. */
std::vector<double> VolumesOfPatches(const FacetComplex& surface, const FacetEdges& edges,
  const SeamedPatches& patches, const Shells& shells)
{
  Shells each;
  each.Count = patches.Patches.Count;
  each.IsLoose.assign(patches.Count.size(), 0);
  each.Turned = shells.Turned;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    each.Shell.push_back(surface.Multiplicity[f] == 0 ? None : patches.Patches.Patch[f]);
    each.Multiplicity.push_back(static_cast<std::int16_t>(SignOfCount(surface.Multiplicity[f])));
  }
  std::vector<double> volumes;
  for (const ShellChain& chain : CloseShells(surface, edges, each, patches.Points))
  {
    volumes.push_back(chain.Volume);
  }
  return volumes;
}
} // namespace

Shells FindShells(const FacetComplex& surface, const FacetEdges& edges)
{
  const auto isThere = [&](Id f)
  { return surface.Multiplicity[f] != 0 || (!surface.Opposed.empty() && surface.Opposed[f] != 0); };
  bool allAre = true;
  for (Id f = 0; f < surface.NumberOfFacets(); ++f)
  {
    allAre = allAre && isThere(f);
  }
  FacetEdges some;
  if (!allAre)
  {
    std::copy_if(edges.begin(), edges.end(), std::back_inserter(some),
      [&](const FacetEdge& edge) { return isThere(edge.Facet); });
  }
  const FacetEdges& used = allAre ? edges : some;
  const SeamedPatches patches = FindSeams(surface, used);
  const PatchCopies copies(patches);
  std::vector<char> loose(patches.Count.size(), 0);
  const auto join = [&]()
  {
    TurnedSets sets(copies.Count());
    JoinPatches(surface, used, patches, copies, loose, 0, sets);
    JoinPatches(surface, used, patches, copies, loose, 1, sets);
    return NumberShells(surface, patches, copies, loose, sets);
  };
  Shells shells = join();
  const std::vector<char> turned = TurnedPatches(shells, patches);
  if (!AllSeamsBalance(patches, turned))
  {
    loose = FindLoosePatches(patches, turned, VolumesOfPatches(surface, edges, patches, shells));
    if (std::find(loose.begin(), loose.end(), 1) != loose.end())
    {
      shells = join();
    }
  }
  return shells;
}
} // namespace insideout
