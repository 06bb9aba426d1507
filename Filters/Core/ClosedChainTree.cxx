// SPDX-License-Identifier: GPL-3.0-or-later
#include "ClosedChainTree.h"

#include "ChunkedLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace insideout
{
namespace
{
constexpr std::size_t LeafSize = 8;
constexpr int MostDepth = 60;

// A box with this few facets is not divided when it is much smaller than they are, nor one with any
// number after so many divisions in a row that hardly separated them.
constexpr std::size_t SmallLeafSize = 32;
constexpr int MostFruitlessSplits = 4;

// Where sites are wanted in a few places only, a box with so many of them is not divided.
constexpr std::size_t WantedPerLeaf = 2;

// Facets that cross each other everywhere cannot be kept apart: leaves have at most this many
// facets together, relative to the number of facets.
constexpr double FacetsInLeaves = 16;

// The tree is built in parts of about this part of the facets; the same for any number of threads.
constexpr std::size_t PartsForThreads = 32;

// The empty part of a box is cut off where it is this part of it.
constexpr double WorthwhileGap = 0.2;

// Splits, references and detours stand at crooked places, off the planes that people draw.
constexpr double SplitPlace = 0.4937;
constexpr int MostTries = 64;

/** The j-th of a fixed sequence of places in a box, none near its sides. */
Point PlaceInBox(const Point& low, const Point& high, int j)
{
  // Additive recurrence with the powers of the plastic number, which fills a cube evenly.
  const Point step = { 0.8191725133961645, 0.6710436067037893, 0.5497004779019703 };
  Point place;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = 0.5 + (j + 1) * step[axis];
    const double part = 0.1 + 0.8 * (x - std::floor(x));
    place[axis] = low[axis] + part * (high[axis] - low[axis]);
  }
  return place;
}

/** Sign of a site's coordinate less x. */
int Compare(const RoundedSite& site, int axis, double x)
{
  // Low is below half a unit in the last place of High, so it decides only between equals.
  const double difference = site.High[axis] - x;
  const double decisive = difference != 0 ? difference : site.Low[axis];
  return (decisive > 0) - (decisive < 0);
}

using LongVector = std::array<long double, 3>;

LongVector Normalized(const LongVector& d)
{
  const long double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  return { d[0] / length, d[1] / length, d[2] / length };
}

/** From a site to a point, as a unit vector. */
LongVector Direction(const RoundedSite& site, const Point& point)
{
  LongVector d;
  for (int axis = 0; axis < 3; ++axis)
  {
    d[axis] = (static_cast<long double>(point[axis]) - site.High[axis]) - site.Low[axis];
  }
  return Normalized(d);
}

long double Dot(const LongVector& a, const LongVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Solid angle of the spherical triangle between three directions, over 4 pi. */
double TurnsBetween(const LongVector& a, const LongVector& b, const LongVector& c)
{
  const long double det = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
  const long double div = 1 + Dot(a, b) + Dot(b, c) + Dot(c, a);
  const long double pi = 3.14159265358979323846264338L;
  return static_cast<double>(std::atan2(det, div) / (2 * pi));
}
} // namespace

ClosedChainTree::ClosedChainTree(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
{
  this->BuildAll(points, triangles, monitor, progress);
}

ClosedChainTree::ClosedChainTree(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, const std::vector<Point>& wanted, Monitor& monitor,
  const ProgressRange& progress)
  : Wanted(wanted)
  , WantsAll(false)
{
  this->BuildAll(points, triangles, monitor, progress);
}

void ClosedChainTree::BuildAll(const std::vector<Point>& points,
  const std::vector<CountedTriangle>& triangles, Monitor& monitor, const ProgressRange& progress)
{
  monitor.Check(progress.Stage, progress.Begin);
  const double infinity = std::numeric_limits<double>::infinity();
  Region all = { { infinity, infinity, infinity }, { -infinity, -infinity, -infinity }, { 0, 0, 0 },
    0, {}, 0, 0, FacetsInLeaves * static_cast<double>(triangles.size()), {} };
  all.Wanted.resize(this->Wanted.size());
  std::iota(all.Wanted.begin(), all.Wanted.end(), 0);
  this->Facets.reserve(triangles.size());
  for (const CountedTriangle& triangle : triangles)
  {
    std::array<Point, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = points[triangle.Corners[k]];
    }
    FacetBox box = { corners[0], corners[0] };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const Point& corner : corners)
      {
        box.Low[axis] = std::min(box.Low[axis], corner[axis]);
        box.High[axis] = std::max(box.High[axis], corner[axis]);
      }
      all.Low[axis] = std::min(all.Low[axis], box.Low[axis]);
      all.High[axis] = std::max(all.High[axis], box.High[axis]);
    }
    this->Facets.push_back({ PlaneOfTriangle(corners), corners, triangle.Count });
    this->Boxes.push_back(box);
  }
  if (this->Facets.empty())
  {
    return;
  }
  all.Facets.resize(this->Facets.size());
  std::iota(all.Facets.begin(), all.Facets.end(), 0);
  // Outside the box the winding number is 0.
  const Point below = { 0.3143, 0.4717, 0.5919 };
  for (int axis = 0; axis < 3; ++axis)
  {
    all.Reference[axis] =
      all.Low[axis] - below[axis] * (all.High[axis] - all.Low[axis]) - below[axis] * 0x1p-3;
  }

  std::vector<Job> jobs;
  this->Tree.Nodes.emplace_back();
  this->Build(std::move(all), 0, this->Tree, &jobs);
  std::vector<Arena> arenas(jobs.size());
  const double nanosecondsPerFacet = 3000 / static_cast<double>(PartsForThreads);
  ChunkedLoop(static_cast<Id>(jobs.size()),
    nanosecondsPerFacet * static_cast<double>(this->Facets.size()), monitor, progress,
    [&](Id i)
    {
      arenas[i].Nodes.emplace_back();
      this->Build(std::move(jobs[i].Work), 0, arenas[i], nullptr);
    });
  for (std::size_t i = 0; i < jobs.size(); ++i)
  {
    this->Append(arenas[i], jobs[i].Node);
  }
}

