// SPDX-License-Identifier: GPL-3.0-or-later
#include "Resolve/FindIntersections.h"

#include "Common/BoxTree.h"
#include "Common/ParallelLoop.h"
#include "Common/Stages.h"
#include "Resolve/FacetsNearOthers.h"
#include "Resolve/MeetBeyondSharedCorners.h"
#include "Resolve/OrientedBoxTree.h"
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

/**
 * From this number of pairs of boxes per facet on, as among needles, an OrientedBoxTree pays off:
 * 52 pairs take equally long. They are counted in one of PerSample tasks, if there are enough
 * facets.
 */
constexpr double ManyPairsPerFacet = 64;
constexpr std::size_t PerSample = 61; // not the size of a subtree
constexpr std::size_t LeastForSample = 1024;

/** Tasks of a search among needles, whose costs differ. */
constexpr std::size_t ManyTasks = 4096;

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

  OrientedBoxTree OrientedTreeOf(const std::vector<Id>& facets, const std::vector<Id>& sets) const
  {
    std::vector<Triangle> corners;
    corners.reserve(facets.size());
    for (const Id f : facets)
    {
      corners.push_back(this->Facets[f]);
    }
    return { this->Points, corners, sets };
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

/**
 * Whether a sample has more than ManyPairsPerFacet pairs of boxes.
 * @param[in] visitPairs visitPairs(i, visit) visits the pairs of boxes of task i
 */
template <class VisitPairs>
bool MeetOften(std::size_t facets, std::size_t tasks, const VisitPairs& visitPairs)
{
  double pairs = 0;
  double samples = 0;
  for (std::size_t i = 0; facets >= LeastForSample && i < tasks; i += PerSample)
  {
    visitPairs(static_cast<Id>(i), [&](Id, Id) { ++pairs; });
    ++samples;
  }
  return pairs * static_cast<double>(tasks) >
    ManyPairsPerFacet * static_cast<double>(facets) * samples;
}

/** The same as SearchBetweenSets, among needles. */
Pairs SearchNeedles(const FacetComparer& comparer, const std::vector<Id>& facets,
  const std::vector<Id>& sets, Monitor& monitor)
{
  const OrientedBoxTree tree = comparer.OrientedTreeOf(facets, sets);
  const std::vector<OrientedBoxTree::Task> tasks = tree.Tasks(ManyTasks);
  return Collect(static_cast<Id>(tasks.size()), NanosecondsPerFacet * BlockSize, monitor,
    [&](Id task, Pairs& pairs)
    {
      tree.VisitPairs(
        tasks[task], [&](Id a, Id b) { comparer.Compare(facets[a], facets[b], pairs); });
    });
}

/** Search some facets for pairs of different sets. @param[in] sets one per facet of these */
Pairs SearchBetweenSets(const FacetComparer& comparer, const std::vector<Id>& facets,
  const std::vector<Id>& sets, Monitor& monitor)
{
  const BoxTree tree(comparer.BoxesOf(facets));
  const std::vector<Id> setsOfParts = tree.SetsOfParts(sets);
  const auto visitPairs = [&](Id part, const auto& visit)
  { tree.VisitPairsBetween(part, sets, setsOfParts, visit); };
  if (MeetOften(facets.size(), tree.NumberOfParts(), visitPairs))
  {
    return SearchNeedles(comparer, facets, sets, monitor);
  }
  const Id blocks = (tree.NumberOfParts() + BlockSize - 1) / BlockSize;
  return Collect(blocks, NanosecondsPerFacet * BlockSize, monitor,
    [&](Id block, Pairs& pairs)
    {
      const Id begin = block * BlockSize;
      for (Id part = begin; part < std::min(begin + BlockSize, tree.NumberOfParts()); ++part)
      {
        visitPairs(part, [&](Id a, Id b) { comparer.Compare(facets[a], facets[b], pairs); });
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
    const auto visitPairs = [&](Id i, const auto& visit) { this->Visit(meeting[i], visit); };
    if (MeetOften(this->Surface.Facets.size(), meeting.size(), visitPairs))
    {
      return SearchNeedles(this->Comparer, this->Surface.Facets, this->Sets(), monitor);
    }
    const double facets = static_cast<double>(this->Surface.Facets.size());
    return Collect(static_cast<Id>(meeting.size()),
      NanosecondsPerFacet * facets / static_cast<double>(meeting.size() + 1), monitor,
      [&](Id i, Pairs& pairs)
      { visitPairs(i, [&](Id a, Id b) { this->Comparer.Compare(a, b, pairs); }); });
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

  /** Call visit(i, j) for facets i and j of a part whose boxes meet. */
  template <class Visitor>
  void VisitWithin(const SurfacePart& part, const Visitor& visit) const
  {
    Some all;
    for (Id i = part.Begin; i < part.End; ++i)
    {
      all.Add(this->Surface.Facets[i], this->Comparer.BoxOf(this->Surface.Facets[i]));
    }
    const BoxTree tree(all.Boxes);
    for (Id node = 0; node < tree.NumberOfParts(); ++node)
    {
      tree.VisitPairs(node, [&](Id i, Id j) { visit(all.Facets[i], all.Facets[j]); });
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

  /** The same for facets of two parts. */
  template <class Visitor>
  void VisitBetween(Id a, Id b, const Visitor& visit) const
  {
    const Some first = this->Within(a, this->BoxesOfParts[b]);
    const Some second = this->Within(b, first.Bounds);
    if (first.Facets.size() * second.Facets.size() > ManyPairs)
    {
      const BoxTree tree(first.Boxes);
      for (std::size_t j = 0; j < second.Facets.size(); ++j)
      {
        tree.Visit(second.Boxes[j], [&](Id i) { visit(first.Facets[i], second.Facets[j]); });
      }
      return;
    }
    for (std::size_t i = 0; i < first.Facets.size(); ++i)
    {
      for (std::size_t j = 0; j < second.Facets.size(); ++j)
      {
        if (first.Boxes[i].Meets(second.Boxes[j]))
        {
          visit(first.Facets[i], second.Facets[j]);
        }
      }
    }
  }

  /** The same for two parts, or twice the same. */
  template <class Visitor>
  void Visit(const std::array<Id, 2>& parts, const Visitor& visit) const
  {
    if (parts[0] == parts[1])
    {
      this->VisitWithin(this->Surface.Parts[parts[0]], visit);
    }
    else
    {
      this->VisitBetween(parts[0], parts[1], visit);
    }
  }

  /** Per facet of the surface a set: that of its terrain, or its own. */
  std::vector<Id> Sets() const
  {
    std::vector<Id> sets(this->Surface.Facets.size());
    for (const SurfacePart& part : this->Surface.Parts)
    {
      for (Id i = part.Begin; i < part.End; ++i)
      {
        sets[i] = part.IsTerrain ? part.Begin : i;
      }
    }
    return sets;
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
