// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FindIntersections.h"

#include "Common/BoxTree.h"
#include "Common/ParallelLoop.h"
#include "Common/Stages.h"
#include "Resolve/FacetsNearOthers.h"
#include "Resolve/MeetBeyondSharedCorners.h"
#include "Terrain/SurfaceParts.h"

#include <algorithm>

namespace insideout
{
namespace
{
using Pairs = std::vector<std::array<Id, 2>>;

/** Parts of the tree per task of a thread. */
constexpr Id BlockSize = 256;

/** An estimate of the time per facet. */
constexpr double NanosecondsPerFacet = 1000;

/** An estimate of the time to find a facet's box. */
constexpr double NanosecondsPerBox = 15;

/** Facets of a part that share a box: neighbors in the input are near each other as a rule. */
constexpr Id FacetsPerBlock = 16;

/** From this number of pairs of facets on, building a tree pays off. */
constexpr std::size_t ManyPairs = 4096;

/**
 * Fewer facets are not cut into parts: they have too few cubes for a sample to tell whether it pays
 * off.
 */
constexpr std::size_t ManyFacets = 8192;

/** Call search(i, pairs) for every i below count, on all threads. @return all pairs found, sorted
 */
template <class Search>
Pairs Collect(Id count, double cost, Monitor& monitor, const Search& search)
{
  std::vector<Pairs> found(static_cast<std::size_t>(count));
  ParallelLoop(count, cost, monitor, { Stages::FindingIntersections, 0, 1 },
    [&](Id i) { search(i, found[i]); });
  Pairs pairs;
  for (const Pairs& some : found)
  {
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/** Tests facets whose boxes meet. */
class FacetComparer
{
public:
  FacetComparer(const std::vector<Point>& points, const std::vector<Triangle>& facets)
    : Points(points)
    , Facets(facets)
  {
  }

  Box BoxOf(Id facet) const { return BoundingBox(this->Points, this->Facets[facet]); }

  std::vector<Box> BoxesOf(const std::vector<Id>& facets) const
  {
    std::vector<Box> boxes;
    boxes.reserve(facets.size());
    for (const Id f : facets)
    {
      boxes.push_back(this->BoxOf(f));
    }
    return boxes;
  }

  void Compare(Id i, Id j, Pairs& pairs) const
  {
    if (MeetBeyondSharedCorners(this->Points, this->Facets[i], this->Facets[j]))
    {
      pairs.push_back({ std::min(i, j), std::max(i, j) });
    }
  }

private:
  const std::vector<Point>& Points;
  const std::vector<Triangle>& Facets;
};

/** Search some facets for pairs of different sets. @param[in] sets one per facet of these */
Pairs SearchBetweenSets(const FacetComparer& comparer, const std::vector<Id>& facets,
  const std::vector<Id>& sets, Monitor& monitor)
{
  const BoxTree tree(comparer.BoxesOf(facets));
  const std::vector<Id> setsOfParts = tree.SetsOfParts(sets);
  const Id blocks = (tree.NumberOfParts() + BlockSize - 1) / BlockSize;
  return Collect(blocks, NanosecondsPerFacet * BlockSize, monitor,
    [&](Id block, Pairs& pairs)
    {
      const Id begin = block * BlockSize;
      for (Id part = begin; part < std::min(begin + BlockSize, tree.NumberOfParts()); ++part)
      {
        tree.VisitPairsBetween(part, sets, setsOfParts,
          [&](Id a, Id b) { comparer.Compare(facets[a], facets[b], pairs); });
      }
    });
}

/** Searches the parts of a surface: those that are not terrains, and pairs whose boxes meet. */
class PartSearcher
{
public:
  PartSearcher(const FacetComparer& comparer, const SurfaceParts& surface)
    : Comparer(comparer)
    , Surface(surface)
    , FirstBlocks({ 0 })
  {
    for (const SurfacePart& part : surface.Parts)
    {
      const Id blocks = (part.End - part.Begin + FacetsPerBlock - 1) / FacetsPerBlock;
      this->FirstBlocks.push_back(this->FirstBlocks.back() + blocks);
    }
    this->Blocks.resize(static_cast<std::size_t>(this->FirstBlocks.back()), Box::Empty());
    this->BoxesOfParts.resize(surface.Parts.size(), Box::Empty());
    const double facets = static_cast<double>(surface.Facets.size());
    ParallelLoop(surface.Parts.size(),
      NanosecondsPerBox * facets / static_cast<double>(surface.Parts.size() + 1),
      [&](std::size_t p)
      {
        const SurfacePart& part = surface.Parts[p];
        Box* const blocks = this->Blocks.data() + this->FirstBlocks[p];
        for (Id i = part.Begin; i < part.End; ++i)
        {
          blocks[(i - part.Begin) / FacetsPerBlock].Add(comparer.BoxOf(surface.Facets[i]));
        }
        std::for_each(blocks, this->Blocks.data() + this->FirstBlocks[p + 1],
          [&](const Box& box) { this->BoxesOfParts[p].Add(box); });
      });
  }

  Pairs Search(Monitor& monitor) const
  {
    std::vector<std::array<Id, 2>> meeting;
    for (Id part = 0; part < static_cast<Id>(this->Surface.Parts.size()); ++part)
    {
      if (!this->Surface.Parts[part].IsTerrain)
      {
        meeting.push_back({ part, part });
      }
    }
    const BoxTree tree(this->BoxesOfParts);
    for (Id node = 0; node < tree.NumberOfParts(); ++node)
    {
      tree.VisitPairs(node, [&](Id a, Id b) { meeting.push_back({ a, b }); });
    }
    const double facets = static_cast<double>(this->Surface.Facets.size());
    return Collect(static_cast<Id>(meeting.size()),
      NanosecondsPerFacet * facets / static_cast<double>(meeting.size() + 1), monitor,
      [&](Id i, Pairs& pairs)
      {
        const auto [a, b] = meeting[i];
        if (a == b)
        {
          this->SearchIn(this->Surface.Parts[a], pairs);
        }
        else
        {
          this->SearchBetween(a, b, pairs);
        }
      });
  }

private:
  /** Facets of a part, and their boxes. */
  struct Some
  {
    std::vector<Id> Facets;
    std::vector<Box> Boxes;
    Box Bounds = Box::Empty();

    void Add(Id facet, const Box& box)
    {
      this->Facets.push_back(facet);
      this->Boxes.push_back(box);
      this->Bounds.Add(box);
    }
  };

  void SearchIn(const SurfacePart& part, Pairs& pairs) const
  {
    Some all;
    for (Id i = part.Begin; i < part.End; ++i)
    {
      all.Add(this->Surface.Facets[i], this->Comparer.BoxOf(this->Surface.Facets[i]));
    }
    const BoxTree tree(all.Boxes);
    for (Id node = 0; node < tree.NumberOfParts(); ++node)
    {
      tree.VisitPairs(
        node, [&](Id i, Id j) { this->Comparer.Compare(all.Facets[i], all.Facets[j], pairs); });
    }
  }

  Some Within(Id p, const Box& box) const
  {
    Some some;
    const SurfacePart& part = this->Surface.Parts[p];
    for (Id block = this->FirstBlocks[p]; block < this->FirstBlocks[p + 1]; ++block)
    {
      if (this->Blocks[block].Meets(box))
      {
        const Id begin = part.Begin + (block - this->FirstBlocks[p]) * FacetsPerBlock;
        for (Id i = begin; i < std::min(begin + FacetsPerBlock, part.End); ++i)
        {
          const Id facet = this->Surface.Facets[i];
          if (const Box own = this->Comparer.BoxOf(facet); own.Meets(box))
          {
            some.Add(facet, own);
          }
        }
      }
    }
    return some;
  }

  void SearchBetween(Id a, Id b, Pairs& pairs) const
  {
    const Some first = this->Within(a, this->BoxesOfParts[b]);
    const Some second = this->Within(b, first.Bounds);
    if (first.Facets.size() * second.Facets.size() > ManyPairs)
    {
      const BoxTree tree(first.Boxes);
      for (std::size_t j = 0; j < second.Facets.size(); ++j)
      {
        tree.Visit(second.Boxes[j],
          [&](Id i) { this->Comparer.Compare(first.Facets[i], second.Facets[j], pairs); });
      }
      return;
    }
    for (std::size_t i = 0; i < first.Facets.size(); ++i)
    {
      for (std::size_t j = 0; j < second.Facets.size(); ++j)
      {
        if (first.Boxes[i].Meets(second.Boxes[j]))
        {
          this->Comparer.Compare(first.Facets[i], second.Facets[j], pairs);
        }
      }
    }
  }

  const FacetComparer& Comparer;
  const SurfaceParts& Surface;
  std::vector<Id> FirstBlocks; ///< of the parts, and the end
  std::vector<Box> Blocks;     ///< boxes of FacetsPerBlock facets of a part each
  std::vector<Box> BoxesOfParts;
};
} // namespace

Pairs FindIntersections(
  const std::vector<Point>& points, const std::vector<Triangle>& facets, Monitor& monitor)
{
  return FindIntersections(points, facets, 0, monitor);
}

Pairs FindIntersectionsBetween(const std::vector<Point>& points,
  const std::vector<Triangle>& facets, const std::vector<Id>& setOf,
  const std::vector<Id>& nearOthers, Monitor& monitor)
{
  monitor.Check(Stages::FindingIntersections, 0);
  std::vector<Id> sets;
  sets.reserve(nearOthers.size());
  for (const Id f : nearOthers)
  {
    sets.push_back(setOf[f]);
  }
  return SearchBetweenSets(FacetComparer(points, facets), nearOthers, sets, monitor);
}

Pairs FindIntersections(const std::vector<Point>& points, const std::vector<Triangle>& facets,
  Id firstNew, Monitor& monitor)
{
  monitor.Check(Stages::FindingIntersections, 0);
  const FacetComparer comparer(points, facets);
  if (firstNew == 0 && facets.size() >= ManyFacets)
  {
    const std::optional<SurfaceParts> parts =
      CutIntoParts(points, facets, monitor, { Stages::FindingIntersections, 0, 0 });
    if (parts)
    {
      return PartSearcher(comparer, *parts).Search(monitor);
    }
  }
  const std::vector<Id> near = FacetsNearNew(points, facets, firstNew);
  std::vector<Id> sets; // the old facets are one, and each new one is another
  sets.reserve(near.size());
  for (const Id f : near)
  {
    sets.push_back(std::max(f + 1 - firstNew, 0));
  }
  return SearchBetweenSets(comparer, near, sets, monitor);
}
} // namespace insideout