/** Put a tree in the place of a node. */
void ClosedChainTree::Append(const Arena& arena, std::int32_t node)
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
  this->Tree.ReferenceSides.insert(
    this->Tree.ReferenceSides.end(), arena.ReferenceSides.begin(), arena.ReferenceSides.end());
}

/** Cut off an empty side of the box, or else halve its longest side. */
ClosedChainTree::Split ClosedChainTree::ChooseSplit(const Region& region) const
{
  Point low = region.High;
  Point high = region.Low;
  for (const Id f : region.Facets)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], this->Boxes[f].Low[axis]);
      high[axis] = std::max(high[axis], this->Boxes[f].High[axis]);
    }
  }
  Split split = { 0, 0 };
  double largestPart = WorthwhileGap;
  bool cut = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    // A little beside the facets, so that they do not touch the empty box.
    const double extent = region.High[axis] - region.Low[axis];
    const double gapBelow = low[axis] - region.Low[axis];
    const double gapAbove = region.High[axis] - high[axis];
    const double margin = 0.05;
    if (gapBelow > largestPart * extent)
    {
      largestPart = gapBelow / extent;
      split = { axis, low[axis] - margin * gapBelow };
      cut = true;
    }
    if (gapAbove > largestPart * extent)
    {
      largestPart = gapAbove / extent;
      split = { axis, high[axis] + margin * gapAbove };
      cut = true;
    }
  }
  if (!cut)
  {
    for (int axis = 1; axis < 3; ++axis)
    {
      const bool longer =
        region.High[axis] - region.Low[axis] > region.High[split.Axis] - region.Low[split.Axis];
      split.Axis = longer ? axis : split.Axis;
    }
    split.Place =
      region.Low[split.Axis] + SplitPlace * (region.High[split.Axis] - region.Low[split.Axis]);
  }
  return split;
}

