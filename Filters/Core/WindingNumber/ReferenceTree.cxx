// SPDX-License-Identifier: GPL-3.0-or-later
#include "WindingNumber/ReferenceTree.h"

#include "Common/ChunkedLoop.h"
#include "WindingNumber/PlaceInBox.h"

#include <algorithm>
#include <limits>

namespace insideout
{
namespace
{
constexpr std::size_t LeafSize = 32;
constexpr int MostDepth = 60;

// A box with at most SmallLeafSize facets is not divided if it is much smaller than they are. No
// box is divided after MostFruitlessSplits divisions in a row that hardly separated its facets.
constexpr std::size_t SmallLeafSize = 64;
constexpr int MostFruitlessSplits = 4;

// With few wanted sites, a box with at most this many of them is not divided.
constexpr std::size_t WantedPerLeaf = 2;

// Facets that all cross each other cannot be separated: this limits the facets of all leaves
// together, relative to the number of facets.
constexpr double FacetsInLeaves = 16;

// A tree of at least FacetsForThreads facets is built as jobs, each with less than 1 /
// PartsForThreads of them; the jobs are the same for any number of threads.
constexpr std::size_t FacetsForThreads = 4096;
constexpr std::size_t PartsForThreads = 32;

// The empty part of a box is cut off if it is at least this fraction of the box.
constexpr double WorthwhileGap = 0.2;

// Splits are at irregular coordinates, off the planes that people draw.
constexpr double SplitPlace = 0.4937;

// Places tried for a reference. A place fails only if the line to it meets an edge exactly.
constexpr int MostTries = 64;

/** Sign of a site's coordinate less x. */
int Compare(const RoundedSite& site, int axis, double x)
{
  // Low is below half a unit in the last place of High, so it decides only between equals.
  const double difference = site.High[axis] - x;
  const double decisive = difference != 0 ? difference : site.Low[axis];
  return (decisive > 0) - (decisive < 0);
}
} // namespace

class ReferenceTree::Builder
{
public:
  Builder(const ChainFacets& facets, const std::vector<Point>* wanted)
    : Facets(facets)
    , Wanted(wanted)
  {
  }

  /** Build a region's tree from a node on; if `jobs` is given, small subtrees become jobs. */
  void Build(Region region, std::int32_t node, Arena& arena, std::vector<Job>* jobs,
    std::size_t sizeOfJobs) const;

private:
  Split ChooseSplit(const Region& region) const;
  bool FitsLeaf(const Region& region) const;
  std::vector<SidedFacet> FacetsBetween(
    const std::vector<Id>& facets, const Point& a, const Point& b) const;
  bool FindReference(const Region& parent, Region& child, int axis) const;
  bool Divide(const Region& region, Split& split, std::array<Region, 2>& children) const;
  void AddLeaf(const Region& region, std::int32_t node, Arena& arena) const;

  const ChainFacets& Facets;
  const std::vector<Point>* Wanted;
};

ReferenceTree::ReferenceTree(const ChainFacets& facets, const std::vector<Point>* wanted,
  Region region, Monitor& monitor, const ProgressRange& progress)
{
  const Builder builder(facets, wanted);
  const std::size_t size = region.Facets.size();
  region.Budget = FacetsInLeaves * static_cast<double>(size);
  this->Tree.Nodes.emplace_back();
  if (size < FacetsForThreads)
  {
    builder.Build(std::move(region), 0, this->Tree, nullptr, 0);
    return;
  }
  std::vector<Job> jobs;
  builder.Build(std::move(region), 0, this->Tree, &jobs, size / PartsForThreads);
  std::vector<Arena> arenas(jobs.size());
  const double nanosecondsPerFacet = 3000 / static_cast<double>(PartsForThreads);
  ChunkedLoop(static_cast<Id>(jobs.size()), nanosecondsPerFacet * static_cast<double>(size),
    monitor, progress,
    [&](Id i)
    {
      arenas[i].Nodes.emplace_back();
      builder.Build(std::move(jobs[i].Work), 0, arenas[i], nullptr, 0);
    });
  for (std::size_t i = 0; i < jobs.size(); ++i)
  {
    this->Append(arenas[i], jobs[i].Node);
  }
}

/** Replace a node by a tree. */
void ReferenceTree::Append(const Arena& arena, std::int32_t node)
{
  const std::int32_t nodes = static_cast<std::int32_t>(this->Tree.Nodes.size()) - 1;
  const std::int32_t leaves = static_cast<std::int32_t>(this->Tree.Leaves.size());
  const std::size_t facets = this->Tree.LeafFacets.size();
  for (std::size_t i = 0; i < arena.Nodes.size(); ++i)
  {
    Node moved = arena.Nodes[i];
    for (std::int32_t& child : moved.Children)
    {
      child += moved.Axis < 0 ? leaves : nodes;
    }
    if (i == 0)
    {
      this->Tree.Nodes[node] = moved;
    }
    else
    {
      this->Tree.Nodes.push_back(moved);
    }
  }
  for (Leaf leaf : arena.Leaves)
  {
    leaf.FirstFacet += facets;
    leaf.LastFacet += facets;
    this->Tree.Leaves.push_back(leaf);
  }
  this->Tree.LeafFacets.insert(
    this->Tree.LeafFacets.end(), arena.LeafFacets.begin(), arena.LeafFacets.end());
}

/** Cut off an empty side of the box, or halve its longest side. */
ReferenceTree::Split ReferenceTree::Builder::ChooseSplit(const Region& region) const
{
  Box filled = { region.Bounds.High, region.Bounds.Low };
  for (const Id f : region.Facets)
  {
    filled.Add(this->Facets.BoxOf(f));
  }
  Split split = { region.Bounds.LongestAxis(), 0 };
  double largestPart = WorthwhileGap;
  bool cut = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Slightly beside the facets, so that they do not touch the empty box.
    const double extent = region.Bounds.Extent(axis);
    const double gapBelow = filled.Low[axis] - region.Bounds.Low[axis];
    const double gapAbove = region.Bounds.High[axis] - filled.High[axis];
    const double margin = 0.05;
    if (gapBelow > largestPart * extent)
    {
      largestPart = gapBelow / extent;
      split = { axis, filled.Low[axis] - margin * gapBelow };
      cut = true;
    }
    if (gapAbove > largestPart * extent)
    {
      largestPart = gapAbove / extent;
      split = { axis, filled.High[axis] + margin * gapAbove };
      cut = true;
    }
  }
  if (!cut)
  {
    split.Place = region.Bounds.Low[split.Axis] + SplitPlace * region.Bounds.Extent(split.Axis);
  }
  return split;
}

bool ReferenceTree::Builder::FitsLeaf(const Region& region) const
{
  if (region.Facets.size() <= LeafSize || region.Depth >= MostDepth ||
    region.FruitlessSplits >= MostFruitlessSplits ||
    (this->Wanted && region.Wanted.size() <= WantedPerLeaf))
  {
    return true;
  }
  if (region.Facets.size() > SmallLeafSize)
  {
    return false;
  }
  const double extent = region.Bounds.Extent(region.Bounds.LongestAxis());
  const auto isMuchLarger = [&](Id f)
  {
    const Box box = this->Facets.BoxOf(f);
    return box.Extent(box.LongestAxis()) > 4 * extent;
  };
  return std::all_of(region.Facets.begin(), region.Facets.end(), isMuchLarger);
}

/** The facets whose bounding box meets that of a line, each with its side at b. */
std::vector<SidedFacet> ReferenceTree::Builder::FacetsBetween(
  const std::vector<Id>& facets, const Point& a, const Point& b) const
{
  Box line = { a, a };
  line.Add(b);
  std::vector<SidedFacet> between;
  for (const Id f : facets)
  {
    if (this->Facets.BoxOf(f).Meets(line))
    {
      between.emplace_back(f, this->Facets.SideOf(f, b));
    }
  }
  return between;
}

/** Find a place in the child's box at which the winding number can be derived from the parent's. */
bool ReferenceTree::Builder::FindReference(const Region& parent, Region& child, int axis) const
{
  child.Reference = parent.Reference;
  child.Value = parent.Value;
  if (child.Bounds.Holds(parent.Reference))
  {
    return true;
  }
  // In the parent's box only one coordinate has to change.
  const bool isBeside = parent.Bounds.Holds(parent.Reference);
  for (int j = 0; j < MostTries; ++j)
  {
    Point place = PlaceInBox(child.Bounds.Low, child.Bounds.High, j);
    if (isBeside && j == 0)
    {
      const double x = place[axis];
      place = parent.Reference;
      place[axis] = x;
    }
    double crossings = 0;
    const std::vector<SidedFacet> between =
      this->FacetsBetween(parent.Facets, place, parent.Reference);
    if (this->Facets.CountCrossings(between.data(), between.data() + between.size(),
          PreparedSite(SiteAt(place)), parent.Reference, nullptr, crossings))
    {
      child.Reference = place;
      child.Value = parent.Value + crossings;
      return true;
    }
  }
  return false;
}