bool ClosedChainTree::FitsLeaf(const Region& region) const
{
  if (region.Facets.size() <= LeafSize || region.Depth >= MostDepth ||
    region.FruitlessSplits >= MostFruitlessSplits ||
    (!this->WantsAll && region.Wanted.size() <= WantedPerLeaf))
  {
    return true;
  }
  if (region.Facets.size() > SmallLeafSize)
  {
    return false;
  }
  double boxExtent = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    boxExtent = std::max(boxExtent, region.High[axis] - region.Low[axis]);
  }
  const auto isMuchLarger = [&](Id f)
  {
    double extent = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      extent = std::max(extent, this->Boxes[f].High[axis] - this->Boxes[f].Low[axis]);
    }
    return extent > 4 * boxExtent;
  };
  return std::all_of(region.Facets.begin(), region.Facets.end(), isMuchLarger);
}

/** False only where the facet certainly has no point in the closed box. */
bool ClosedChainTree::MayMeet(Id facet, const Point& low, const Point& high) const
{
  const FacetBox& box = this->Boxes[facet];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.High[axis] < low[axis] || box.Low[axis] > high[axis])
    {
      return false;
    }
  }
  const PlaneOfTriangle& plane = this->Facets[facet].Plane;
  double side = 0;
  double reach = 0;
  double size = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = low[axis] / 2 + high[axis] / 2;
    const double half = high[axis] / 2 - low[axis] / 2;
    side += plane.Normal[axis] * (centre - plane.Origin[axis]);
    reach += std::abs(plane.Normal[axis]) * half;
    size += std::abs(centre - plane.Origin[axis]) + half;
  }
  // Coordinates are below 1, so that an absolute error of 2^-50 covers the rounding of the box's.
  return std::abs(side) <= reach + 4 * plane.UndecidedSide * (size + 0x1p-2);
}

/** Those whose bounding box meets that of a line. */
std::vector<Id> ClosedChainTree::FacetsBetween(
  const std::vector<Id>& facets, const Point& a, const Point& b) const
{
  Point low;
  Point high;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::tie(low[axis], high[axis]) = std::minmax(a[axis], b[axis]);
  }
  std::vector<Id> between;
  for (const Id f : facets)
  {
    const FacetBox& box = this->Boxes[f];
    if (box.Low[0] <= high[0] && box.High[0] >= low[0] && box.Low[1] <= high[1] &&
      box.High[1] >= low[1] && box.Low[2] <= high[2] && box.High[2] >= low[2])
    {
      between.push_back(f);
    }
  }
  return between;
}

/** Find a place in the child's box where the winding number can be told from the parent's. */
bool ClosedChainTree::FindReference(const Region& parent, Region& child, int axis) const
{
  bool inherits = true;
  bool isBeside = true; // in the parent's box, so that only one coordinate has to change
  for (int i = 0; i < 3; ++i)
  {
    inherits =
      inherits && parent.Reference[i] >= child.Low[i] && parent.Reference[i] <= child.High[i];
    isBeside =
      isBeside && parent.Reference[i] >= parent.Low[i] && parent.Reference[i] <= parent.High[i];
  }
  child.Reference = parent.Reference;
  child.Value = parent.Value;
  if (inherits)
  {
    return true;
  }
  for (int j = 0; j < MostTries; ++j)
  {
    Point place = PlaceInBox(child.Low, child.High, j);
    if (isBeside && j == 0)
    {
      const double x = place[axis];
      place = parent.Reference;
      place[axis] = x;
    }
    double crossings = 0;
    const std::vector<Id> between = this->FacetsBetween(parent.Facets, place, parent.Reference);
    const FacetRange range = { between.data(), between.data() + between.size(), nullptr };
    if (this->CountCrossings(
          range, PreparedSite(SiteAt(place)), parent.Reference, nullptr, crossings))
    {
      child.Reference = place;
      child.Value = parent.Value + crossings;
      return true;
    }
  }
  return false;
}

bool ClosedChainTree::Divide(
  const Region& region, Split& split, std::array<Region, 2>& children) const
{
  split = this->ChooseSplit(region);
  if (!(split.Place > region.Low[split.Axis] && split.Place < region.High[split.Axis]))
  {
    return false;
  }
  double work = 0;
  for (int side = 0; side < 2; ++side)
  {
    Region& child = children[side];
    child.Low = region.Low;
    child.High = region.High;
    (side == 0 ? child.High : child.Low)[split.Axis] = split.Place;
    child.Depth = region.Depth + 1;
    for (const Id f : region.Facets)
    {
      if (this->MayMeet(f, child.Low, child.High))
      {
        child.Facets.push_back(f);
      }
    }
    for (const Id i : region.Wanted)
    {
      const double x = this->Wanted[i][split.Axis];
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
      ((child.High[split.Axis] - child.Low[split.Axis]) /
        (region.High[split.Axis] - region.Low[split.Axis]));
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

void ClosedChainTree::AddLeaf(const Region& region, std::int32_t node, Arena& arena) const
{
  arena.Nodes[node] = { 0, -1, { { static_cast<std::int32_t>(arena.Leaves.size()), 0 } } };
  const std::size_t first = arena.LeafFacets.size();
  const bool isWanted = this->WantsAll || !region.Wanted.empty();
  for (std::size_t i = 0; isWanted && i < region.Facets.size(); ++i)
  {
    const Id f = region.Facets[i];
    arena.LeafFacets.push_back(f);
    arena.ReferenceSides.push_back(static_cast<std::int8_t>(
      SideOfPlane(this->Facets[f].Plane, this->Facets[f].Corners, region.Reference)));
  }
  const double value = isWanted ? region.Value : std::numeric_limits<double>::quiet_NaN();
  arena.Leaves.push_back(
    { region.Low, region.High, region.Reference, value, first, arena.LeafFacets.size() });
}

void ClosedChainTree::Build(
  Region region, std::int32_t node, Arena& arena, std::vector<Job>* jobs) const
{
  if (jobs && region.Depth > 0 && region.Facets.size() < this->Facets.size() / PartsForThreads)
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
  this->Build(std::move(children[0]), firstChild, arena, jobs);
  this->Build(std::move(children[1]), firstChild + 1, arena, jobs);
}

const ClosedChainTree::Leaf& ClosedChainTree::LeafOf(const RoundedSite& site) const
{
  const Node* node = this->Tree.Nodes.data();
  while (node->Axis >= 0)
  {
    const bool above = Compare(site, node->Axis, node->Split) > 0;
    node = this->Tree.Nodes.data() + node->Children[above ? 1 : 0];
  }
  return this->Tree.Leaves[node->Children[0]];
}

/**
 * Add by how much the winding number at `from` differs from that at `to`, because of facets between
 * them. Facets that `from` lies on are put into `touched` and not counted.
 *
 * @return whether the line between them shows it: false where it meets an edge or lies in a plane,
 * where `to` lies on a facet, or where `from` does and that is not asked for
 */
bool ClosedChainTree::CountCrossings(const FacetRange& facets, const PreparedSite& from,
  const Point& to, std::vector<Id>* touched, double& sum) const
{
  for (const Id* f = facets.First; f != facets.Last; ++f)
  {
    const Facet& facet = this->Facets[*f];
    const int fromSide = SideOfPlane(facet.Plane, facet.Corners, from);
    const int toSide =
      facets.Sides ? facets.Sides[f - facets.First] : SideOfPlane(facet.Plane, facet.Corners, to);
    if (fromSide * toSide > 0)
    {
      continue;
    }
    if (fromSide == 0)
    {
      const bool touches = IsInTriangle(facet.Corners, from.Exact);
      if (toSide == 0 || (touches && !touched))
      {
        return false;
      }
      if (touches)
      {
        touched->push_back(*f);
      }
      continue;
    }
    if (toSide == 0)
    {
      if (IsInTriangle(facet.Corners, SiteAt(to)))
      {
        return false;
      }
      continue;
    }
    int least = 2;
    int most = -2;
    for (int k = 0; k < 3 && !(least < 0 && most > 0); ++k)
    {
      const int sign = SignOfDeterminant(from, to, facet.Corners[k], facet.Corners[(k + 1) % 3]);
      least = std::min(least, sign);
      most = std::max(most, sign);
    }
    if (least * most < 0)
    {
      continue;
    }
    if (least * most == 0)
    {
      return false;
    }
    sum += toSide > 0 ? facet.Count : -facet.Count;
  }
  return true;
}

/**
 * The winding number of the facets that the site touches, at a place next to it in some direction:
 * the sum of the infinite wedges that these look like from there.
 */
double ClosedChainTree::AngleOfTouched(
  const std::vector<Id>& touched, const PreparedSite& site, const Point& towards) const
{
  LongVector back = Direction(site, towards);
  for (long double& x : back)
  {
    x = -x;
  }
  double sum = 0;
  for (const Id f : touched)
  {
    const Facet& facet = this->Facets[f];
    int edges = 0;
    double turns = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Point& a = facet.Corners[k];
      const Point& b = facet.Corners[(k + 1) % 3];
      if (!IsOnLine(a, b, site.Exact))
      {
        ++edges;
        turns += TurnsBetween(back, Direction(site, a), Direction(site, b));
      }
    }
    if (edges == 3)
    {
      // Within the triangle: half a sphere, whatever rounding says.
      turns = SideOfPlane(facet.Plane, facet.Corners, towards) < 0 ? 0.5 : -0.5;
    }
    sum += facet.Count * turns;
  }
  return sum;
}

double ClosedChainTree::AtInLeaf(const Leaf& leaf, const PreparedSite& site) const
{
  const Id* const first = this->Tree.LeafFacets.data() + leaf.FirstFacet;
  const Id* const last = this->Tree.LeafFacets.data() + leaf.LastFacet;
  const FacetRange towardsReference = { first, last,
    this->Tree.ReferenceSides.data() + leaf.FirstFacet };
  const FacetRange towardsDetour = { first, last, nullptr };
  std::vector<Id> touched;
  double crossings = 0;
  Point towards = leaf.Reference;
  bool counted = this->CountCrossings(towardsReference, site, towards, &touched, crossings);
  for (int j = 0; !counted && j < MostTries; ++j)
  {
    touched.clear();
    crossings = 0;
    towards = PlaceInBox(leaf.Low, leaf.High, j);
    counted = this->CountCrossings(towardsDetour, site, towards, &touched, crossings) &&
      this->CountCrossings(
        towardsReference, PreparedSite(SiteAt(towards)), leaf.Reference, nullptr, crossings);
  }
  if (!counted)
  {
    throw Error(ErrorCode::Inconsistent,
      "no way from a site to its box's reference avoids the edges of all facets");
  }
  const double ofTouched = touched.empty() ? 0 : this->AngleOfTouched(touched, site, towards);
  return leaf.Value + crossings - ofTouched;
}

double ClosedChainTree::At(const Site& site) const
{
  if (this->Facets.empty())
  {
    return 0;
  }
  const RoundedSite rounded(site);
  const Leaf& leaf = this->LeafOf(rounded);
  for (int axis = 0; axis < 3; ++axis)
  {
    if (Compare(rounded, axis, leaf.Low[axis]) < 0 || Compare(rounded, axis, leaf.High[axis]) > 0)
    {
      return 0; // beyond the box of the whole chain
    }
  }
  return leaf.FirstFacet == leaf.LastFacet ? leaf.Value : this->AtInLeaf(leaf, PreparedSite(site));
}

void ClosedChainTree::Evaluate(const Sites& sites, const std::vector<Id>& order,
  std::vector<double>& w, Monitor& monitor, const ProgressRange& progress) const
{
  const std::size_t sitesPerCall = 256;
  const Id calls = static_cast<Id>((order.size() + sitesPerCall - 1) / sitesPerCall);
  const double nanosecondsPerSite = 500;
  ChunkedLoop(calls, nanosecondsPerSite * sitesPerCall, monitor, progress,
    [&](Id call)
    {
      const std::size_t first = static_cast<std::size_t>(call) * sitesPerCall;
      for (std::size_t i = first; i < std::min(order.size(), first + sitesPerCall); ++i)
      {
        w[order[i]] = this->At(sites[order[i]]);
      }
    });
}
} // namespace insideout