bool ReferenceTree::Builder::Divide(
  const Region& region, Split& split, std::array<Region, 2>& children) const
{
  split = this->ChooseSplit(region);
  if (!(split.Place > region.Bounds.Low[split.Axis] &&
        split.Place < region.Bounds.High[split.Axis]))
  {
    return false;
  }
  double work = 0;
  for (int side = 0; side < 2; ++side)
  {
    Region& child = children[side];
    child.Bounds = region.Bounds;
    (side == 0 ? child.Bounds.High : child.Bounds.Low)[split.Axis] = split.Place;
    child.Depth = region.Depth + 1;
    for (const Id f : region.Facets)
    {
      if (this->Facets.MayMeet(f, child.Bounds))
      {
        child.Facets.push_back(f);
      }
    }
    for (const Id i : region.Wanted)
    {
      const double x = (*this->Wanted)[i][split.Axis];
      if (side == 0 ? x <= split.Place : x >= split.Place)
      {
        child.Wanted.push_back(i);
      }
    }
    if (!this->FindReference(region, child, split.Axis))
    {
      return false;
    }
    work += static_cast<double>(child.Facets.size()) *
      (child.Bounds.Extent(split.Axis) / region.Bounds.Extent(split.Axis));
  }
  const bool fruitless = work > 0.9 * static_cast<double>(region.Facets.size());
  const double facets = static_cast<double>(children[0].Facets.size() + children[1].Facets.size());
  for (Region& child : children)
  {
    child.FruitlessSplits = fruitless ? region.FruitlessSplits + 1 : 0;
    child.Budget = region.Budget * static_cast<double>(child.Facets.size()) / facets;
  }
  return facets <= region.Budget;
}

void ReferenceTree::Builder::AddLeaf(const Region& region, std::int32_t node, Arena& arena) const
{
  arena.Nodes[node] = { 0, -1, { { static_cast<std::int32_t>(arena.Leaves.size()), 0 } } };
  const std::size_t first = arena.LeafFacets.size();
  const bool isWanted = !this->Wanted || !region.Wanted.empty();
  for (std::size_t i = 0; isWanted && i < region.Facets.size(); ++i)
  {
    const Id f = region.Facets[i];
    arena.LeafFacets.emplace_back(f, this->Facets.SideOf(f, region.Reference));
  }
  const double value = isWanted ? region.Value : std::numeric_limits<double>::quiet_NaN();
  arena.Leaves.push_back(
    { region.Bounds, region.Reference, value, first, arena.LeafFacets.size() });
}

void ReferenceTree::Builder::Build(Region region, std::int32_t node, Arena& arena,
  std::vector<Job>* jobs, std::size_t sizeOfJobs) const
{
  if (jobs && region.Depth > 0 && region.Facets.size() < sizeOfJobs)
  {
    jobs->push_back({ node, std::move(region) });
    return;
  }
  Split split;
  std::array<Region, 2> children;
  if (this->FitsLeaf(region) || !this->Divide(region, split, children))
  {
    this->AddLeaf(region, node, arena);
    return;
  }
  const std::int32_t firstChild = static_cast<std::int32_t>(arena.Nodes.size());
  arena.Nodes.resize(arena.Nodes.size() + 2);
  arena.Nodes[node] = { split.Place, split.Axis, { { firstChild, firstChild + 1 } } };
  region.Facets = {};
  this->Build(std::move(children[0]), firstChild, arena, jobs, sizeOfJobs);
  this->Build(std::move(children[1]), firstChild + 1, arena, jobs, sizeOfJobs);
}

KnownBox ReferenceTree::At(const RoundedSite& site) const
{
  const Node* node = this->Tree.Nodes.data();
  while (node->Axis >= 0)
  {
    const bool above = Compare(site, node->Axis, node->Split) > 0;
    node = this->Tree.Nodes.data() + node->Children[above ? 1 : 0];
  }
  const Leaf& leaf = this->Tree.Leaves[node->Children[0]];
  const SidedFacet* const facets = this->Tree.LeafFacets.data();
  return { leaf.Bounds, leaf.Reference, leaf.Value, facets + leaf.FirstFacet,
    facets + leaf.LastFacet };
}
} // namespace insideout
